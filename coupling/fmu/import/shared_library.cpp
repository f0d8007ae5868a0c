#include "coupling/fmu/import/shared_library.hpp"

#include <dlfcn.h>

#include "coupling/fmu/import/errors.hpp"

namespace orbearing::fmu {

SharedLibrary::SharedLibrary(const std::filesystem::path& file, Symbols symbols)
    : name_{file.filename().string()} {
  handle_ = dlopen(file.c_str(), RTLD_LAZY | (symbols == Symbols::for_all ? RTLD_GLOBAL : RTLD_LOCAL));
  if (handle_ == nullptr) throw ForeignFmuError(std::string("library cannot be loaded: ") + dlerror());
}

SharedLibrary::~SharedLibrary() {
  dlclose(handle_);
}

void* SharedLibrary::address(const std::string& name) const {
  void* found = dlsym(handle_, name.c_str());
  if (found == nullptr) throw ForeignFmuError(name_ + " has no function " + name + ", which is required");
  return found;
}

}  // namespace orbearing::fmu
