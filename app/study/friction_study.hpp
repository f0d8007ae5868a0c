// Friction of one bearing that turns in a stated oil: by cause, by formulas of others, and the heat of the
// thermal reference speed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "bearing/friction/published_torque.hpp"
#include "bearing/friction/rolling_friction.hpp"
#include "mechanics/record.hpp"

namespace orbearing::app {

/// Result of this program, for comparison with the formulas of other sources.
struct OurFriction {
  double speed = 0.0;       // [rad/s]  of the rings against each other
  double torque = 0.0;      // [N m]
  double rolling = 0.0;     // [N m]  of it: resistance to rolling
  double isothermal = 0.0;  // [N m]  that resistance without heating of the inlets; 0: not known
  double viscosity = 0.0;   // [m^2/s]  of the oil, kinematic
};

struct FrictionStudy {
  bearing::friction::RollingFriction loss;  // [W]  mean over the positions of the cage
  double speed = 0.0;                       // [rad/s]  of the rings against each other
  double viscosity = 0.0;                   // [m^2/s]  of the oil, kinematic
  double least = 0.0, most = 0.0;           // [W]      in all, over the positions of the cage
  std::optional<double> oil_temperature{};  // [degC]   where the friction heats the oil

  OurFriction ours() const {
    return {speed, loss.total() / speed, loss.rolling / speed, loss.isothermal_rolling / speed, viscosity};
  }
};

void describe(described::Record& record, const FrictionStudy& study);

struct FrictionByStandards {
  bearing::friction::BearingSize size;
  bearing::friction::PartedTorque palmgren, gear_unit;
  bearing::friction::SkfTorque skf;
  OurFriction ours;  // with its resistance without heating
};

/// Torque of each formula by part, its power and our torque divided by it; the heat of [ISO15312] by the
/// size.
void describe(described::Record& record, const FrictionByStandards& standards);

/// Equilibrium of the bearing of a case under its load. Throws ComputationFailed where there is none.
bearing::equilibrium::RingState balance_of(const ResolvedCase& resolved, const bearing::Bearing& bearing);

/// Mean over the positions of the cage in a pitch, `stated` being the equilibrium at the stated one. With
/// `heat.enabled` at the temperature at which the oil carries off all heat; throws ComputationFailed where
/// that is too hot, or where a position has no equilibrium. None where no ring rotates, no oil is stated, or,
/// for balls, the width of the rings is not known or the equilibrium is that of stationary balls.
std::optional<FrictionStudy> friction_study(const ResolvedCase& in, const bearing::Bearing& bearing,
                                            const bearing::equilibrium::RingState& stated);

/// None where bore, outside diameter and width are not known, or nothing turns. `static_capacity` [N].
std::optional<FrictionByStandards> friction_by_standards(const ResolvedCase& in, const OurFriction& ours,
                                                         double static_capacity);

}  // namespace orbearing::app
