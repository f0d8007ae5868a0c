# cmake -DPYTHON=<python3> -DCHECK=<check_circles.py> -DWORK=<folder> -P circles.cmake
#
# The check for circles itself: each small tree must be accepted, or refused with the circle and the includes
# that make it.
cmake_minimum_required(VERSION 3.25)

# plant(<tree> <file> <included file>...): a file of a small tree.
function(plant tree file)
  set(text "")
  foreach(header IN LISTS ARGN)
    string(APPEND text "#include \"${header}\"\n")
  endforeach()
  file(WRITE "${WORK}/${tree}/${file}" "${text}")
endfunction()

# verdict(<tree> <line>...): the lines that the check must print; none: it must find nothing.
function(verdict tree)
  execute_process(COMMAND "${PYTHON}" "${CHECK}" "${WORK}/${tree}"
                  RESULT_VARIABLE result OUTPUT_VARIABLE found ERROR_VARIABLE errors)
  list(JOIN ARGN "\n" expected)
  if(expected)
    string(APPEND expected "\n")
    set(code 1)
  else()
    set(code 0)
  endif()
  if(NOT result EQUAL code OR NOT found STREQUAL expected)
    message(SEND_ERROR "${tree}: exit code ${result}, should be ${code}; printed\n${found}${errors}should be\n${expected}")
  endif()
endfunction()

file(REMOVE_RECURSE "${WORK}")

# A folder may know the one within it, a source its own header, two sources each other's headers of a ladder.
plant(ladder bearing/profile/shape.hpp)
plant(ladder bearing/parameters.hpp bearing/profile/shape.hpp)
plant(ladder bearing/motion/model.hpp bearing/parameters.hpp)
plant(ladder bearing/motion/model.cpp bearing/motion/model.hpp bearing/profile/shape.hpp)
verdict(ladder)

# No pair is in a circle here, but the folders are, over three of them.
plant(folders bearing/contact/film.hpp)
plant(folders bearing/contact/race.hpp bearing/motion/parameters.hpp)
plant(folders bearing/motion/parameters.hpp)
plant(folders bearing/equilibrium/ring.cpp bearing/contact/film.hpp)
plant(folders bearing/equilibrium/search.hpp)
plant(folders bearing/motion/start.cpp bearing/equilibrium/search.hpp)
verdict(folders
  "circle of folders: bearing/contact -> bearing/motion -> bearing/equilibrium -> bearing/contact"
  "  bearing/contact/race.hpp includes bearing/motion/parameters.hpp"
  "  bearing/motion/start.cpp includes bearing/equilibrium/search.hpp"
  "  bearing/equilibrium/ring.cpp includes bearing/contact/film.hpp")

# A folder and the one within it.
plant(nested bearing/parameters.hpp bearing/profile/shape.hpp)
plant(nested bearing/units.hpp)
plant(nested bearing/profile/shape.hpp)
plant(nested bearing/profile/design.cpp bearing/units.hpp)
verdict(nested
  "circle of folders: bearing -> bearing/profile -> bearing"
  "  bearing/parameters.hpp includes bearing/profile/shape.hpp"
  "  bearing/profile/design.cpp includes bearing/units.hpp")

# Two pairs of one folder whose headers know nothing of each other.
plant(pairs gearset/modes.hpp)
plant(pairs gearset/modes.cpp gearset/modes.hpp gearset/kinds.hpp)
plant(pairs gearset/kinds.hpp)
plant(pairs gearset/kinds.cpp gearset/kinds.hpp gearset/modes.hpp)
verdict(pairs
  "circle of pairs: gearset/kinds -> gearset/modes -> gearset/kinds"
  "  gearset/kinds.cpp includes gearset/modes.hpp"
  "  gearset/modes.cpp includes gearset/kinds.hpp")

# Modules of the Python package, one of which asks for the other within a function.
file(WRITE "${WORK}/modules/python/orbearing/case.py" "import os\nfrom orbearing.results import Result\n")
file(WRITE "${WORK}/modules/python/orbearing/results.py"
     "from orbearing import units\ndef case():\n    import orbearing.case\n")
file(WRITE "${WORK}/modules/python/orbearing/units.py" "import re\n")
file(WRITE "${WORK}/modules/python/orbearing/__init__.py" "from orbearing.case import Case\n")
verdict(modules
  "circle of modules: python/orbearing/case.py -> python/orbearing/results.py -> python/orbearing/case.py"
  "  python/orbearing/case.py includes python/orbearing/results.py"
  "  python/orbearing/results.py includes python/orbearing/case.py")
