#include "orbearing/files.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <system_error>

#include "app/results/durable_file.hpp"

namespace orbearing {

std::string read_file(const std::filesystem::path& file) {
  std::error_code ignored;
  // Opening a pipe would wait for its other end.
  const bool regular = std::filesystem::is_regular_file(file, ignored);
  std::ifstream stream;
  if (regular) stream.open(file, std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream.is_open() || stream.bad())
    throw BadInput(file.string() + ": cannot be read; a readable file is required");
  return content;
}

void write_file(const std::filesystem::path& file, std::string_view content) {
  app::write_aside_and_rename(file, content);
}

void require_no_link(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_symlink(std::filesystem::symlink_status(path, ignored)))
    throw BadInput(
        fmt::format("{}: found a link to {}; required: a file or folder of its own, so that nothing outside "
                    "is written to. Give another folder",
                    path.string(), std::filesystem::read_symlink(path, ignored).string()));
}

std::string checksum(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3U;
  }
  return fmt::format("{:016x}", hash);
}

}  // namespace orbearing
