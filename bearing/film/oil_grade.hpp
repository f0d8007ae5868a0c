// A mineral oil by its viscosity grade, or by its viscosities at 40 and 100 degC: its viscosities at running
// temperature.
//
//   (1)  lg lg (nu + 0.7) = A - B lg T, nu in mm^2/s, T in K [ASTMD341]; through the grade at 40 degC and the
//        viscosity at 100 degC, stated or that which the viscosity index gives [ASTMD2270]
//   (2)  alpha = 2.657e-8 eta_38^0.1348 (1 + 516 (1/T - 1/311)) in 1/Pa, eta_38 in Pa s at 38 degC
//   [ISOTR15144]
//
// The coefficients of (2) are from memory of the source. The density is taken as that at running temperature.
#pragma once

#include <optional>

#include "bearing/parameters.hpp"

namespace orbearing::bearing {

/// An oil as its data sheet states it.
struct OilGrade {
  double viscosity_40 = 0.0;      // [m^2/s]  kinematic, at 40 degC: the number of the ISO VG grade [ISO3448]
  double viscosity_index = 95.0;  // [-]
  double density = 850.0;         // [kg/m^3]
  std::optional<double> viscosity_100{};  // [m^2/s]  kinematic, at 100 degC; none: by the viscosity index

  bool operator==(const OilGrade&) const = default;
};

/// Kinematic viscosity at 100 degC [m^2/s] of an oil with that viscosity index (at most 100) and
/// `viscosity_40` [m^2/s]. Throws std::invalid_argument where that is below 2 mm^2/s, at which [ASTMD2270]
/// begins.
double viscosity_at_100(double viscosity_40, double viscosity_index);

/// Kinematic viscosity [m^2/s] at `temperature` [degC], by (1). Good between -20 and 150 degC.
double kinematic_viscosity(const OilGrade& oil, double temperature);

/// Relative decrease of the viscosity per kelvin [1/K] at `temperature` [degC]: the slope of (1).
double viscosity_slope(const OilGrade& oil, double temperature);

/// Dynamic viscosity and pressure-viscosity coefficient at `temperature` [degC], by (1) and (2).
Lubricant lubricant_at(const OilGrade& oil, double temperature);

}  // namespace orbearing::bearing
