#include "bearing/motion/race_load.hpp"

#include <gtest/gtest.h>

#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::motion::race_load_test {
namespace {

constexpr double kRoundOff = 4e-12;  // ten operations on powers whose logarithms reach a hundred
constexpr double kDifferenceError =
    1e-5;  // relative: central difference whose step is 1e-4 of the elastic approach

class RaceLoad : public testing::TestWithParam<double> {
 protected:
  Bearing bearing = test::reducer_bearing();
  LineContact elastic = roller_race_contact(bearing.contact_law, bearing.rollers().length);
  FilmContact contact = film_contact(bearing, geometry_of(bearing), Race::inner, {0.01, 1.5e-8});
  RaceLoadLaw law{elastic, contact};
  double speed = GetParam();
};

TEST_P(RaceLoad, InvertsTheQuasiStaticContact) {
  const RaceContact quasi_static(elastic, Film(contact, speed));
  for (double load = 1e-4; load < 1e5; load *= 3.0) {
    const double cancelled = 1.0 + quasi_static.film().central(load) / elastic.approach(load);
    EXPECT_NEAR(law.load(quasi_static.approach(load), speed), load, kRoundOff * cancelled * load);
  }
  EXPECT_EQ(law.load(quasi_static.onset() - 1e-12, speed), 0.0);
}

TEST_P(RaceLoad, StoresTheWorkOfTheLoad) {
  const RaceContact quasi_static(elastic, Film(contact, speed));
  for (double load = 0.03; load < 1e4; load *= 7.0) {
    const double approach = quasi_static.approach(load);
    const double step = 1e-4 * elastic.approach(load);
    const double slope =
        (law.energy(approach + step, speed) - law.energy(approach - step, speed)) / (2.0 * step);
    EXPECT_NEAR(slope, load, kDifferenceError * load);
    EXPECT_NEAR(law.energy(approach, speed), quasi_static.energy(load),
                kRoundOff * quasi_static.energy(load));
  }
}

TEST_P(RaceLoad, KnowsTheWorkOfAChangingFilm) {
  const RaceContact quasi_static(elastic, Film(contact, speed));
  for (double load = 0.03; load < 1e4; load *= 7.0) {
    const double approach = quasi_static.approach(load);
    const double film = quasi_static.film().central(load);
    const double step = 1e-4 * speed * std::min(1.0, elastic.approach(load) / film);
    const double slope =
        (law.energy(approach, speed + step) - law.energy(approach, speed - step)) / (2.0 * step);
    EXPECT_NEAR(law.energy_slope(approach, speed), slope, kDifferenceError * slope);
  }
}

INSTANTIATE_TEST_SUITE_P(Speeds, RaceLoad, testing::Values(0.01, 0.5, 8.0, 60.0));

TEST(RaceLoad, IsTheElasticContactWithoutFilm) {
  const LineContact elastic(8e8);
  const RaceLoadLaw law(elastic);
  EXPECT_NEAR(law.load(2e-6, 5.0), elastic.load(2e-6), kRoundOff * elastic.load(2e-6));
  EXPECT_EQ(law.load(-1e-9, 5.0), 0.0);
  EXPECT_EQ(law.energy_slope(2e-6, 5.0), 0.0);
}

}  // namespace
}  // namespace orbearing::bearing::motion::race_load_test
