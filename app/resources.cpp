#include "app/resources.hpp"

#include <utility>

#include "app/version.hpp"

namespace orbearing::app {

namespace {

namespace fs = std::filesystem;

// The one that was built beside the program; else, without its compiled part, that of the source tree; else
// that of an installation.
fs::path package_beside(const fs::path& folder) {
  for (const fs::path& package : {folder / "python", fs::path(source_folder) / "python"})
    if (fs::is_directory(package)) return package;
  return folder / "share" / "orbearing" / "python";
}

Resources& in_use() {
  static Resources found = [] {
    std::error_code ignored;
    return resources_of(fs::read_symlink("/proc/self/exe", ignored).parent_path().parent_path());
  }();
  return found;
}

}  // namespace

Resources resources_of(const fs::path& folder) {
  // Debian's own interpreter has the packages that are needed; another may come first on the PATH.
  return {folder, package_beside(folder), "/usr/bin/python3"};
}

const Resources& resources() {
  return in_use();
}

void use_resources(Resources others) {
  in_use() = std::move(others);
}

}  // namespace orbearing::app
