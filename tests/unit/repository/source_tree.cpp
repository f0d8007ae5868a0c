#include "tests/unit/repository/source_tree.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace orbearing::repository {

namespace fs = std::filesystem;

namespace {

bool is_skipped(const fs::path& folder) {
  static const std::vector<std::string> names{".git", "build", "results", "__pycache__", ".cache"};
  return std::find(names.begin(), names.end(), folder.filename().string()) != names.end();
}

}  // namespace

fs::path root() {
  return ORBEARING_SOURCE_DIR;
}

std::vector<fs::path> files(const std::vector<std::string>& suffixes) {
  std::vector<fs::path> found;
  for (auto entry = fs::recursive_directory_iterator(root()); entry != fs::recursive_directory_iterator();
       ++entry) {
    // app/results is source; only the root's results folder is made by runs.
    if (entry->is_directory() && is_skipped(entry->path()) &&
        (entry->path().filename() != "results" || entry->path().parent_path() == root())) {
      entry.disable_recursion_pending();
    } else if (entry->is_regular_file() &&
               std::find(suffixes.begin(), suffixes.end(), entry->path().extension()) != suffixes.end()) {
      found.push_back(entry->path());
    }
  }
  return found;
}

std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace orbearing::repository
