// Of the shared library alone, whose program is somebody else's: what it reads stands beside it.
#include <dlfcn.h>

#include <filesystem>

#include "app/resources.hpp"

namespace orbearing::app {

namespace {

// In "lib" of a build folder or of an installation.
[[gnu::constructor]] void find_resources() {
  Dl_info info{};
  dladdr(reinterpret_cast<void*>(&find_resources), &info);
  use_resources(resources_of(std::filesystem::canonical(info.dli_fname).parent_path().parent_path()));
}

}  // namespace

}  // namespace orbearing::app
