# Included by the main build: the target orbearing_fmu_win64, or a line that says why there is none.
string(COMPARE EQUAL "${CMAKE_BUILD_TYPE}" Release optimised)
option(ORBEARING_BUILD_WIN64 "Build the Windows library that goes into FMUs" ${optimised})
find_program(ORBEARING_MINGW x86_64-w64-mingw32-g++-posix)
if(NOT ORBEARING_BUILD_WIN64)
  return()
elseif(NOT ORBEARING_MINGW)
  message(STATUS "FMUs without Windows library: no x86_64-w64-mingw32-g++-posix (package g++-mingw-w64-x86-64-posix)")
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
  "^(drivetrain/|mesh/[^p]|mesh/planetary|dynamics/(modes|mode_kind|bodies|energy)|tooth_|planet_body|contact_path|working_geometry|gear_pair|mean_loads|assembly|involute)")
orbearing_win64_sources(bearing "^(half_space|static_load)/|^rating/(ball|basic|life)_|_avx[0-9]+\\.cpp$")
orbearing_win64_sources(coupling "^(study/|cosim/[^d])")
set(interface ${ORBEARING_FMU_INTERFACE})
list(TRANSFORM interface PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/")
list(APPEND ORBEARING_SOURCES ${ORBEARING_FMU_CORE} ${interface})
set(lanes ${ORBEARING_SOURCES})
list(FILTER lanes INCLUDE REGEX "_baseline\\.cpp$")

set(views "")
foreach(folder IN ITEMS gearset bearing coupling)
  list(APPEND views "${PROJECT_BINARY_DIR}/view/${folder}")
endforeach()
get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
list(GET eigen 0 eigen)
set(list_file "${CMAKE_CURRENT_BINARY_DIR}/win64_sources.cmake")
file(CONFIGURE OUTPUT "${list_file}" @ONLY CONTENT
"set(ORBEARING_WIN64_SOURCES @ORBEARING_SOURCES@)
set(ORBEARING_WIN64_LANES @lanes@)
set(ORBEARING_LANE_OPTIONS -O3 -fno-math-errno -fno-trapping-math -Wno-psabi)
set(ORBEARING_VIEWS @views@)
set(ORBEARING_ROOT [[@PROJECT_SOURCE_DIR@]])
set(ORBEARING_BOOST [[@Boost_INCLUDE_DIRS@]])
set(ORBEARING_EIGEN [[@eigen@]])
set(ORBEARING_OUTPUT [[@ORBEARING_FMU_LIBRARIES@/win64]])
set(ORBEARING_VERSION @PROJECT_VERSION@)
set(ORBEARING_WARNINGS_AS_ERRORS @ORBEARING_WARNINGS_AS_ERRORS@)
")

include(ExternalProject)
ExternalProject_Add(orbearing_fmu_win64
  SOURCE_DIR "${CMAKE_CURRENT_SOURCE_DIR}/win64"
  BINARY_DIR "${CMAKE_CURRENT_BINARY_DIR}/win64_build"
  PREFIX "${CMAKE_CURRENT_BINARY_DIR}/win64"
  CMAKE_GENERATOR "${CMAKE_GENERATOR}"
  CMAKE_ARGS "-DCMAKE_TOOLCHAIN_FILE=${PROJECT_SOURCE_DIR}/cmake/mingw64.cmake" -DCMAKE_BUILD_TYPE=Release
             "-DORBEARING_SOURCES=${list_file}" "-DORBEARING_ROOT=${PROJECT_SOURCE_DIR}"
  BUILD_COMMAND "${CMAKE_COMMAND}" --build <BINARY_DIR> --parallel 2
  BUILD_ALWAYS ON
  INSTALL_COMMAND "")
