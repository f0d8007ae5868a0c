// The quasi-static sweep of the reducer against the table of an earlier version.
// After a change that is meant: ORBEARING_WRITE_GOLDEN=1 build/release/bin/orbearing_tests
// --gtest_filter=regression/
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <vector>

#include "coupling/analysis/operating_point.hpp"
#include "tests/reducer.hpp"

namespace orbearing::analysis::reducer_quasi_static_test {
namespace {

// The loads of the races balance to 1e-12; libraries of another machine may round otherwise.
constexpr double kSameResult = 1e-9;
const std::string kTable = ORBEARING_SOURCE_DIR "/tests/regression/reducer_quasi_static.txt";

using Row = std::vector<double>;

Row row_at(double speed_rpm, bool film) {
  PlanetaryDrivetrain drivetrain = example::reducer();
  drivetrain.drive.speed = speed_rpm * example::rpm;
  drivetrain.dynamics.race.film_in_approach = film;
  const PointResult p = evaluate(drivetrain, derive(drivetrain));
  return {speed_rpm,        film ? 1.0 : 0.0, p.planet_load,      p.inner.load_max, p.inner.load_rms,
          p.outer.load_max, p.outer.load_rms, p.inner.least_film, p.life_hours};
}

std::vector<Row> computed() {
  std::vector<Row> rows;
  for (const bool film : {false, true})
    for (int step = 1; step <= 12; ++step) rows.push_back(row_at(1000.0 * step, film));
  return rows;
}

void write(const std::vector<Row>& rows) {
  std::ofstream out(kTable);
  out << std::setprecision(17);
  for (const Row& row : rows) {
    for (const double value : row) out << value << ' ';
    out << '\n';
  }
}

TEST(Regression, ReducerQuasiStatic) {
  const std::vector<Row> rows = computed();
  if (std::getenv("ORBEARING_WRITE_GOLDEN") != nullptr) write(rows);
  std::ifstream in(kTable);
  for (const Row& row : rows)
    for (const double value : row) {
      double expected = 0.0;
      ASSERT_TRUE(in >> expected) << kTable << " is too short";
      EXPECT_NEAR(value, expected, kSameResult * std::abs(expected))
          << "at " << row[0] << " rpm, film " << row[1];
    }
}

}  // namespace
}  // namespace orbearing::analysis::reducer_quasi_static_test
