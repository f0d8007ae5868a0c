// An archive of files (zip) in memory; equal contents give equal bytes.
#pragma once

#include <string>
#include <vector>

namespace orbearing::app {

struct ArchiveFile {
  std::string path;     // inside the archive, with '/'
  std::string content;  // bytes
};

/// Throws ComputationFailed with the reason of the zip library.
std::string archive_of(const std::vector<ArchiveFile>& files);

}  // namespace orbearing::app
