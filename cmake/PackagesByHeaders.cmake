# Packages for a compiler with another C or C++ library than Debian's. Headers come from Debian's packages; what has
# to be compiled is added by the file that includes this one. Read by CMake behind project().

# Headers of Debian's packages: /usr/include itself holds those of another C library.
set(headers "${PROJECT_BINARY_DIR}/headers")
file(MAKE_DIRECTORY "${headers}")
foreach(name IN ITEMS boost CLI fmt nlohmann nlopt.h nlopt.hpp udunits2.h converter.h pugixml.hpp pugiconfig.hpp)
  file(CREATE_LINK "/usr/include/${name}" "${headers}/${name}" SYMBOLIC)
endforeach()
include_directories(SYSTEM "${headers}" /usr/include/eigen3)

# All packages are above or in the file that includes this one, and nothing is installed.
foreach(command IN ITEMS find_package install export configure_package_config_file)
  function(${command})
  endfunction()
endforeach()
foreach(target IN ITEMS Eigen3::Eigen Boost::headers TBB::tbb NLopt::nlopt CLI11::CLI11 fmt::fmt
        nlohmann_json::nlohmann_json pugixml::pugixml)
  add_library(${target} INTERFACE IMPORTED GLOBAL)
endforeach()
set_target_properties(fmt::fmt PROPERTIES INTERFACE_COMPILE_DEFINITIONS FMT_HEADER_ONLY)
