# Installation: libraries, headers, CMake package, program, cases and Python package.
include(CMakePackageConfigHelpers)

# Headers of the libraries that those of include/orbearing need, directly or through one another, as paths from the
# root: structures of machines and results. They are installed in a folder of their own.
function(orbearing_headers_behind_interface result)
  file(GLOB waiting CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/include/orbearing/*.hpp")
  set(found "")
  while(waiting)
    list(POP_FRONT waiting header)
    file(STRINGS "${header}" lines REGEX "^#include \"")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^#include \"([^\"]*)\".*" "\\1" included "${line}")
      if(included MATCHES "^(mechanics|gearset|bearing|coupling)/" AND NOT included IN_LIST found)
        list(APPEND found "${included}")
        list(APPEND waiting "${PROJECT_SOURCE_DIR}/${included}")
      endif()
    endforeach()
  endwhile()
  set(${result} "${found}" PARENT_SCOPE)
endfunction()

set(orbearing_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/Orbearing")
set(orbearing_data_dir "${CMAKE_INSTALL_DATADIR}/orbearing")

if(TARGET orbearing_library)
  install(TARGETS orbearing_library EXPORT OrbearingTargets LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}")
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/orbearing" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
  orbearing_headers_behind_interface(headers)
  foreach(header IN LISTS headers)
    get_filename_component(folder "${header}" DIRECTORY)
    install(FILES "${PROJECT_SOURCE_DIR}/${header}"
            DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/orbearing/library/${folder}")
  endforeach()
  install(EXPORT OrbearingTargets NAMESPACE orbearing:: DESTINATION "${orbearing_package_dir}")
  configure_package_config_file(
    "${CMAKE_CURRENT_LIST_DIR}/OrbearingConfig.cmake.in" "${PROJECT_BINARY_DIR}/OrbearingConfig.cmake"
    INSTALL_DESTINATION "${orbearing_package_dir}")
  write_basic_package_version_file("${PROJECT_BINARY_DIR}/OrbearingConfigVersion.cmake"
    COMPATIBILITY SameMajorVersion)
  install(FILES "${PROJECT_BINARY_DIR}/OrbearingConfig.cmake"
                "${PROJECT_BINARY_DIR}/OrbearingConfigVersion.cmake"
          DESTINATION "${orbearing_package_dir}")
endif()

if(TARGET orbearing)
  install(TARGETS orbearing RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
  if(TARGET orbearing_page_server)
    install(TARGETS orbearing_page_server LIBRARY DESTINATION lib/orbearing)
  endif()
  # Beside bin, where the command fmu looks for them. An installation has nothing to build the one for Windows with.
  set(build_win64 "${PROJECT_BINARY_DIR}/lib/orbearing/fmu/build_win64")
  if(EXISTS "${build_win64}")
    set(build_or_warn "execute_process(COMMAND [[${build_win64}]] OUTPUT_VARIABLE reason RESULT_VARIABLE failed)
if(failed)
  message(WARNING \"FMUs of this installation are for Linux alone: \${reason}\")
endif()")
    install(CODE "${build_or_warn}")
    install(CODE "${build_or_warn}" COMPONENT wheel EXCLUDE_FROM_ALL)
  endif()
  install(DIRECTORY "${PROJECT_BINARY_DIR}/lib/orbearing/fmu" DESTINATION lib/orbearing
          FILES_MATCHING PATTERN "orbearing.so" PATTERN "orbearing.dll")
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/cases" DESTINATION "${orbearing_data_dir}")
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/page/web/" DESTINATION "${orbearing_data_dir}/page")
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/python/orbearing" DESTINATION "${orbearing_data_dir}/python"
          FILES_MATCHING PATTERN "*.py" PATTERN "*.css" PATTERN "*.js" PATTERN "*.mplstyle")
endif()
if(TARGET orbearing_library)
  # A wheel holds all that is needed within the package; pyproject.toml asks for this component alone.
  install(FILES "$<TARGET_FILE:orbearing_library>" DESTINATION orbearing/lib RENAME liborbearing.so
          COMPONENT wheel EXCLUDE_FROM_ALL)
  install(DIRECTORY "${PROJECT_BINARY_DIR}/lib/orbearing/fmu" DESTINATION orbearing/lib/orbearing
          COMPONENT wheel EXCLUDE_FROM_ALL FILES_MATCHING PATTERN "orbearing.so" PATTERN "orbearing.dll")
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/cases" DESTINATION orbearing/share/orbearing
          COMPONENT wheel EXCLUDE_FROM_ALL)
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/page/web/" DESTINATION orbearing/share/orbearing/page
          COMPONENT wheel EXCLUDE_FROM_ALL)
endif()
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/REFERENCES.md"
        DESTINATION "${CMAKE_INSTALL_DOCDIR}")
