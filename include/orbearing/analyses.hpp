// Analyses of cases as functions: results are structures in SI, with the values that the program prints.
//
// Every function throws BadInput for a case that the analysis cannot take, and ComputationFailed where the
// solver finds no result.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "coupling/analysis/bearing_under_load.hpp"
#include "coupling/analysis/gear_modes.hpp"
#include "coupling/analysis/operating_point.hpp"
#include "coupling/analysis/set_meshes.hpp"
#include "mechanics/described.hpp"
#include "orbearing/case.hpp"

namespace orbearing {

using analysis::Fidelity;

/// One turn a minute, for speeds: 6000 * rpm. [rad/s]
inline constexpr double rpm = described::dimension::kTurn;

/// A result with what `orbearing` warns of.
template <class Result>
struct Warned {
  Result result;
  std::vector<std::string> warnings;
};

/// The operating point that a drivetrain states, its sweep left out. The governing life of the worst bearing
/// is `governing_life_hours`.
struct OperatingPoint : analysis::PointResult {
  double governing_life_hours = 0.0;  // [h]
};
Warned<OperatingPoint> quasi_static(const Case& drivetrain);
/// Its bearings in motion: driven by the gears, co-simulated with them, or as one system with them.
Warned<OperatingPoint> in_motion(const Case& drivetrain, Fidelity fidelity = Fidelity::dynamic);

/// The points of a sweep, in the order of their table.
struct Sweep {
  std::vector<analysis::PointRow> points;
  std::vector<double> governing_life_hours;  // [h]  (points)  not a number: the point has none
  std::optional<std::size_t> longest_lived;  // the point with the longest life; none: no point has one
  std::string life;                          // key of the governing life among results, as "L10mrh"
};
struct SweepChoices {
  std::vector<double> speeds{};  // [rad/s]  of the input, instead of the sweep of the case; none: that
  Fidelity fidelity = Fidelity::quasi_static;
  bool grid_alone = false;  // else points are added around the longest life until its speed is known
  int jobs = 0;             // threads; 0: one for each core
};
Warned<Sweep> sweep(const Case& drivetrain, const SweepChoices& choices = {});

/// A roller or ball bearing under its static load.
analysis::BearingUnderLoad under_load(const Case& bearing);

/// Meshes of a pair of gears, or of a single planetary set: stiffness over the period, phases, contact ratio.
analysis::MeshStudy mesh(const Case& gears);

/// Natural frequencies of the gears of a single planetary set, without rotation.
Warned<analysis::ModeStudy> modes(const Case& gears);

/// A profile of rollers with the worst of its results over the tilts studied.
struct CrownedRoller {
  std::string profile;         // kind, as in bearing.profile.kind
  double drop = 0.0;           // [m]  at the outermost of 40 laminae
  double life_hours = 0.0;     // [h]  the governing life
  double peak_pressure = 0.0;  // [Pa]
};
struct Crowning {
  CrownedRoller recommended, longest_lived, straight, by_standard;
};
/// The trade study of roller crowning with the defaults of `orbearing crown`.
Warned<Crowning> crown(const Case& drivetrain, int jobs = 0);

}  // namespace orbearing
