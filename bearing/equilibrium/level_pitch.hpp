// Quasi-static equilibria of a bearing whose rollers stay level, over one roller pitch of cage angles,
// vectorised over these: what lamina_state() or quasi_static_state() gives at each, for studies that ask for
// a great many. All instruction sets give the same bits.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "bearing/equilibrium/equilibrium_batch.hpp"
#include "bearing/equilibrium/lamina_bearing.hpp"

namespace orbearing::bearing::vectorised {

/// Equilibria at all cage angles, arrays over these (positions) and rollers.
struct PitchResults {
  Eigen::Vector2d load = Eigen::Vector2d::Zero();  // [N]  on the bore
  Eigen::Array2Xd displacement;            // [m]    (x and y, positions)  outer ring relative to inner ring
  std::vector<Eigen::Matrix2d> stiffness;  // [N/m]  (positions)
  Eigen::ArrayXXd inner_load, outer_load;  // [N]    (positions, rollers)
  std::vector<double> rollers;             // of EquilibriumOutput, block by block
  std::vector<SolverReport> reports;       // (positions)
};

/// The solver for one bearing: whole contacts, or laminae whose drops are the same at both ends and on both
/// races, dry. Not for use by two threads at once.
class LevelPitch {
 public:
  /// None where rollers tilt between aligned races, or races are not round or have a film. Throws
  /// std::invalid_argument where the bearing has an unsound profile.
  static std::optional<LevelPitch> of(const Bearing& bearing, const QuasiStaticOptions& options,
                                      mechanics::InstructionSet set = mechanics::best_instruction_set());
  /// Whether races are aligned and rigid at `point`.
  static bool holds(const OperatingPoint& point) {
    return point.outer_race.is_rigid() && point.bore_tilt.isZero(0.0);
  }

  /// At cage angles evenly spaced over a pitch from options.first_roller on. Where a position's report says
  /// that it did not converge, its loads are those of the last iterate. Throws std::invalid_argument where a
  /// load or speed is not finite. The searches start by themselves; or, where `near` holds the results of
  /// this bearing under another load, along their tangents.
  void solve(const OperatingPoint& point, PitchResults& results, const PitchResults* near = nullptr);
  /// The same as a LaminaResult without its states, of a bearing with laminae; none where a position did not
  /// converge.
  std::optional<laminae::LaminaResult> laminae_under(const laminae::LaminaBearing& cut,
                                                     const OperatingPoint& point,
                                                     const PitchResults* near = nullptr);

 private:
  LevelPitch(const Bearing& bearing, const QuasiStaticOptions& options, UnlikeLaminae laminae,
             std::vector<std::size_t> lamina_of, mechanics::InstructionSet set);
  void solve(const OperatingPoint& point, PitchResults& results, const PitchResults* near,
             double* lamina_loads);
  Eigen::Vector2d start(const OperatingPoint& point, const PitchResults& near, int position) const;

  Bearing bearing_;
  QuasiStaticOptions options_;
  std::size_t unlike_;                  // laminae
  std::vector<std::size_t> lamina_of_;  // (laminae of a contact)  which of these it is
  EquilibriumBlock block_;
  std::vector<double> lamina_loads_;  // of EquilibriumOutput, block by block
};

}  // namespace orbearing::bearing::vectorised
