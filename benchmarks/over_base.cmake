# Adds orbearing_pace (pace.cpp here) to the build of commit d33b5f5, of whose benchmarks it takes the runs:
#   cmake ... -DORBEARING_BUILD_BENCHMARKS=ON -DCMAKE_PROJECT_Orbearing_INCLUDE=<this file>
# Nothing of that version is changed.
set(orbearing_pace_source "${CMAKE_CURRENT_LIST_DIR}/pace.cpp")

function(orbearing_add_pace)
  get_target_property(folder orbearing_bench SOURCE_DIR)
  set(runs accuracy.cpp reducer.cpp runs.cpp speed.cpp)
  list(TRANSFORM runs PREPEND "${folder}/")
  add_executable(orbearing_pace "${orbearing_pace_source}" ${runs})
  foreach(property COMPILE_DEFINITIONS COMPILE_FEATURES COMPILE_OPTIONS CXX_EXTENSIONS INCLUDE_DIRECTORIES)
    get_target_property(value orbearing_bench ${property})
    set_target_properties(orbearing_pace PROPERTIES ${property} "${value}")
  endforeach()
  target_link_libraries(orbearing_pace PRIVATE orbearing_cvode orbearing_app_core)
endfunction()

cmake_language(DEFER CALL orbearing_add_pace)
