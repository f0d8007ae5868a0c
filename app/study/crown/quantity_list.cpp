#include "app/study/crown/quantity_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "app/case/printable.hpp"

namespace orbearing::app {

namespace {

constexpr double kMostSteps = 1000.0;
constexpr double kWhole = 1e-9;  // of a step, by which a range may miss its end

void append_range(const std::string& option, const std::string& text, const Dimension& dimension,
                  std::vector<double>& values, std::vector<std::string>& mistakes) {
  const std::vector<std::string> parts = parts_of(text, ':');
  const std::size_t before = mistakes.size();
  std::vector<double> ends;
  for (const std::string& part : parts) ends.push_back(option_quantity(option, part, dimension, mistakes));
  if (mistakes.size() > before) return;
  const double steps = ends.size() == 3 ? (ends[1] - ends[0]) / ends[2] : -1.0;
  if (!(steps >= 0.0 && std::round(steps) <= kMostSteps) || std::abs(steps - std::round(steps)) > kWhole) {
    mistakes.push_back(
        fmt::format("{}: found {}; required: FROM : TO : STEP, where at most {} steps lead from "
                    "FROM to TO",
                    option, quote(text), kMostSteps));
    return;
  }
  for (int i = 0; i <= static_cast<int>(std::lround(steps)); ++i) values.push_back(ends[0] + i * ends[2]);
}

}  // namespace

std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (;;) {
    const std::size_t to = text.find(separator, from);
    std::string part = text.substr(from, to == std::string::npos ? to : to - from);
    const std::size_t first = part.find_first_not_of(" \t"), last = part.find_last_not_of(" \t");
    parts.push_back(first == std::string::npos ? "" : part.substr(first, last - first + 1));
    if (to == std::string::npos) return parts;
    from = to + 1;
  }
}

double option_quantity(const std::string& option, const std::string& text, const Dimension& dimension,
                       std::vector<std::string>& mistakes) {
  const Reading<double> reading = read_quantity(text, dimension);
  if (reading.value) return *reading.value;
  mistakes.push_back(fmt::format("{}: found {}: {}; required: {} with its unit, for instance \"{}\"", option,
                                 quote(text), reading.fault, dimension.name, dimension.example));
  return 0.0;
}

std::vector<double> quantity_list(const std::string& option, const std::string& text, const Dimension& dimension,
                                  const ListRange& range, std::vector<std::string>& mistakes) {
  std::vector<double> values;
  for (const std::string& part : parts_of(text, ',')) {
    const std::size_t before = values.size(), wrong = mistakes.size();
    if (part.find(':') != std::string::npos)
      append_range(option, part, dimension, values, mistakes);
    else
      values.push_back(option_quantity(option, part, dimension, mistakes));
    const bool inside = std::all_of(values.begin() + static_cast<std::ptrdiff_t>(before), values.end(),
                                    [&](double value) { return value >= range.least && value <= range.most; });
    if (!inside && mistakes.size() == wrong)
      mistakes.push_back(fmt::format("{}: found {}; required: {}", option, quote(part), range.words));
  }
  return values;
}

}  // namespace orbearing::app
