// A bearing with scratches in a housing, the model raceway-defect: inputs by the analyses that take them, its
// vibration in time, and the signal of an instrument on the outer ring.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bearing/defect/scratched_bearing.hpp"
#include "bearing/equilibrium/ring_balance.hpp"
#include "bearing/motion/balls/parameters.hpp"
#include "coupling/analysis/scratch_run.hpp"
#include "coupling/analysis/single_bearing.hpp"
#include "coupling/analysis/vibration_record.hpp"
#include "coupling/diagnosis/defect_view.hpp"
#include "coupling/system/steady_state.hpp"
#include "mechanics/conditional.hpp"
#include "mechanics/part_rows.hpp"
#include "mechanics/problem.hpp"

namespace orbearing::analysis {

/// Inputs of all runs of a bearing with scratches, whose outer ring is loaded and free.
struct ScratchedInHousing {
  bearing::equilibrium::RingLoad load;
  RingRotation rotation;
  bearing::Bearing bearing;
  bearing::defect::VibratingRing ring;
  bearing::defect::Scratch scratch;
  Sampling sampling;
  EnvelopeBand band;

  bearing::defect::ScratchedBearing bodies() const {
    return {.bearing = bearing,
            .ring = ring,
            .load = load.radial,
            .shaft_speed = rotation.shaft_speed,
            .scratch = scratch};
  }
};
/// `describe_bearing` gives the rows of the bearing.
template <class Visitor, class Call>
void describe(Visitor& visit, ScratchedInHousing& m, const Call& describe_bearing) {
  using namespace described;
  members(visit, m, part(m.load, [&] { describe_only(visit, m.load, m.load.radial); }),
          part(m.rotation,
               [&] { describe_without(visit, m.rotation, m.rotation.outer_speed, m.rotation.turning_race); }),
          part(m.bearing, describe_bearing), part(m.ring), part(m.scratch), part(m.sampling), part(m.band));
}

/// The outer ring on balls without mass.
struct RingOnBalls {
  ScratchedInHousing of{.bearing = {.elements = bearing::Balls{}}};

  static std::vector<mechanics::Conditional<RingOnBalls>> conditions();
};
template <class Visitor>
void describe(Visitor& visit, RingOnBalls& m) {
  using namespace described;
  members(visit, m, part(m.of, [&] {
            describe(visit, m.of,
                     [&] { describe_inside(visit, m.of.bearing, m.of.bearing.material.density); });
          }));
}

/// The outer ring on rollers without mass: the whole machine of such a case.
struct RingOnRollers {
  ScratchedInHousing of{.bearing = {.elements = bearing::CylindricalRollers{}}};

  static std::vector<mechanics::Conditional<RingOnRollers>> conditions();
};
template <class Visitor>
void describe(Visitor& visit, RingOnRollers& m) {
  using namespace described;
  members(visit, m, part(m.of, [&] {
            describe(visit, m.of, [&] {
              bearing::Bearing& in = m.of.bearing;  // whose contact laws are those of steel
              describe_inside(visit, in, in.material, in.rollers().laminae, in.rollers().profile);
            });
          }));
}

/// All that moves in a scratched ball bearing. Contacts and oil have their own damping, and the allowed error
/// is that of all bodies.
struct ScratchedBallsInMotion {
  ScratchedInHousing of{.bearing = {.elements = bearing::Balls{}}};
  bearing::balls::MotionParameters motion;
  double length_error = system::SteadyStateOptions{}.allowed_length_error;  // [m]  of one step

  static std::vector<mechanics::Conditional<ScratchedBallsInMotion>> conditions();
  /// Inputs of the cage, without which balls in cases that state no motion are complete.
  static std::vector<std::string> required();
};
inline const bearing::balls::MotionParameters& moving_balls(const ScratchedBallsInMotion& in) {
  return in.motion;
}
/// Rows of the motion and of the whole bearing, beside those of `rows`.
template <class Visitor, class Rows>
void describe_moving(Visitor& visit, Rows& rows, ScratchedBallsInMotion& m) {
  using namespace described;
  members(visit, m,
          part(m.of,
               [&] {
                 describe(rows, m.of, [&] {
                   describe_inside(visit, m.of.bearing);
                   describe_not_required(visit, m.of.bearing.cage);
                 });
               }),
          part(m.motion,
               [&] {
                 describe_without(visit, m.motion, m.motion.race.starvation, m.motion.mixture.flow,
                                  m.motion.mixture.fill, m.motion.inner);
               }),
          system::length_error_row(m.length_error));
}
template <class Visitor>
void describe(Visitor& visit, ScratchedBallsInMotion& m) {
  mechanics::RowsWithout<Visitor> rows(visit, m.of.ring.damping_ratio, m.of.ring.damping_law,
                                       m.of.sampling.length_error);
  describe_moving(visit, rows, m);
}

/// The machine of the model raceway-defect with balls.
struct ScratchedBallBearing {
  ScratchedBallsInMotion all;
};
template <class Visitor>
void describe(Visitor& visit, ScratchedBallBearing& m) {
  using namespace described;
  members(visit, m, part(m.all, [&] { describe_moving(visit, visit, m.all); }));
}

// Parts of both machines whose inconsistencies are found without the other inputs.

/// The scratch, and the diameter of the elements that roll over it.
struct ScratchOfBalls {
  bearing::defect::Scratch scratch;
  bearing::Balls balls;
};
template <class Visitor>
void describe(Visitor& visit, ScratchOfBalls& m) {
  described::members(visit, m, described::part(m.scratch), described::part(m.balls));
}
mechanics::Problems problems(const ScratchOfBalls& machine);

struct ScratchOfRollers {
  bearing::defect::Scratch scratch;
  bearing::CylindricalRollers rollers;
};
template <class Visitor>
void describe(Visitor& visit, ScratchOfRollers& m) {
  using namespace described;
  members(visit, m, part(m.scratch), part(m.rollers, [&] {
            describe_only(visit, m.rollers, m.rollers.count, m.rollers.diameter, m.rollers.length);
          }));
}
mechanics::Problems problems(const ScratchOfRollers& machine);

/// Load, speed and the samples of the signal.
struct SampledRing {
  bearing::equilibrium::RingLoad load;
  RingRotation rotation;
  Sampling sampling;
  EnvelopeBand band;
};
template <class Visitor>
void describe(Visitor& visit, SampledRing& m) {
  using namespace described;
  members(visit, m, part(m.load, [&] { describe_only(visit, m.load, m.load.radial); }),
          part(m.rotation,
               [&] { describe_without(visit, m.rotation, m.rotation.outer_speed, m.rotation.turning_race); }),
          part(m.sampling), part(m.band));
}
mechanics::Problems problems(const SampledRing& machine);

/// A ring on its contacts is not rigid at very high frequencies, and its motion would take hours.
mechanics::Problems problems(const RingOnBalls& machine);
mechanics::Problems problems(const RingOnRollers& machine);

/// The vibration of a bearing with scratches.
struct ScratchedVibration {
  bearing::defect::Scratched scratched = bearing::defect::Scratched::none;
  bool moving = false;                          // all bodies, balls and cage too
  bool rollers = false;                         // instead of balls
  bool run_up = false;                          // spectra are over orders of the shaft
  bearing::defect::PassingFrequencies passing;  // at pure rolling, at the end of a run-up
  bearing::defect::PassingFrequencies
      turned;  // means, as the cage turned: those of pure rolling unless moving
  std::optional<double>
      defect_frequency;  // [Hz]  at pure rolling, at the end of a run-up; none without a scratch
  bearing::defect::StaticPosition at_rest;
  double inner_depth = 0.0;  // [m]  deepest, on a scratch of the inner race
  double outer_depth = 0.0;  // [m]
  RingVibration vibration;
  diagnosis::InstrumentView view;  // acceleration of the outer ring along the load [m/s^2]
  std::vector<std::string> warnings;

  double largest_load() const { return vibration.largest_load; }   // [N]  of an element
  std::vector<std::pair<std::string, std::string>> files() const;  // of the signal: name, content
};

/// `disturb` may add to the recorded signal before it is analysed.
using Disturb = std::function<void(RingVibration&)>;

/// The outer ring alone moves. Throws NoResult where its motion cannot be integrated.
ScratchedVibration vibration_of_ring(const ScratchedInHousing& in, const Disturb& disturb = {});
ScratchedVibration ring_on_balls(const RingOnBalls& in);
ScratchedVibration ring_on_rollers(const RingOnRollers& in);
/// All bodies move. `progress` gets the share done, if any. Throws NoResult likewise.
ScratchedVibration moving_scratched_balls(const ScratchedBallsInMotion& in,
                                          const std::function<void(double)>& progress = {});
ScratchedVibration vibration_in_motion(const ScratchedBallsInMotion& in,
                                       const std::function<void(double)>& progress = {},
                                       const Disturb& disturb = {});

void describe(described::Record& record, const ScratchedVibration& result);

/// [s]  from the start to the last sample
double time_of_signal(const ScratchedInHousing& in);

/// Quantities that follow from the inputs.
struct ScratchQuantities {
  bearing::defect::PassingFrequencies passing;  // at pure rolling
  bearing::defect::StaticPosition at_rest;
};
void describe(described::Record& record, const ScratchQuantities& quantities);
ScratchQuantities quantities_of(const ScratchedBallBearing& machine);
ScratchQuantities quantities_of(const RingOnRollers& machine);

}  // namespace orbearing::analysis
