# The library of a wheel for every Python and for C libraries from 2.28 on: targets orbearing_library and
# orbearing_fmu_linux64, for clang with libc++ as the package ziglang has them. Read by CMake behind project(), as
# CMAKE_PROJECT_Orbearing_INCLUDE (tools/wheel). Sources and options are those of the other builds. Libraries are static
# and in ORBEARING_WHEEL_LIBRARIES, built by tools/wheel from the sources of Debian's packages.
set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
include("${CMAKE_CURRENT_LIST_DIR}/../../../cmake/PackagesByHeaders.cmake")

set(orbearing_wheel_folder "${CMAKE_CURRENT_LIST_DIR}")
set(orbearing_stand_ins "${CMAKE_CURRENT_LIST_DIR}/stand_ins")
set(here "${PROJECT_SOURCE_DIR}/page/wasm")  # where libc++ was the first time
include_directories(SYSTEM "${orbearing_stand_ins}" "${ORBEARING_WHEEL_LIBRARIES}/include")
add_compile_options(-w -fno-sanitize=all)

add_library(yaml-cpp INTERFACE)
target_link_libraries(yaml-cpp INTERFACE "${ORBEARING_WHEEL_LIBRARIES}/lib/libyaml-cpp.a")
target_link_libraries(NLopt::nlopt INTERFACE "${ORBEARING_WHEEL_LIBRARIES}/lib/libnlopt.a")
target_link_libraries(pugixml::pugixml INTERFACE "${ORBEARING_WHEEL_LIBRARIES}/lib/libpugixml.a")
set(NETCDF_LIBRARY "${ORBEARING_WHEEL_LIBRARIES}/lib/libnetcdf.a" CACHE FILEPATH "")
set(LIBZIP_LIBRARY "${ORBEARING_WHEEL_LIBRARIES}/lib/libzip.a;${ORBEARING_WHEEL_LIBRARIES}/lib/libz.a" CACHE STRING "")
set(HTTPLIB_INCLUDE_DIR "${ORBEARING_WHEEL_LIBRARIES}/include" CACHE PATH "")  # the whole library is in its header
add_library(orbearing_httplib INTERFACE)
set(HTTPLIB_LIBRARY orbearing_httplib CACHE STRING "")

# udunits2 reads a database by a reader of XML: the table of the page in a browser replaces both.
add_custom_command(OUTPUT "${PROJECT_BINARY_DIR}/units/units_table.hpp"
  COMMAND /usr/bin/python3 "${here}/units_table.py" "${PROJECT_BINARY_DIR}/units/units_table.hpp"
  DEPENDS "${here}/units_table.py")
file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/units")
add_library(orbearing_units STATIC "${here}/units_by_table.cpp" "${PROJECT_BINARY_DIR}/units/units_table.hpp")
target_compile_features(orbearing_units PRIVATE cxx_std_20)
target_include_directories(orbearing_units PRIVATE "${PROJECT_BINARY_DIR}/units")
set_target_properties(orbearing_units PROPERTIES POSITION_INDEPENDENT_CODE ON)
set(UDUNITS2_LIBRARY orbearing_units CACHE STRING "")

# Behind all targets: a library that shows its C functions alone, and a server without encryption.
function(orbearing_wheel)
  set_source_files_properties("${PROJECT_SOURCE_DIR}/page/page_server.cpp" TARGET_DIRECTORY orbearing_page
    PROPERTIES COMPILE_DEFINITIONS "")
  set_source_files_properties("${PROJECT_SOURCE_DIR}/page/workers.cpp" TARGET_DIRECTORY orbearing_page
    PROPERTIES COMPILE_OPTIONS "-include;${orbearing_stand_ins}/older_glibc.hpp")
  set_source_files_properties("${PROJECT_SOURCE_DIR}/bearing/film/reynolds/point.cpp" TARGET_DIRECTORY orbearing_bearing
    PROPERTIES COMPILE_OPTIONS "-include;${PROJECT_SOURCE_DIR}/page/wasm/elliptic_integrals.hpp")
  set_target_properties(orbearing_library PROPERTIES NO_SONAME ON LINK_OPTIONS
    "-Wl,--version-script=${orbearing_wheel_folder}/exports.map;-Wl,--gc-sections;-Wl,-z,defs;-s")
  set_target_properties(orbearing_fmu_linux64 PROPERTIES LINK_OPTIONS
    "-Wl,--version-script=${PROJECT_SOURCE_DIR}/coupling/fmu/exports.map;-Wl,--gc-sections;-Wl,-z,defs;-s")
endfunction()
cmake_language(DEFER CALL orbearing_wheel)
