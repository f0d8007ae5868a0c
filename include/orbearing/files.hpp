// Files that are read and written whole.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "orbearing/errors.hpp"

namespace orbearing {

/// Whole content. Throws BadInput where the file cannot be read or is none, as a pipe is.
std::string read_file(const std::filesystem::path& file);

/// Replaces its content in one step: after a kill the file has its former content or the new one. A device or
/// a pipe is written into. Throws ComputationFailed.
void write_file(const std::filesystem::path& file, std::string_view content);

/// Throws BadInput where `path` is a symbolic link, by which something outside of its folder would be
/// written.
void require_no_link(const std::filesystem::path& path);

/// Fowler, Noll and Vo's hash of 64 bits (FNV-1a) as 16 hexadecimal digits: equal for equal texts, else
/// almost surely not. It finds damage, not forgery.
std::string checksum(std::string_view text);

}  // namespace orbearing
