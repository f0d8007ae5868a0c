// Quasi-static transmission error: how far the gears approach each other under a constant force while they
// turn by one mesh period.
#pragma once

#include <functional>
#include <vector>

#include "gearset/mesh/loaded/loaded_teeth.hpp"

namespace orbearing::gearset {

/// Along the line of action; positive: the driven gear stays behind.
struct TransmissionError {
  double force = 0.0;               // [N]  in the transverse section
  double mean = 0.0;                // [m]
  double peak_to_peak = 0.0;        // [m]
  std::vector<double> harmonics{};  // [m]  amplitudes of orders 1, 2, ... of the mesh frequency
  std::vector<double> curve{};  // [m]  in the middle of equal steps of the period, from where a pair begins
};

inline constexpr int transmission_samples = 720;  // a period
inline constexpr int transmission_orders = 8;

/// Transmission error of teeth under load; without a force their unloaded error, which is caused by relief
/// only.
TransmissionError transmission_error(const LoadedTeeth& teeth, double force);

/// Transmission error of a prescribed stiffness: force / stiffness.
TransmissionError transmission_error(const PeriodicCurve& stiffness, double force);

/// The teeth about a constant force, as a spring: its stiffness over the period, and the approach at which it
/// would be free.
struct TangentSpring {
  PeriodicCurve stiffness;  // [N/m]  with steps where pairs come and go
  double free = 0.0;        // [m]  mean approach less force / mean stiffness
};

/// @param force [N] greater than 0
TangentSpring tangent_spring(const LoadedTeeth& teeth, double force);

}  // namespace orbearing::gearset
