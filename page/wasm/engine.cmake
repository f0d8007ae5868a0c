# The core as WebAssembly: the target `engine`, for Emscripten. Read by CMake behind project(), as
# CMAKE_PROJECT_Orbearing_INCLUDE (build.sh), so that the other build files hold nothing about browsers. Sources are
# those that the folders list; left out is what needs threads, netCDF, processes or FMUs.

set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
include("${CMAKE_CURRENT_LIST_DIR}/../../cmake/PackagesByHeaders.cmake")
foreach(library IN ITEMS UDUNITS2 NETCDF LIBZIP)
  set(${library}_LIBRARY "not needed" CACHE STRING "")
endforeach()

# Warnings are the business of the program's own compilers.
add_compile_options(-fwasm-exceptions -msimd128 -w)

# Sources of Debian's packages, which build.sh has brought here.
set(BUILD_SHARED_LIBS OFF)
foreach(option IN ITEMS YAML_CPP_BUILD_CONTRIB YAML_CPP_BUILD_TOOLS YAML_CPP_BUILD_TESTS YAML_CPP_INSTALL BUILD_TESTING
        NLOPT_CXX NLOPT_PYTHON NLOPT_OCTAVE NLOPT_MATLAB NLOPT_GUILE NLOPT_SWIG NLOPT_TESTS)
  set(${option} OFF CACHE BOOL "" FORCE)
endforeach()
foreach(package IN ITEMS yaml-cpp nlopt)
  file(GLOB folder LIST_DIRECTORIES true "${ORBEARING_SOURCES_OF_PACKAGES}/${package}-*")
  add_subdirectory("${folder}" "${PROJECT_BINARY_DIR}/${package}" EXCLUDE_FROM_ALL)
endforeach()
target_compile_options(yaml-cpp PRIVATE -Oz)
target_compile_options(nlopt PRIVATE -O2)
get_target_property(searches nlopt SOURCES)
list(FILTER searches EXCLUDE REGEX
  "algs/(auglag|bobyqa|cdirect|cobyla|crs|direct|esch|isres|luksan|mlsl|mma|newuoa|praxis)/")
set_target_properties(nlopt PROPERTIES SOURCES "${searches};${CMAKE_CURRENT_LIST_DIR}/other_searches.c")

# Behind all targets: the program's sources become those of the engine.
function(orbearing_engine)
  set(here "${PROJECT_SOURCE_DIR}/page/wasm")
  set(missing "SHELL:-include ${here}/missing_library.hpp")
  set_source_files_properties("${PROJECT_SOURCE_DIR}/coupling/analysis/parallel.cpp"
    TARGET_DIRECTORY orbearing_analysis PROPERTIES HEADER_FILE_ONLY ON)
  set_target_properties(orbearing_mechanics orbearing_gearset orbearing_bearing orbearing_coupling orbearing_analysis
    orbearing_fmu_core PROPERTIES POSITION_INDEPENDENT_CODE OFF)
  foreach(library IN ITEMS mechanics gearset bearing coupling analysis fmu_core)
    target_compile_options(orbearing_${library} PRIVATE ${missing})
  endforeach()
  foreach(library IN ITEMS gearset coupling fmu_core)  # their time is spent in the loops of bearing
    target_compile_options(orbearing_${library} PRIVATE -Os)
  endforeach()
  target_compile_options(orbearing_analysis PRIVATE -Oz)
  get_target_property(sources orbearing_app_core SOURCES)
  get_target_property(case_sources orbearing_app_case SOURCES)
  list(APPEND sources ${case_sources})
  foreach(name IN ITEMS case files pace quantity request templates text)
    list(APPEND sources interface/${name}.cpp)
  endforeach()
  list(FILTER sources EXCLUDE REGEX
    "^\\$<|commands/(demo|fmu|merge|new_case|open|open_not_built|python_part|report|spectrum|validate)\\.cpp")
  list(FILTER sources EXCLUDE REGEX
    "results/(archive|loaded_library|merge|netcdf_library|point_file)\\.cpp|study/(expected_file|fmu_model|load_series|report_data|validation_table)\\.cpp")
  list(FILTER sources EXCLUDE REGEX "study/(bladed_record|foreign_record|netcdf_record|openfast_record|record_file)\\.cpp")
  list(TRANSFORM sources PREPEND "${PROJECT_SOURCE_DIR}/app/")
  add_custom_command(OUTPUT "${PROJECT_BINARY_DIR}/units/units_table.hpp"
    COMMAND /usr/bin/python3 "${here}/units_table.py" "${PROJECT_BINARY_DIR}/units/units_table.hpp"
    DEPENDS "${here}/units_table.py")
  file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/units")
  set(own "${here}/engine.cpp" "${here}/stand_ins.cpp" "${here}/units_by_table.cpp")
  add_executable(engine ${sources} ${own} "${PROJECT_BINARY_DIR}/units/units_table.hpp")
  orbearing_compile_options(engine)
  set_target_properties(engine PROPERTIES POSITION_INDEPENDENT_CODE OFF)
  target_compile_options(engine PRIVATE -Oz ${missing})  # most of it is read and written once a request
  get_target_property(folders orbearing_app_needs INTERFACE_INCLUDE_DIRECTORIES)
  target_include_directories(engine PRIVATE ${folders} "${PROJECT_BINARY_DIR}/units")
  target_link_libraries(engine PRIVATE orbearing::analysis nlopt yaml-cpp fmt::fmt)
  orbearing_unity_build(engine 2)
  set_source_files_properties(${own} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  # A script for importScripts() of a worker, and for the tests' node.
  # In a file: a dollar sign does not come through CMake, ninja and the shell alike.
  file(WRITE "${PROJECT_BINARY_DIR}/js_functions.json" "[\"\$stringToNewUTF8\"]")
  target_link_options(engine PRIVATE -fwasm-exceptions -Oz
    -sMODULARIZE -sEXPORT_NAME=orbearingEngine -sENVIRONMENT=worker,node -sFORCE_FILESYSTEM
    -sEXPORTED_FUNCTIONS=_orbearing_answer,_malloc,_free "-sDEFAULT_LIBRARY_FUNCS_TO_INCLUDE=@${PROJECT_BINARY_DIR}/js_functions.json"
    -sEXPORTED_RUNTIME_METHODS=FS,UTF8ToString,stringToNewUTF8
    -sALLOW_MEMORY_GROWTH -sINITIAL_MEMORY=32MB -sTOTAL_STACK=4MB)
  set_target_properties(engine PROPERTIES OUTPUT_NAME engine_wasm RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}")
endfunction()
cmake_language(DEFER CALL orbearing_engine)
