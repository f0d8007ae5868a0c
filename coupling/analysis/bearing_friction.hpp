// Friction of one bearing that turns in a stated oil: by cause, by formulas of others, and the heat of the
// thermal reference speed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bearing/friction/published_torque.hpp"
#include "bearing/friction/rolling_friction.hpp"
#include "coupling/analysis/single_bearing.hpp"
#include "mechanics/record.hpp"

namespace orbearing::analysis {

/// Result of this program, for comparison with the formulas of other sources.
struct OurFriction {
  double speed = 0.0;       // [rad/s]  of the rings against each other
  double torque = 0.0;      // [N m]
  double rolling = 0.0;     // [N m]  of it: resistance to rolling
  double isothermal = 0.0;  // [N m]  that resistance without heating of the inlets; 0: not known
  double viscosity = 0.0;   // [m^2/s]  of the oil, kinematic
};

struct BearingFriction {
  bearing::friction::RollingFriction loss;  // [W]  mean over the positions of the cage
  double speed = 0.0;                       // [rad/s]  of the rings against each other
  double viscosity = 0.0;                   // [m^2/s]  of the oil, kinematic
  double least = 0.0, most = 0.0;           // [W]      in all, over the positions of the cage
  std::optional<double> oil_temperature{};  // [degC]   where the friction heats the oil

  OurFriction ours() const {
    return {speed, loss.total() / speed, loss.rolling / speed, loss.isothermal_rolling / speed, viscosity};
  }
};

void describe(described::Record& record, const BearingFriction& friction);

struct FrictionByStandards {
  bearing::friction::BearingSize size;
  bearing::friction::TorqueParts palmgren, gear_unit;
  bearing::friction::SkfTorque skf;
  OurFriction ours;  // with its resistance without heating
};

/// Torque of each formula by part, its power and our torque divided by it; the heat of [ISO15312] by the
/// size.
void describe(described::Record& record, const FrictionByStandards& standards);

/// Mean over the positions of the cage in a pitch, `stated` being the equilibrium at the stated one. Heated
/// oil has the temperature at which it carries off all heat; throws NoResult where that is too hot, or where
/// a position has no equilibrium. None where no ring rotates or no oil is stated.
std::optional<BearingFriction> rolling_friction(const RollersUnderLoad& in,
                                                const bearing::equilibrium::RingState& stated);
/// The same of balls. None besides where the width of the rings is not known or the equilibrium is that of
/// stationary balls.
std::optional<BearingFriction> rolling_friction(const BallsUnderLoad& in,
                                                const bearing::equilibrium::RingState& stated);

/// None where bore, outside diameter and width are not known, or nothing turns. `static_capacity` [N].
std::optional<FrictionByStandards> friction_by_standards(const LoadedBearing& in, const OurFriction& ours,
                                                         double static_capacity);

}  // namespace orbearing::analysis
