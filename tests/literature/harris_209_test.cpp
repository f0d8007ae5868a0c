// Roller loads of the cylindrical roller bearing 209 of [Harris2006] under 4450 N, for both contact laws:
// values recomputed from the book's data by independent programs.
#include <gtest/gtest.h>

#include <vector>

#include "bearing/equilibrium/quasi_static.hpp"
#include "tests/unit/bearing/example_bearings.hpp"

namespace orbearing::bearing::harris_209_test {
namespace {

constexpr double kPublished = 0.05;  // [N] half a unit of the last digit given
constexpr double kUnloaded = 0.0;  // [N]

struct Row {
  const char* name;
  double clearance;  // [m]  diametral
  ContactLaw law;
  std::vector<double> loads;  // [N]  at 0, 25.7, 51.4, 77.1 ... degrees from the load line
};

// At zero clearance the contact constant drops out: only the exponent 10/9 distributes the load.
const std::vector<Row>& rows() {
  static const std::vector<Row> all{
      {"no clearance, Palmgren", 0.0, ContactLaw::palmgren, {1298.8, 1156.7, 768.4, 244.6}},
      {"no clearance, ISO/TS 16281", 0.0, ContactLaw::iso16281, {1298.8, 1156.7, 768.4, 244.6}},
      {"40.6 um, ISO/TS 16281", 40.6e-6, ContactLaw::iso16281, {1956.3, 1383.9}},
      {"40.6 um, Palmgren", 40.6e-6, ContactLaw::palmgren, {1964.7, 1379.2}}};
  return all;
}

TEST(Harris209, RollerLoads) {
  for (const Row& row : rows()) {
    SCOPED_TRACE(row.name);
    Bearing bearing = example_bearings::bearing_209();
    bearing.radial_clearance = row.clearance;
    bearing.contact_law = row.law;
    // The outer ring is pressed on the first roller: the load points away from it.
    const QuasiStaticState state =
        quasi_static_state(bearing, example_bearings::static_load(-4450.0), {}, 0.0);
    ASSERT_TRUE(state.report.converged) << state.report.message;
    for (Eigen::Index j = 0; j <= 7; ++j) {
      const auto position = static_cast<std::size_t>(j);
      const double expected = position < row.loads.size() ? row.loads[position] : kUnloaded;
      EXPECT_NEAR(state.outer_load[j], expected, kPublished) << "roller " << j;
      EXPECT_NEAR(state.inner_load[j], expected, kPublished) << "roller " << j;
    }
  }
}

}  // namespace
}  // namespace orbearing::bearing::harris_209_test
