// orbearing._core: the program within Python.
#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>

#include "app/resources.hpp"
#include "app/version.hpp"
#include "python/bindings/bindings.hpp"

namespace orbearing::python {

namespace {

namespace fs = std::filesystem;

fs::path package_folder() {
  Dl_info info{};
  dladdr(reinterpret_cast<void*>(&package_folder), &info);
  return fs::absolute(info.dli_fname).parent_path();
}

// Of a wheel all stands within the package; else it is that of a build folder or of an installation.
app::Resources resources_beside(const fs::path& package) {
  const fs::path interpreter =
      pybind11::cast<std::string>(pybind11::module_::import("sys").attr("executable"));
  fs::path folder = package;
  if (!fs::exists(package / "lib" / "orbearing"))
    folder = package.parent_path().parent_path();  // build/release/python/orbearing
  if (!fs::exists(folder / "lib" / "orbearing"))
    folder = folder.parent_path().parent_path();  // PREFIX/share/orbearing/python/orbearing
  return {folder, package.parent_path(), interpreter};
}

}  // namespace

}  // namespace orbearing::python

PYBIND11_MODULE(_core, module) {
  namespace python = orbearing::python;
  module.doc() = "Compiled part of the package orbearing; use the package.";
  module.attr("version") = std::string(orbearing::app::program_version);
  module.attr("instruction_set") = std::string(orbearing::app::instruction_set);
  const python::fs::path package = python::package_folder();
  orbearing::app::use_resources(python::resources_beside(package));
  // The units' library of a wheel does not find its own database.
  const python::fs::path units = package / "share" / "udunits" / "udunits2.xml";
  if (python::fs::exists(units)) setenv("UDUNITS2_XML_PATH", units.c_str(), 0);
  python::add_errors(module);
  python::add_case(module);
  python::add_command(module);
  python::add_variants(module);
  python::add_machine(module);
}
