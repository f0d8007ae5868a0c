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

struct FrictionStudy {
  bearing::friction::RollingFriction loss;  // [W]
  double speed = 0.0;                       // [rad/s]  of the rings against each other
  double viscosity = 0.0;                   // [m^2/s]  of the oil, kinematic
  std::optional<double> oil_temperature{};  // [degC]   where the friction heats the oil

  double torque() const { return loss.total() / speed; }  // [N m]
};

void describe(described::Record& record, const FrictionStudy& study);

struct FrictionByStandards {
  bearing::friction::BearingSize size;
  bearing::friction::PartedTorque palmgren, gear_unit;
  bearing::friction::SkfTorque skf;
  double speed = 0.0;       // [rad/s]
  double ours = 0.0;        // [N m]
  double rolling = 0.0;     // [N m]  of it: resistance to rolling
  double isothermal = 0.0;  // [N m]  that resistance without heating of the inlets
};

/// Of each formula its torque by part, its power and ours over it; the heat of [ISO15312] by the size.
void describe(described::Record& record, const FrictionByStandards& standards);

/// Oil as contacts have it.
struct OilInContacts {
  bearing::Lubricant lubricant;
  double viscosity_slope = 0.0;  // [1/K]  by which its viscosity falls
};

/// The oil of a case that states its viscosity, by grade or directly; none where it states neither, or a
/// viscosity that no mineral oil has at the default temperature.
std::optional<OilInContacts> oil_in_contacts(const ResolvedCase& in);

/// With `heat.enabled` at the temperature at which the oil leaves with all heat; throws ComputationFailed
/// where that is too hot. None where no ring turns, no oil is stated, or, of balls, the width of the rings is
/// not known or the balance is that of balls at rest.
std::optional<FrictionStudy> friction_study(const ResolvedCase& in, const bearing::Bearing& bearing,
                                            const bearing::equilibrium::RingState& balance);

/// What the program finds, of which the formulas of others are to be beside.
struct OurFriction {
  double speed = 0.0;            // [rad/s]  of the rings against each other
  double torque = 0.0;           // [N m]
  double rolling = 0.0;          // [N m]  of it: resistance to rolling
  double isothermal = 0.0;       // [N m]  that resistance without heating of the inlets; 0: not known
  double viscosity = 0.0;        // [m^2/s]  of the oil, kinematic
  double static_capacity = 0.0;  // [N]
};

/// None where bore, outside diameter and width are not known, or nothing turns.
std::optional<FrictionByStandards> friction_by_standards(const ResolvedCase& in, const OurFriction& ours);

}  // namespace orbearing::app
