// What the form of a race changes in a contact. The load stays the slope of the stored energy:
//
//   approach = s (distance - R(phi)) + a,   phi: angle of the normal n
//   force on the roller = -load d(approach)/d(position) = -s load n + s load R'(phi) / distance t
//
// so that a small tangential force joins the normal one; its moment about the race's centre, s load R', goes
// to the race, for the roller is round and takes none. A scratch of the race is a form too. One of the roller is
// as well, but turns with the roller, which then takes the moment.
#pragma once

#include <Eigen/Core>

#include "bearing/contact/race_form.hpp"
#include "bearing/contact/surface_scratch.hpp"
#include "bearing/motion/contact_motion.hpp"

namespace orbearing::bearing::motion {

/// Slopes of the form at a contact [m/rad]; zero on a round race.
struct FormSlope {
  double all = 0.0;      // R'(phi)
  double turning = 0.0;  // the share that turns with the race
  double rolling = 0.0;  // the share that turns with the roller
};

/// The waves of an elastic race at one instant: places [m] and speeds [m/s], in the order of
/// equilibrium/elastic_waves.hpp.
struct RaceWaves {
  const double* place = nullptr;  // (count)
  const double* speed = nullptr;  // (count)
  Eigen::Index count = 0;         // [-]
};

/// Puts them into approach and approach speed of `motion`, as a form that stands in the carrier and changes:
///   approach speed = s (v_n - w' line_speed - dw/dt).
void add_waves(const RaceWaves& waves, double side, ContactMotion& motion, FormSlope& slope);

/// Adds to `force` [N] (waves) what a load [N] on the outer race along `normal` does to each wave: the slope of
/// the stored energy.
void add_wave_forces(double load, const Vector2& normal, Eigen::Ref<Eigen::VectorXd> force);

/// Puts the form of a race, which turns at `race.speed` and has turned by `race.angle`, into approach and
/// approach speed of `motion`, whose line of centres turns at line_speed:
///   approach speed = s (v_n - R' line_speed + R'_turning race speed).
FormSlope add_form(const std::vector<RaceHarmonic>& form, double side, const BodyMotion& race,
                   ContactMotion& motion);

/// The same for scratches of the race.
void add_scratches(const std::vector<RaceScratch>& scratches, double side, const BodyMotion& race,
                   ContactMotion& motion, FormSlope& slope);
/// And for those of roller number `roller`, which has turned by `body.angle`.
void add_scratches(const std::vector<RollerScratch>& scratches, int roller, const BodyMotion& body, double side,
                   ContactMotion& motion, FormSlope& slope);

}  // namespace orbearing::bearing::motion
