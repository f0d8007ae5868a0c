// The film of [Guo2013] in the equilibrium of its bearing 7210: 40 degrees, 10 kN along the axis, 0 to 15000
// rpm. Number and size of balls are not printed: those of a catalogue bearing of this size are assumed.
#include <gtest/gtest.h>

#include "bearing/equilibrium/row_group.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::equilibrium::ball_film_test {
namespace {

constexpr double kDegree = constants::degree;
constexpr double kRpm = constants::pi / 30.0;

Bearing bearing_7210() {
  return {.inner = {.osculation = 0.52},
          .outer = {.osculation = 0.52},
          .elements = Balls{.count = 15, .diameter = 12.7e-3, .contact_angle = 40.0 * kDegree},
          .pitch_diameter = 70e-3};
}

const Lubricant oil{.viscosity = 0.01988, .pressure_viscosity = 19.75e-9};

RingState at(double rpm, bool film) {
  RowMotion motion{.speeds = {.inner = rpm * kRpm}};
  if (film) motion.film = oil;
  RingState state = balance_bearing(bearing_7210(), motion, {.axial = 10000.0});
  EXPECT_TRUE(state.report.converged) << rpm << " " << state.report.message;
  return state;
}

// Figs. 7 to 10: loads and angles hardly change, the ring moves less, and the more so the faster it turns.
TEST(BallFilm, TheRingMovesLess) {
  double before = 0.0;
  for (const double rpm : {3000.0, 6000.0, 9000.0, 12000.0, 15000.0}) {
    const RingState dry = at(rpm, false), film = at(rpm, true);
    const double difference = dry.axial - film.axial;
    EXPECT_GT(difference, before) << rpm;
    before = difference;
    EXPECT_NEAR(film.contact_load[0] / dry.contact_load[0], 1.0, 0.02) << rpm;
    EXPECT_NEAR(film.outer_load[0] / dry.outer_load[0], 1.0, 0.02) << rpm;
    EXPECT_NEAR(film.contact_angle[0] / dry.contact_angle[0], 1.0, 0.02) << rpm;
  }
}

// Figs. 11 and 12: spin makes the least film fall beyond some speed, the central one never.
TEST(BallFilm, TheLeastFilmTurnsOverWithSpeed) {
  const Bearing bearing = bearing_7210();
  for (const Race race : {Race::inner, Race::outer}) {
    const film::EllipticalContact contact = film::ball_contact(bearing, race);
    double highest = 0.0, highest_at = 0.0, central = 0.0, last = 0.0;
    for (double rpm = 500.0; rpm <= 15000.0; rpm += 500.0) {
      JonesRow row(bearing, {.speeds = {.inner = rpm * kRpm}, .film = oil});
      ASSERT_TRUE(balance_ring(row, {.axial = 10000.0}).report.converged) << rpm;
      const JonesBall& ball = row.balls().front();
      const bool inner = race == Race::inner;
      const film::Films films =
          film::spin_films(contact, oil,
                           {.load = inner ? ball.inner_load : ball.outer_load,
                            .rolling = inner ? ball.motion.inner_rolling : ball.motion.outer_rolling,
                            .spin = inner ? ball.motion.inner_spin : ball.motion.outer_spin});
      EXPECT_GT(films.central, central) << rpm;
      central = films.central;
      last = films.least;
      if (films.least > highest) {
        highest = films.least;
        highest_at = rpm;
      }
      RecordProperty((inner ? "inner_" : "outer_") + std::to_string(static_cast<int>(rpm)),
                     std::to_string(1e6 * films.least));
    }
    RecordProperty(race == Race::inner ? "inner_turns_at" : "outer_turns_at", std::to_string(highest_at));
    if (race == Race::inner) {
      EXPECT_LT(last, highest);
    }
  }
}

// The stiffness that the film adds to is still the slope of the forces.
TEST(BallFilm, StiffnessIsTheSlopeOfTheForces) {
  const RowMotion motion{.speeds = {.inner = 9000.0 * kRpm}, .film = oil};
  JonesRow row(bearing_7210(), motion);
  const RingState state = balance_ring(row, {.radial = 2000.0, .axial = 10000.0});
  ASSERT_TRUE(state.report.converged);
  const RingPosition position = position_of(state, row.lever());
  const RingImbalance here = row_forces(row, position);
  constexpr double step = 2e-9;  // [m]
  for (int i = 0; i < 5; ++i) {
    const RingPosition aside = step * RingPosition::Unit(i);
    const RingPosition slope =
        (row_forces(row, position - aside).force - row_forces(row, position + aside).force) / (2.0 * step);
    EXPECT_NEAR((slope - here.stiffness.col(i)).norm() / here.stiffness.norm(), 0.0, 1e-6) << i;
  }
}

// All members of the motion are interpolated like the spin.
TEST(BallMotionBetween, MixesEachMemberWithItself) {
  const BallMotion<double> a{1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0}, b{10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0};
  const BallMotion<double> mixed = ball_detail::between(a, b, 0.25);
  EXPECT_DOUBLE_EQ(mixed.orbit, 0.75 * a.orbit + 0.25 * b.orbit);
  EXPECT_DOUBLE_EQ(mixed.radial_spin, 0.75 * a.radial_spin + 0.25 * b.radial_spin);
  EXPECT_DOUBLE_EQ(mixed.axial_spin, 0.75 * a.axial_spin + 0.25 * b.axial_spin);
  EXPECT_DOUBLE_EQ(mixed.inner_spin, 0.75 * a.inner_spin + 0.25 * b.inner_spin);
  EXPECT_DOUBLE_EQ(mixed.outer_spin, 0.75 * a.outer_spin + 0.25 * b.outer_spin);
  EXPECT_DOUBLE_EQ(mixed.inner_rolling, 0.75 * a.inner_rolling + 0.25 * b.inner_rolling);
  EXPECT_DOUBLE_EQ(mixed.outer_rolling, 0.75 * a.outer_rolling + 0.25 * b.outer_rolling);
}

}  // namespace
}  // namespace orbearing::bearing::equilibrium::ball_film_test
