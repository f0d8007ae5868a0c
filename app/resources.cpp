#include "app/resources.hpp"

#include <utility>

#include "app/version.hpp"

namespace orbearing::app {

namespace {

namespace fs = std::filesystem;

// The one that was built beside the program; else that of an installation; else, without the
// program's library, that of the source tree.
fs::path package_beside(const fs::path& folder) {
  const fs::path installed = folder / "share" / "orbearing" / "python";
  for (const fs::path& package : {folder / "python", installed, fs::path(source_folder) / "python"})
    if (fs::is_directory(package)) return package;
  return installed;
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

namespace {

fs::path shared_folder(const char* name, const char* name_in_tree) {
  const fs::path own = resources().folder / "share" / "orbearing" / name;
  const fs::path in_tree = fs::path(source_folder) / name_in_tree;
  return !fs::is_directory(own) && fs::is_directory(in_tree) ? in_tree : own;
}

}  // namespace

fs::path shipped_cases() {
  return shared_folder("cases", "cases");
}

fs::path page_files() {
  return shared_folder("page", "page/web");
}

void use_resources(Resources others) {
  in_use() = std::move(others);
}

}  // namespace orbearing::app
