// A short fingerprint of a text: equal for equal texts, else almost surely not.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace orbearing::app {

/// Fowler, Noll and Vo's hash of 64 bits (FNV-1a) as 16 hexadecimal digits. It finds damage, not forgery.
inline std::string checksum(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3U;
  }
  return fmt::format("{:016x}", hash);
}

}  // namespace orbearing::app
