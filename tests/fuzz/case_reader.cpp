// Any bytes given as a case file must end in a case or in BadInput, never in a crash, a hang or another
// exception.
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/case/case_file.hpp"
#include "app/errors.hpp"

namespace {

/// The text of the file, then --set options, all separated by NUL bytes.
std::vector<std::string> split_at_nul(const std::string& bytes) {
  std::vector<std::string> parts(1);
  for (const char byte : bytes) {
    if (byte == '\0') {
      parts.emplace_back();
    } else {
      parts.back().push_back(byte);
    }
  }
  return parts;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<std::string> parts = split_at_nul(std::string(data, data + size));
  try {
    orbearing::app::parse_case(parts.front(), "fuzz.yaml", {parts.begin() + 1, parts.end()});
  } catch (const orbearing::app::BadInput&) {
  }
  return 0;
}
