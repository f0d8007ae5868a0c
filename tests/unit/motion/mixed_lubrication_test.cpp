#include "bearing/motion/mixed_lubrication.hpp"

#include <gtest/gtest.h>

#include "bearing/motion/race_model.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::dynamics::mixed_lubrication_test {
namespace {

constexpr double kRoundOff = 1e-12;

TEST(MixedLubrication, ShareGoesFromAllToNothing) {
  EXPECT_EQ(asperity_share(0.0), 1.0);
  EXPECT_DOUBLE_EQ(asperity_share(1.0), 0.25);
  EXPECT_LT(asperity_share(1e6), 1e-11);
  for (double ratio = 0.01; ratio < 100.0; ratio *= 1.3)
    EXPECT_GT(asperity_share(ratio), asperity_share(1.3 * ratio));
}

TEST(MixedLubrication, FilmIsThatOfTheQuasiStaticContact) {
  const CylindricalRollerBearing bearing = test::reducer_bearing();
  const FilmContact contact = film_contact(bearing, geometry_of(bearing), Race::outer, {0.01, 1.5e-8});
  const LeastFilm film(contact);
  for (double speed : {0.01, 1.0, 40.0})
    for (double load = 1e-4; load < 1e5; load *= 7.0) {
      const double expected = Film(contact, speed).least(load);
      EXPECT_NEAR(film.at(load, speed), expected, kRoundOff * expected) << load << " N, " << speed << " m/s";
    }
}

class MixedRace : public testing::Test {
 protected:
  RaceModel model(double roughness) const {
    DynamicsParameters parameters = test::reducer_parameters();
    parameters.race.lubrication = Lubrication::mixed;
    parameters.race.traction = TractionLaw::limiting_shear;
    parameters.race.roughness = roughness;
    return race_model(test::reducer_bearing(), test::reducer_point(6000.0), Race::inner, parameters);
  }
};

// A surface far rougher than the film slides like asperities alone, one far smoother like the film alone.
TEST_F(MixedRace, LimitsAreBoundaryFrictionAndTheFilmAlone) {
  const double load = 400.0, sliding = 0.7, speed = 9.0;
  const RaceModel smooth = model(1e-15), rough = model(1e3);
  const double film = smooth.traction.force(load, sliding, speed);
  EXPECT_NEAR(smooth.mixed.shared(film, load, sliding, speed), film, 1e-10 * film);
  const double boundary = regularised_friction(0.12, load, sliding, 0.1);
  EXPECT_NEAR(rough.mixed.shared(film, load, sliding, speed), boundary, 1e-8 * boundary);
}

TEST_F(MixedRace, FrictionNeverGivesPower) {
  const RaceModel race = model(0.2e-6);
  for (double load : {1e-3, 1.0, 300.0, 5000.0})
    for (double sliding : {-8.0, -0.01, 0.0, 1e-6, 0.4, 20.0})
      for (double speed : {0.01, 2.0, 30.0}) {
        const double film = race.traction.force(load, sliding, speed);
        EXPECT_GE(race.mixed.shared(film, load, sliding, speed) * sliding, 0.0);
      }
}

}  // namespace
}  // namespace orbearing::bearing::dynamics::mixed_lubrication_test
