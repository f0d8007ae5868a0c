// Kinds of machines that a case can be of.
#pragma once

namespace orbearing::app {

/// As bits, so that several can be named at once.
enum Model : unsigned {
  no_model = 0,
  planetary_drivetrain = 1,
  roller_bearing = 2,
  gear_pair = 4,
  ball_bearing = 8,
  raceway_defect = 16,
  spin_film = 64,
  duplex_pair = 1u << 11,   // two rows of balls on one shaft
  ball_motion = 1u << 12,   // a ball bearing whose case has a block `simulation`: in time
  roller_defect = 1u << 13  // a raceway-defect whose bearing has rollers
};
inline constexpr unsigned with_rollers = planetary_drivetrain | roller_bearing;
/// A ball bearing under a load of its own, at rest or in time.
inline constexpr unsigned single_ball_bearing = ball_bearing | ball_motion;
inline constexpr unsigned with_balls = single_ball_bearing | raceway_defect | duplex_pair;

namespace model_sets {
/// Bearings in motion over time.
inline constexpr unsigned in_motion = planetary_drivetrain | ball_motion;
/// Balls in motion, and bearings with scratches, whose bodies can all move in time on request.
inline constexpr unsigned balls_in_time = ball_motion | raceway_defect;
inline constexpr unsigned in_time = in_motion | raceway_defect;
/// Bearings with scratches by themselves.
inline constexpr unsigned single_scratched = raceway_defect | roller_defect;
}  // namespace model_sets

/// Bearings that may have scratches: by themselves, or in a planet.
inline constexpr unsigned scratched_bearings = model_sets::single_scratched | planetary_drivetrain;
inline constexpr unsigned every_model = with_rollers | gear_pair | with_balls | roller_defect | spin_film;

/// In Field::required_by: a planetary set described by masses and stiffnesses instead of teeth.
inline constexpr unsigned toothless_set = 1u << 16;

}  // namespace orbearing::app
