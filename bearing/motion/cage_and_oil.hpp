// Drag of the oil-air mixture, which rests in the carrier frame, on rollers and cage.
#pragma once

#include <cmath>
#include <optional>

#include "bearing/contact/land_law.hpp"
#include "bearing/motion/parameters.hpp"

namespace orbearing::bearing::motion {

/// Resistance that grows with the square of a speed: force (or moment) -coefficient speed |speed|.
struct QuadraticDrag {
  double coefficient = 0.0;  // [N s^2/m^2] or [N m s^2/rad^2]

  /// [N] or [N m]
  double force(double speed) const { return -coefficient * speed * std::abs(speed); }
  /// Dissipated [W], >= 0.
  double power(double speed) const { return coefficient * speed * speed * std::abs(speed); }
};

/// Drag across a roller of `diameter` and `length` [m] in a mixture of `density` [kg/m^3]: 1/2 C_d rho D l
/// v^2, [Harris2006].
inline QuadraticDrag translation_drag(double density, double drag_coefficient, double diameter,
                                      double length) {
  return {0.5 * drag_coefficient * density * diameter * length};
}

/// Churning moment on a turning drum: 1/2 C_n rho omega^2 R^4 l, after [Rumbarger1973].
inline QuadraticDrag churning_drag(double density, double churning_coefficient, double radius,
                                   double length) {
  return {0.5 * churning_coefficient * density * std::pow(radius, 4.0) * length};
}

// The lands of a ring that guide the cage, from what the user states; their law: contact/land_law.hpp.

/// Lands that guide a cage, and what they do together.
struct GuidingLands {
  double width = 0.0;  // [m]  of one
  LandLaw law;
};

/// `lands` of them, in oil of `viscosity` [Pa s]; none where no diameter of theirs is given. Throws
/// std::invalid_argument where they have no clearance or no width.
std::optional<GuidingLands> guiding_lands(const Bearing& bearing, const CageParameters& given, int lands,
                                          double viscosity, double sliding_scale);

}  // namespace orbearing::bearing::motion
