// The files of the project for its tests.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace orbearing::repository {

/// Files of the source folders and the root with one of the suffixes; builds and results left out.
std::vector<std::filesystem::path> files(const std::vector<std::string>& suffixes);

std::string contents(const std::filesystem::path& file);

std::filesystem::path root();

}  // namespace orbearing::repository
