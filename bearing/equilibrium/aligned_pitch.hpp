// Quasi-static equilibria of a bearing whose rollers stay level, over one roller pitch of cage angles,
// vectorised over these: what quasi_static_state() gives at each, for studies that ask for
// a great many. All instruction sets give the same bits.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "bearing/equilibrium/aligned_engine.hpp"
#include "bearing/equilibrium/lamina_bearing.hpp"
#include "bearing/equilibrium/quasi_static.hpp"
#include "mechanics/packs/instruction_set.hpp"

namespace orbearing::bearing::vectorised {

/// Equilibria at all cage angles, arrays over these (positions) and rollers.
struct PitchResults {
  Eigen::Vector2d load = Eigen::Vector2d::Zero();  // [N]  on the bore
  Eigen::Array2Xd displacement;            // [m]    (x and y, positions)  outer ring relative to inner ring
  std::vector<Eigen::Matrix2d> stiffness;  // [N/m]  (positions)
  Eigen::ArrayXXd inner_load, outer_load;  // [N]    (positions, rollers)
  std::vector<double> rollers;             // of AlignedOutput, block by block; empty: not by AlignedPitch
  std::vector<QuasiStaticState> states;    // (positions)  where searched one by one, else empty
  std::vector<SolverReport> reports;       // (positions)
};

/// Laminae of a contact, those of like drop as one; a whole contact is one lamina without drop.
struct UnlikeLaminae {
  std::vector<double> drop;            // [m]  rising
  std::vector<double> share;           // [-]  of the contact's length
  std::vector<std::size_t> lamina_of;  // (laminae of a contact)  which of these it is
};

/// The solver for one bearing: whole contacts, or laminae whose drops are the same at both ends and on both
/// races, dry. Not for use by two threads at once.
class AlignedPitch {
 public:
  /// None where rollers tilt between aligned races, or races are not round or have a film. Throws
  /// std::invalid_argument where the bearing has an unsound profile.
  static std::optional<AlignedPitch> of(const Bearing& bearing, const QuasiStaticOptions& options,
                                        mechanics::InstructionSet set = mechanics::best_instruction_set());
  /// Whether races are aligned and rigid at `point`.
  static bool holds(const OperatingPoint& point) {
    return point.outer_race.is_rigid() && point.bore_tilt.isZero(0.0);
  }

  /// At cage angles evenly spaced over a pitch from options.first_roller on. If the report of a position is
  /// not converged, its loads are those of the last iterate. Throws std::invalid_argument where a load or
  /// speed is not finite. The searches need no start; or, if `near` holds the results of this bearing under
  /// another load, they start along their tangents.
  void solve(const OperatingPoint& point, PitchResults& results, const PitchResults* near = nullptr);
  /// The same as a result over the pitch without its states; none where a position did not converge.
  std::optional<QuasiStaticResult> under(const laminae::LaminaBearing& bearing, const OperatingPoint& point,
                                         const PitchResults* near = nullptr);

 private:
  AlignedPitch(const Bearing& bearing, const QuasiStaticOptions& options, UnlikeLaminae laminae,
               mechanics::InstructionSet set);
  void solve(const OperatingPoint& point, PitchResults& results, const PitchResults* near,
             double* lamina_loads);
  void put(const OperatingPoint& point, double first_roller, int lane);
  void start_near(const OperatingPoint& point, const PitchResults& near, int position, int lane);
  void take(Eigen::Index first, Eigen::Index count, PitchResults& results) const;

  Bearing bearing_;
  BearingGeometry geometry_;
  QuasiStaticOptions options_;
  double unit_length_;     // [m]  approach of one whole contact under 1 N
  UnlikeLaminae laminae_;  // drops in units of length, from the least on
  std::vector<double> pocket_cosine_, pocket_sine_;
  std::vector<double> inner_, outer_;  // [N]  (rollers, kBlock)
  std::vector<double> lamina_loads_;   // of AlignedOutput, block by block
  AlignedInput input_{};
  AlignedOutput output_{};
  std::unique_ptr<AlignedEngine> engine_;
};

/// Equilibria over a pitch whatever the rollers do: by AlignedPitch where it holds, else cage angle by cage
/// angle.
class PitchSearch {
 public:
  PitchSearch(const Bearing& bearing, const QuasiStaticOptions& options)
      : bearing_(bearing), options_(options), level_(AlignedPitch::of(bearing, options)) {}

  /// As AlignedPitch::solve(); other results than `near`.
  void solve(const OperatingPoint& point, PitchResults& results, const PitchResults* near = nullptr);

 private:
  laminae::LaminaBearing bearing_;
  QuasiStaticOptions options_;
  std::optional<AlignedPitch> level_;
};

}  // namespace orbearing::bearing::vectorised
