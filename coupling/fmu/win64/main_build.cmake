# Included by the main build: what builds the Windows library of our FMUs when `fmu --windows` first needs it. Few who
# build the program do, and it costs as much as the bearing.
string(COMPARE EQUAL "${CMAKE_BUILD_TYPE}" Release optimised)
option(ORBEARING_BUILD_WIN64 "Let fmu --windows build the Windows library that goes into FMUs" ${optimised})
set(recipe "${ORBEARING_FMU_LIBRARIES}/build_win64")
if(NOT ORBEARING_BUILD_WIN64)
  file(REMOVE "${recipe}")
  return()
endif()

# Sources of target orbearing_<folder> with full paths, but for those that match `unused`.
function(orbearing_win64_sources folder unused)
  get_target_property(sources orbearing_${folder} SOURCES)
  list(TRANSFORM sources REPLACE "^${PROJECT_SOURCE_DIR}/${folder}/" "")
  list(FILTER sources EXCLUDE REGEX "${unused}")
  list(TRANSFORM sources PREPEND "${PROJECT_SOURCE_DIR}/${folder}/")
  set(ORBEARING_SOURCES ${ORBEARING_SOURCES} ${sources} PARENT_SCOPE)
endfunction()

# Whole folders that neither machine uses are left out, to save time; what is missing by mistake shows at the
# link. AVX is left out since GCC does not align the stack of Windows for it (GCC bug 54412).
orbearing_win64_sources(gearset
  "^(drivetrain/|rim/|mesh/[^lp]|mesh/loaded/[^t]|mesh/loaded/tooth|mesh/planetary|dynamics/(modes|mode_kind|bodies|energy)|tooth_|planet_body|contact_path|working_geometry|gear_pair|mean_loads|assembly|involute|planet_pair|stated_geometry)")
orbearing_win64_sources(mechanics "^$")
orbearing_win64_sources(bearing
  "^pressure/|^catalogue/|^mounted_clearance|^pin_beam|^defect/|^duplex/|^film/|^equilibrium/(balls|jones_balls|planet_on_pin|rollers|row_group|static_bearing|lamina_stiffness|equilibrium_|aligned_|inclined_)|^life/(ball|bearing|life|rating|standard|inclined)_|^friction/|_avx[0-9]+\\.cpp$|^motion/balls/|^contact/ellipse_")
orbearing_win64_sources(coupling "^(diagnosis/|cosim/|system/([^bd]|ball)|integration/integrate_switches)")
set(interface ${ORBEARING_FMU_INTERFACE})
list(TRANSFORM interface PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/")
list(APPEND ORBEARING_SOURCES ${ORBEARING_FMU_CORE} ${interface})
set(model_file "${CMAKE_CURRENT_SOURCE_DIR}/model_file.cpp")
set(packs ${ORBEARING_SOURCES})
list(FILTER packs INCLUDE REGEX "_baseline\\.cpp$")

set(views "")
foreach(folder IN ITEMS mechanics gearset bearing coupling)
  list(APPEND views "${PROJECT_BINARY_DIR}/view/${folder}")
endforeach()
get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
list(GET eigen 0 eigen)
set(list_file "${CMAKE_CURRENT_BINARY_DIR}/win64_sources.cmake")
file(CONFIGURE OUTPUT "${list_file}" @ONLY CONTENT
"set(ORBEARING_WIN64_SOURCES @ORBEARING_SOURCES@)
set(ORBEARING_WIN64_PACKS @packs@)
set(ORBEARING_WIN64_ALONE @interface@ @model_file@)
set(ORBEARING_PACK_OPTIONS -O3 -fno-math-errno -fno-trapping-math -Wno-psabi)
set(ORBEARING_VIEWS @views@)
set(ORBEARING_ROOT [[@PROJECT_SOURCE_DIR@]])
set(ORBEARING_BOOST [[@Boost_INCLUDE_DIRS@]])
set(ORBEARING_EIGEN [[@eigen@]])
set(ORBEARING_UNITY_BUILD @ORBEARING_UNITY_BUILD@)
set(ORBEARING_UNITY_FILES @ORBEARING_UNITY_FILES@)
set(ORBEARING_VERSION @PROJECT_VERSION@)
set(ORBEARING_WARNINGS_AS_ERRORS @ORBEARING_WARNINGS_AS_ERRORS@)
")

configure_file("${CMAKE_CURRENT_SOURCE_DIR}/win64/build_library.in" "${recipe}" @ONLY
  FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
add_custom_target(orbearing_fmu_win64 COMMAND "${recipe}" VERBATIM USES_TERMINAL)
# An older library would hold other equations than the Linux one beside it.
add_custom_command(TARGET orbearing_fmu_linux64 POST_BUILD
  COMMAND "${CMAKE_COMMAND}" -E rm -f "${ORBEARING_FMU_LIBRARIES}/win64/orbearing.dll" VERBATIM)
