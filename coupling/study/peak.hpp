// The speed at which life is longest, between the points of a grid.
#pragma once

#include <functional>

#include "coupling/study/operating_point.hpp"

namespace orbearing::study {

/// An extremum of a quantity over speed.
struct Extremum {
  double speed = 0.0;   // [rad/s]
  double value = 0.0;   // unit of the function
  bool inside = false;  // false: at an end of the bracket, where the function still rises (or falls)
};

/// Largest value of a positive function of speed between `low` and `high` [rad/s], by Brent's method on the
/// logarithms of both. The function must have one maximum there. The speed is good to about 1e-6 of itself:
/// the loads balance to 1e-12, and a smooth maximum is located to the square root of the noise of its values.
Extremum largest(const std::function<double(double)>& of_speed, double low, double high);

/// The same for the smallest value.
Extremum smallest(const std::function<double(double)>& of_speed, double low, double high);

/// Life [h] of one bearing at input speed `speed` [rad/s], all else as in `drivetrain`.
double life_at(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry, double speed);

}  // namespace orbearing::study
