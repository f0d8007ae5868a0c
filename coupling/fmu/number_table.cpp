#include "coupling/fmu/number_table.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace orbearing::fmu {

namespace {

constexpr std::string_view kFirstLine = "orbearing-fmu-model 1 ";  // format and its version
constexpr std::size_t kMostValues = 10'000'000;                    // of one row; a broken count ends here

void append(std::string& text, double value) {
  std::array<char, 40> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::hex);
  text.append(buffer.data(), end.ptr);
}

[[noreturn]] void refuse(std::size_t line, const std::string& found, const std::string& required) {
  throw std::invalid_argument("line " + std::to_string(line) + " of the model: found " + found +
                              "; required: " + required);
}

// The first word of `line`, which loses it and the blank behind.
std::string_view next_word(std::string_view& line) {
  const std::size_t end = std::min(line.find(' '), line.size());
  const std::string_view word = line.substr(0, end);
  line.remove_prefix(std::min(end + 1, line.size()));
  return word;
}

double number_from(std::string_view word, std::size_t line) {
  double value = 0.0;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), value, std::chars_format::hex);
  if (word.empty() || read.ec != std::errc() || read.ptr != word.data() + word.size() ||
      !std::isfinite(value))
    refuse(line, "'" + std::string(word) + "'", "a finite number in hexadecimal digits");
  return value;
}

NumberRow row_from(std::string_view text, std::size_t line) {
  NumberRow row{std::string(next_word(text)), {}};
  const std::string_view word = next_word(text);
  std::size_t count = 0;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), count);
  if (row.name.empty() || read.ec != std::errc() || read.ptr != word.data() + word.size() ||
      count > kMostValues)
    refuse(line, "'" + std::string(word) + "'", "a name and the number of its values");
  for (std::size_t i = 0; i < count; ++i) row.values.push_back(number_from(next_word(text), line));
  if (!text.empty()) refuse(line, "more values", std::to_string(count));
  return row;
}

}  // namespace

const std::vector<double>& NumberTable::at(std::string_view name) const {
  for (const NumberRow& row : rows)
    if (row.name == name) return row.values;
  throw std::invalid_argument("the model has no " + std::string(name));
}

std::string text_of(const NumberTable& table) {
  std::string text = std::string(kFirstLine) + table.model + '\n';
  for (const NumberRow& row : table.rows) {
    text += row.name + ' ' + std::to_string(row.values.size());
    for (const double value : row.values) append(text += ' ', value);
    text += '\n';
  }
  return text + "end\n";
}

NumberTable table_from(std::string_view text) {
  NumberTable table;
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) break;
    const std::string_view row = text.substr(0, end);
    text.remove_prefix(end + 1);
    if (line == 1) {
      if (!row.starts_with(kFirstLine))
        refuse(line, "another beginning", "'" + std::string(kFirstLine) + "'");
      table.model = row.substr(kFirstLine.size());
    } else if (row == "end") {
      return table;
    } else {
      table.rows.push_back(row_from(row, line));
    }
  }
  throw std::invalid_argument("the model ends early: found no line 'end'; required: a complete file");
}

std::uint64_t hash_of(std::string_view bytes, std::uint64_t seed) {
  for (const char byte : bytes) seed = (seed ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
  return seed;
}

}  // namespace orbearing::fmu
