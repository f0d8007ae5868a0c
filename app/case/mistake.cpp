#include "app/case/mistake.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "app/errors.hpp"

namespace orbearing::app {

namespace {

auto order(const Place& place) {
  return std::tuple(place.option, place.line, place.column);
}

std::vector<std::string> sorted_lines(const std::string& file, std::vector<Mistake> mistakes) {
  std::stable_sort(mistakes.begin(), mistakes.end(),
                   [](const Mistake& a, const Mistake& b) { return order(a.place) < order(b.place); });
  std::vector<std::string> lines;
  for (const Mistake& mistake : mistakes) {
    std::string line = describe(mistake, file);
    // Two checks may object to the same thing in the same words.
    if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace

std::string quote(std::string_view text) {
  constexpr std::size_t longest = 60;  // [byte] enough to recognise the place
  std::string shown;
  for (const char c : text.substr(0, longest)) shown += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  if (text.size() <= longest) return "'" + shown + "'";
  while (!shown.empty() && (static_cast<unsigned char>(shown.back()) & 0x80) != 0) shown.pop_back();
  return "'" + shown + "...'";
}

std::string describe(const Mistake& mistake, const std::string& file) {
  const std::string where = mistake.place.option
                                ? std::string("--set")
                                : fmt::format("{}:{}:{}", file, mistake.place.line, mistake.place.column);
  return fmt::format("{}: {}: {}; {}", where, mistake.path, mistake.complaint.found,
                     mistake.complaint.required);
}

void throw_mistakes(const std::string& file, std::vector<Mistake> mistakes) {
  throw BadInput(sorted_lines(file, std::move(mistakes)));
}

}  // namespace orbearing::app
