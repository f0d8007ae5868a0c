// The coupling set and the three sets against the table of an earlier version.
// After a change that is meant: ORBEARING_WRITE_GOLDEN=1 build/release/bin/orbearing_tests
// --gtest_filter=regression/
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <vector>

#include "app/case/case_file.hpp"
#include "app/study/planetary_case.hpp"

namespace orbearing::app::app_sets_quasi_static_test {
namespace {

// The loads of the races balance to 1e-12; libraries of another machine may round otherwise.
constexpr double same_result = 1e-9;
const std::string table_file = ORBEARING_SOURCE_DIR "/tests/regression/sets_quasi_static.txt";

std::vector<double> numbers_of(const std::string& name) {
  const ResolvedCase resolved = read_case(ORBEARING_SOURCE_DIR "/cases/" + name + "/case.yaml");
  std::vector<double> numbers;
  for (std::size_t i = 0; i < sweep_size(resolved); ++i) {
    const analysis::PointResult point =
        analysis::evaluate(bearing_sets(resolved.with(sweep_point(resolved, i))));
    numbers.insert(numbers.end(),
                   {point.planet_load, point.outer.load_max, point.life_hours, point.system_life_hours});
    for (const analysis::SetResult& set : point.sets)
      numbers.insert(numbers.end(), {set.planet_load, set.life_hours});
  }
  return numbers;
}

TEST(Regression, SetsQuasiStatic) {
  std::vector<double> numbers = numbers_of("coupling_set_150kW");
  for (const double number : numbers_of("three_sets_150kW")) numbers.push_back(number);
  if (std::getenv("ORBEARING_WRITE_GOLDEN") != nullptr) {
    std::ofstream out(table_file);
    for (const double number : numbers) out << std::setprecision(17) << number << '\n';
  }
  std::ifstream in(table_file);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    double expected = 0.0;
    ASSERT_TRUE(in >> expected) << table_file << " is too short";
    EXPECT_NEAR(numbers[i], expected, same_result * std::abs(expected)) << "number " << i;
  }
}

}  // namespace
}  // namespace orbearing::app::app_sets_quasi_static_test
