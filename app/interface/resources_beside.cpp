// Only for the shared library, which other programs load: its resources are beside the library.
#include <dlfcn.h>

#include <filesystem>

#include "app/resources.hpp"

namespace orbearing::app {

namespace {

// In "lib" of a build folder or of an installation; of Debian in "lib/x86_64-linux-gnu".
[[gnu::constructor]] void find_resources() {
  Dl_info info{};
  dladdr(reinterpret_cast<void*>(&find_resources), &info);
  std::filesystem::path folder = std::filesystem::canonical(info.dli_fname).parent_path().parent_path();
  if (!std::filesystem::exists(folder / "lib" / "orbearing")) folder = folder.parent_path();
  use_resources(resources_of(folder));
}

}  // namespace

}  // namespace orbearing::app
