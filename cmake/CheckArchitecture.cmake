# cmake -DROOT=<source folder> -P CheckArchitecture.cmake
#
# Fails where a library includes what its folder must not know. The include paths already hide the
# other folders; system headers are on every path, so only reading the lines can keep YAML, files and
# integrators out of the physics.
cmake_minimum_required(VERSION 3.25)

set(input_output "iostream|fstream|filesystem|cstdio|stdio\\.h|ostream|istream")
set(numerics "Eigen/.+|boost/math/.+")
# A standard header has neither folder nor suffix.
set(standard "[a-z_]+")

set(own_gearset "gearset/.+")
set(foreign_gearset "${numerics}|${standard}")
set(own_bearing "bearing/.+")
set(foreign_bearing "${numerics}|${standard}")
set(own_coupling "(gearset|bearing|coupling)/.+")
# Within the coupling each part knows those before it.
set(own_coupling/integration "(gearset|bearing|coupling/integration)/.+")
set(own_coupling/cosim "(gearset|bearing|coupling/(integration|cosim))/.+")
set(own_coupling/fmu "(gearset|bearing|coupling/(integration|cosim|fmu))/.+")
set(own_coupling/study "(gearset|bearing|coupling/(integration|cosim|study))/.+")
set(foreign_coupling "${numerics}|${standard}|(oneapi/)?tbb/.+|nlopt\\.hpp")
set(foreign_coupling/integration "${foreign_coupling}|boost/numeric/odeint(/.+|\\.hpp)")
# FMUs of others are archives with XML and libraries in them.
set(files_coupling/fmu/import "zip\\.h|pugixml\\.hpp|dlfcn\\.h|filesystem|fstream|cstdio|stdlib\\.h")

# An FMU of ours reads its numbers from a file, by the C library alone, and writes archives with XML.
set(files_coupling/fmu "cstdio|sched\\.h|windows\\.h")
set(files_coupling/fmu/export "zip\\.h|pugixml\\.hpp")

set(mistakes "")

function(check_file folder file)
  set(foreign "${foreign_${folder}}")
  set(own "${own_${folder}}")
  cmake_path(RELATIVE_PATH file BASE_DIRECTORY "${ROOT}" OUTPUT_VARIABLE place)
  if(place MATCHES "^coupling/integration/")
    set(foreign "${foreign_coupling/integration}")
  endif()
  if(place MATCHES "^(coupling/[a-z]+)/")
    set(own "${own_${CMAKE_MATCH_1}}")
  endif()
  set(files "none of them")
  if(place MATCHES "^coupling/fmu/import/")
    set(files "${files_coupling/fmu/import}")
  elseif(place MATCHES "^coupling/fmu/export/")
    set(files "${files_coupling/fmu/export}")
  elseif(place MATCHES "^coupling/fmu/")
    set(files "${files_coupling/fmu}")
  endif()
  file(STRINGS "${file}" lines REGEX "^[ \t]*#[ \t]*include")
  foreach(line IN LISTS lines)
    if(line MATCHES "include[ \t]*\"([^\"]*)\"")
      if(NOT CMAKE_MATCH_1 MATCHES "^(${own})$")
        list(APPEND mistakes "${place}: \"${CMAKE_MATCH_1}\" is not a header that this folder may know; written from the root: ${own}")
      endif()
    elseif(line MATCHES "include[ \t]*<([^>]*)>")
      set(header "${CMAKE_MATCH_1}")
      if(header MATCHES "^(${files})$")
        continue()
      endif()
      if(header MATCHES "^(${input_output})$" OR NOT header MATCHES "^(${foreign})$")
        list(APPEND mistakes "${place}: <${header}> is not for ${folder}")
      endif()
    else()
      list(APPEND mistakes "${place}: an include that names no header: ${line}")
    endif()
  endforeach()
  set(mistakes "${mistakes}" PARENT_SCOPE)
endfunction()

foreach(folder IN ITEMS gearset bearing coupling)
  file(GLOB_RECURSE files "${ROOT}/${folder}/*.hpp" "${ROOT}/${folder}/*.cpp")
  foreach(file IN LISTS files)
    check_file(${folder} "${file}")
  endforeach()
endforeach()

if(mistakes)
  list(JOIN mistakes "\n  " text)
  message(FATAL_ERROR "Forbidden includes:\n  ${text}")
endif()
