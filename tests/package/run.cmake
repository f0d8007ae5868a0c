# Installs the build, moves the installation elsewhere, and builds and runs a project that finds it there.
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT result EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command}\nended with ${result}:\n${text}")
  endif()
endfunction()

file(REMOVE_RECURSE "${WORK}")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/first")
file(RENAME "${WORK}/first" "${WORK}/moved")

set(reducer "${WORK}/moved/share/orbearing/cases/reducer_150kW/case.yaml")
file(READ "${CMAKE_CURRENT_LIST_DIR}/../../docs/guide/cpp.md" page)
string(REGEX MATCH "```cpp\n(.*)\n```" block "${page}")
file(WRITE "${WORK}/reducer.cpp" "${CMAKE_MATCH_1}")

run("${CMAKE_COMMAND}" -S "${CONSUMER}" -B "${WORK}/build" -G Ninja
    "-DCMAKE_PREFIX_PATH=${WORK}/moved" "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_FLAGS=${FLAGS}"
    "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}" "-DEXPECTED_VERSION=${VERSION}"
    "-DREDUCER=${reducer}" "-DREDUCER_PROGRAM=${WORK}/reducer.cpp")
run("${CMAKE_COMMAND}" --build "${WORK}/build")
run("${WORK}/build/consumer")

file(GLOB program "${WORK}/moved/bin/orbearing")
if(program)
  # The program of the page finds the peak that the command finds.
  file(READ "${WORK}/moved/share/orbearing/cases/templates/industrial.yaml" text)
  string(REGEX REPLACE "clearance_class: CN[^\n]*" "radial_clearance: 40 um" text "${text}")
  set(industrial "${WORK}/industrial.yaml")
  file(WRITE "${industrial}" "${text}")
  execute_process(COMMAND "${WORK}/build/reducer" "${industrial}" OUTPUT_VARIABLE found RESULT_VARIABLE result ERROR_VARIABLE reason)
  execute_process(COMMAND "${program}" sweep "${industrial}" --json --set "input.power=120 kW" --set "bearing.radial_clearance=25 um"
                          --set "sweep.input.speed={from: 2000 rpm, to: 12000 rpm, step: 1000 rpm}"
                  OUTPUT_VARIABLE sweep ERROR_VARIABLE more_reason)
  string(JSON peak GET "${sweep}" peak)
  execute_process(COMMAND /usr/bin/python3 -c "import json, sys; peak = json.loads(sys.argv[1]); print('%.1f rpm: L10mrh %.2f h' % (
peak['refined_speed_rpm'], peak['refined_life_h']))" "${peak}" OUTPUT_VARIABLE expected)
  if(NOT result EQUAL 0 OR NOT found STREQUAL expected)
    message(FATAL_ERROR "the program of docs/guide/cpp.md ended with ${result} and found ${found}; required: ${expected}\n${reason}${more_reason}")
  endif()
  run("${program}" --help)
  run("${program}" check "${WORK}/moved/share/orbearing/cases/reducer_150kW/case.yaml")
  # Its data are beside it, not in the source tree.
  execute_process(COMMAND /usr/bin/python3 -c "import matplotlib, netCDF4" RESULT_VARIABLE missing ERROR_QUIET OUTPUT_QUIET)
  if(missing EQUAL 0)
    execute_process(COMMAND "${program}" demo --json -o "${WORK}/demo" OUTPUT_VARIABLE demo ERROR_VARIABLE reason RESULT_VARIABLE result)
    if(NOT result EQUAL 0)
      message(FATAL_ERROR "the demo of the installed program ended with ${result}: ${reason}")
    endif()
    string(JSON case GET "${demo}" case)
    if(NOT case STREQUAL "${WORK}/moved/share/orbearing/cases/reducer_150kW/case.yaml" OR NOT EXISTS "${WORK}/demo/report.html")
      message(FATAL_ERROR "the demo of the installed program took ${case}, or wrote no report")
    endif()
  endif()
endif()

# The libraries without the program can be configured, too (tools/mutation --libraries).
run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}/../.." -B "${WORK}/libraries" -G Ninja
    "-DCMAKE_CXX_COMPILER=${COMPILER}" -DORBEARING_BUILD_APP=OFF -DORBEARING_BUILD_TESTS=OFF)
