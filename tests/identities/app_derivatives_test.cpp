// Derivatives by differences against those of forward differentiation through the equilibrium and the
// implicit function theorem, by which the program computed them before.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "app/case/case_file.hpp"
#include "app/study/derivatives.hpp"
#include "app/study/drivetrain_case.hpp"

namespace orbearing::app::app_derivatives_test {
namespace {

// Tolerance of the change of ln of the life by the number's own size (or its customary unit where it is
// zero): four digits.
constexpr double kFourDigits = 5e-5;
// Error of the former derivatives, by their own estimate.
constexpr double kFormer = 1e-7;

struct Row {
  std::string input;
  double life, derivative;
};
using Group = std::pair<std::string, std::string>;  // case and settings

std::map<Group, std::vector<Row>> table() {
  std::map<Group, std::vector<Row>> groups;
  std::ifstream file(ORBEARING_SOURCE_DIR "/tests/identities/analytic_life_derivatives.csv");
  std::string line;
  std::getline(file, line);  // heading
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::string name, settings, input, life, derivative;
    for (std::string* cell : {&name, &settings, &input, &life, &derivative}) std::getline(cells, *cell, ';');
    groups[{name, settings}].push_back({input, std::stod(life), std::stod(derivative)});
  }
  return groups;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, '|');) parts.push_back(part);
  return parts;
}

Derivatives by_inputs(const Group& group, const std::vector<Row>& rows) {
  const ResolvedCase in =
      read_point(ORBEARING_SOURCE_DIR "/cases/" + group.first + "/case.yaml", split(group.second));
  DerivativeOptions options;
  for (const Row& row : rows) options.paths.push_back(row.input.substr(0, row.input.find('[')));
  // Life of one bearing; the carrier as a body has lives of its own.
  const bool planets = in.model() == planetary_drivetrain;
  const ScalarResult life = scalar_result(
      in, "", planets ? governing_life_key(in) : bearing::rating::revolutions_key(governing_life(in)));
  return derivatives(in, life, value_here(in, life), options);
}

TEST(DerivativesOfLivesAtRest, AreThoseOfForwardDifferentiation) {
  const auto groups = table();
  EXPECT_GE(groups.size(), 20u);
  for (const auto& [group, rows] : groups) {
    const Derivatives found = by_inputs(group, rows);
    double worst = 0.0, largest_error = 0.0;
    for (const Row& row : rows) {
      const std::string where = group.first + " " + group.second + " " + row.input;
      const auto one = std::find_if(found.inputs.begin(), found.inputs.end(),
                                    [&](const Derivative& each) { return each.path == row.input; });
      ASSERT_NE(one, found.inputs.end()) << where;
      const double scale = (one->value != 0.0 ? std::abs(one->value) : 1.0) / row.life;
      const double size = std::max(1.0, std::abs(scale * row.derivative));
      const double deviation = std::abs(one->derivative - row.derivative) * scale;
      EXPECT_LT(deviation, kFourDigits * size)
          << where << ": " << one->derivative << ", was " << row.derivative;
      EXPECT_LE(deviation, one->error * scale + kFormer * size) << where;
      EXPECT_NEAR(found.value, row.life, 1e-9 * row.life) << where;
      worst = std::max(worst, deviation / size);
      largest_error = std::max(largest_error, one->error * scale / size);
    }
    fmt::print("{} {}: {} derivatives, worst deviation {:.1e}, largest error stated {:.1e}\n", group.first,
               group.second, rows.size(), worst, largest_error);
  }
}

}  // namespace
}  // namespace orbearing::app::app_derivatives_test
