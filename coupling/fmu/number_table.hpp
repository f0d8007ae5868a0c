// Named lists of numbers and their text, which keeps every bit: how a model travels inside an FMU.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace orbearing::fmu {

struct NumberRow {
  std::string name;            // without blanks
  std::vector<double> values;  // finite
};

/// All numbers of one model. The text begins with a line that names format, its version and the model; then
/// one line for each row: name, count, values as hexadecimal floats.
struct NumberTable {
  std::string model;  // "bearing" or "gearset"
  std::vector<NumberRow> rows;

  /// Throws std::invalid_argument where there is no such row.
  const std::vector<double>& at(std::string_view name) const;
};

std::string text_of(const NumberTable& table);

/// Throws std::invalid_argument, with line, what was found and what is required.
NumberTable table_from(std::string_view text);

/// 64 bits of FNV-1a over `bytes`, going on from `seed`.
std::uint64_t hash_of(std::string_view bytes, std::uint64_t seed = 0xcbf29ce484222325u);

}  // namespace orbearing::fmu
