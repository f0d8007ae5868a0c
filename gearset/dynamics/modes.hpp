// Natural frequencies of the set and what each mode is.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gearset/dynamics/mode_kind.hpp"
#include "gearset/dynamics/model.hpp"

namespace orbearing::gearset::dynamics {

/// Modes of one frequency and kind.
struct Mode {
  double frequency = 0.0;  // [Hz]
  double growth = 0.0;     // [1/s]  rate at which the motion grows; 0 where it only swings
  ModeKind kind = ModeKind::rotational;
  int multiplicity = 1;
  Eigen::MatrixXcd shapes;  // (freedoms, multiplicity)  mass-normalised
};

/// Undamped modes at rest, ascending, linearised about mean stiffness with all loaded flanks in contact.
/// A rotation that costs nothing has frequency zero.
std::vector<Mode> modes_at_rest(const SetModel& model);

/// Undamped modes in the frame of the carrier at the nominal speed, gyroscopic and centrifugal terms
/// included.
std::vector<Mode> modes_at_speed(const SetModel& model);

/// Natural frequencies [Hz] over speed: as many rows as the set has free freedoms, ascending.
/// @param factors on the nominal speeds
Eigen::MatrixXd campbell_frequencies(const SetModel& model, const std::vector<double>& factors);

}  // namespace orbearing::gearset::dynamics
