// Natural modes of the gears of a planetary set, and their frequencies over speed.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "gearset/dynamics/modes.hpp"
#include "mechanics/record.hpp"

namespace orbearing::analysis {

/// "rotational", "translational" or "planet".
const char* kind_name(gearset::dynamics::ModeKind kind);

/// Modes and the frequency by which published ones may be recognised.
struct ModeStudy {
  std::vector<gearset::dynamics::Mode> modes;
  double planet_frequency = 0.0;  // [Hz]  of a planet on its bearing alone
};
void describe(described::Record& record, const ModeStudy& study);

/// Displacements of a mode over the largest of them: a row (x, y, u) for sun, ring, carrier and each planet,
/// as the state has them. Those of a planet are outward and in the sense of carrier rotation; u is a rotation
/// times the member's radius. Of several shapes of one frequency the combination in which one displacement is
/// as large as it can be: of equal ones, the first.
struct ModeShape {
  Eigen::MatrixX3d position;  // [-]  (members, 3)  where the largest has its largest value
  Eigen::MatrixX3d quarter;   // [-]  (members, 3)  a quarter of a period later; zero without rotation
};
ModeShape shape_of(const gearset::dynamics::Mode& mode);

/// Modes without rotation, or in the frame of the carrier at the speed of the model.
ModeStudy mode_study(const gearset::dynamics::SetModel& model, bool at_speed = false);

/// Natural frequencies and mesh harmonics over speed, for a Campbell diagram.
struct Campbell {
  static constexpr std::size_t harmonics = 4;

  std::vector<double> speeds;                                 // [rad/s]
  Eigen::MatrixXd frequencies;                                // [Hz]  (speeds, modes)
  std::vector<std::array<double, harmonics>> mesh_harmonics;  // [Hz]  (speeds)
};
void describe(described::Record& record, const Campbell& diagram);

/// From rest to the nominal speed [rad/s], which is that of the model.
Campbell campbell(const gearset::dynamics::SetModel& model, double nominal_speed);

}  // namespace orbearing::analysis
