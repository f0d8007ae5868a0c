#include "bearing/motion/model.hpp"

#include <gtest/gtest.h>

#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::motion::race_load_test {
namespace {

constexpr double kRoundOff = 4e-12;  // ten operations on powers whose logarithms reach a hundred
constexpr double kDifferenceError =
    1e-5;  // relative: central difference whose step is 1e-4 of the elastic approach

RaceModel inner_race(bool film) {
  const Bearing bearing = test::reducer_bearing();
  DynamicsParameters parameters = test::reducer_parameters();
  parameters.lubricant = {0.01, 1.5e-8};
  parameters.race.film_in_approach = film;
  return race_model(bearing, geometry_of(bearing), test::reducer_point(6000.0), Race::inner, parameters);
}

class RaceLoad : public testing::TestWithParam<double> {
 protected:
  Bearing bearing = test::reducer_bearing();
  LineContact elastic = roller_race_contact(bearing.contact_law, bearing.rollers().length);
  FilmContact contact = film_contact(bearing, geometry_of(bearing), Race::inner, {0.01, 1.5e-8});
  RaceModel law = inner_race(true);
  double speed = GetParam();

  double energy(double approach, double at_speed) const {
    return race_energy(law, elastic_approach_at(approach, at_speed), at_speed);
  }
  double elastic_approach_at(double approach, double at_speed) const {
    return elastic_approach(law.film_law, law.log_stiffness, approach, std::log(at_speed)).value;
  }
};

TEST_P(RaceLoad, InvertsTheQuasiStaticContact) {
  const RaceContact quasi_static(elastic, Film(contact, speed));
  for (double load = 1e-4; load < 1e5; load *= 3.0) {
    const double cancelled = 1.0 + quasi_static.film().central(load) / elastic.approach(load);
    EXPECT_NEAR(race_load(law, quasi_static.approach(load), speed), load, kRoundOff * cancelled * load);
  }
  EXPECT_EQ(race_load(law, quasi_static.onset() - 1e-12, speed), 0.0);
}

TEST_P(RaceLoad, StoresTheWorkOfTheLoad) {
  const RaceContact quasi_static(elastic, Film(contact, speed));
  for (double load = 0.03; load < 1e4; load *= 7.0) {
    const double approach = quasi_static.approach(load);
    const double step = 1e-4 * elastic.approach(load);
    const double slope = (energy(approach + step, speed) - energy(approach - step, speed)) / (2.0 * step);
    EXPECT_NEAR(slope, load, kDifferenceError * load);
    EXPECT_NEAR(energy(approach, speed), quasi_static.energy(load), kRoundOff * quasi_static.energy(load));
  }
}

TEST_P(RaceLoad, KnowsTheWorkOfAChangingFilm) {
  const RaceContact quasi_static(elastic, Film(contact, speed));
  for (double load = 0.03; load < 1e4; load *= 7.0) {
    const double approach = quasi_static.approach(load);
    const double film = quasi_static.film().central(load);
    const double step = 1e-4 * speed * std::min(1.0, elastic.approach(load) / film);
    const double slope = (energy(approach, speed + step) - energy(approach, speed - step)) / (2.0 * step);
    EXPECT_NEAR(race_energy_slope(law, elastic_approach_at(approach, speed), speed), slope,
                kDifferenceError * slope);
  }
}

INSTANTIATE_TEST_SUITE_P(Speeds, RaceLoad, testing::Values(0.01, 0.5, 8.0, 60.0));

TEST(RaceLoad, IsTheElasticContactWithoutFilm) {
  const RaceModel law = inner_race(false);
  const LineContact elastic(law.stiffness);
  EXPECT_NEAR(race_load(law, 2e-6, 5.0), elastic.load(2e-6), kRoundOff * elastic.load(2e-6));
  EXPECT_EQ(race_load(law, -1e-9, 5.0), 0.0);
  EXPECT_EQ(race_energy_slope(law, 2e-6, 5.0), 0.0);
}

}  // namespace
}  // namespace orbearing::bearing::motion::race_load_test
