#include "app/case/mistake.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "app/errors.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

auto order(const Location& location) {
  return std::tuple(location.option, location.file, location.line, location.column);
}

std::vector<std::string> sorted_lines(const std::string& file, std::vector<Mistake> mistakes) {
  std::stable_sort(mistakes.begin(), mistakes.end(),
                   [](const Mistake& a, const Mistake& b) { return order(a.location) < order(b.location); });
  std::vector<std::string> lines;
  for (const Mistake& mistake : mistakes) {
    std::string line = describe(mistake, file);
    // Two checks may report the same mistake in the same words.
    if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace

std::string describe(const Mistake& mistake, const std::string& file) {
  const Location& location = mistake.location;
  const bool option = location.option && location.file.empty();
  const std::string_view of = location.file.empty() ? std::string_view(file) : location.file;
  const std::string where =
      option ? "--set" : fmt::format("{}:{}:{}", printable(of), location.line, location.column);
  return fmt::format("{}: {}: {}; {}", where, shortened(mistake.path), printable(mistake.message.found),
                     printable(mistake.message.required));
}

void throw_mistakes(const std::string& file, std::vector<Mistake> mistakes) {
  throw BadInput(sorted_lines(file, std::move(mistakes)));
}

}  // namespace orbearing::app
