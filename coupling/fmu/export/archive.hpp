// An FMU as a zip archive in memory; equal contents give equal bytes.
#pragma once

#include <string>
#include <vector>

namespace orbearing::fmu {

struct ArchiveFile {
  std::string path;     // inside the archive, with '/'
  std::string content;  // bytes
};

/// Throws std::runtime_error with the reason of the zip library.
std::string archive_of(const std::vector<ArchiveFile>& files);

}  // namespace orbearing::fmu
