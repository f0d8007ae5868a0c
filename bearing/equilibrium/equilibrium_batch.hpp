// Quasi-static equilibria of one bearing at many operating points, vectorised over the points: what
// quasi_static_state() gives for dry contacts, for studies that ask for a great many of them.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bearing/equilibrium/equilibrium_engine.hpp"
#include "bearing/equilibrium/quasi_static.hpp"
#include "mechanics/packs/instruction_set.hpp"

namespace orbearing::bearing::vectorised {

/// One operating point at one cage angle.
struct EquilibriumPoint {
  OperatingPoint point;
  double first_roller = 0.0;  // [rad]  place of the first roller
};

/// A point where no balance was found.
struct EquilibriumFailure {
  std::size_t index = 0;
  std::string message;
};

/// Arrays over points. Used again, they are not allocated anew.
struct EquilibriumResults {
  Eigen::Array2Xd displacement;              // [m]  (x and y, points)  outer ring relative to inner ring
  Eigen::ArrayXXd inner_load;                // [N]  (points, rollers)
  Eigen::ArrayXXd outer_load;                // [N]  (points, rollers)
  Eigen::ArrayXd residual;                   // [N]  (points)  force out of balance on the outer ring
  Eigen::ArrayXi iterations;                 // [-]  (points)
  std::vector<EquilibriumFailure> failures;  // points whose loads are those of the last iterate
  long solved_singly = 0;                    // [-]  points left to quasi_static_state()
};

/// Laminae of a contact, those of like drop as one; none: whole contacts.
struct UnlikeLaminae {
  std::vector<double> drop;   // [m]  (laminae)  rising
  std::vector<double> share;  // [-]  (laminae)  of the contact's length
};

/// An engine for a block of operating points of one round bearing, in units of length.
class EquilibriumBlock {
 public:
  EquilibriumBlock(const Bearing& bearing, const InertiaSwitches& inertia, mechanics::InstructionSet set,
                   UnlikeLaminae laminae = {});

  void put(const OperatingPoint& point, double first_roller, int lane);
  /// Searches of the next block start by themselves where `rollers` is null, else each from a neighbouring
  /// one, EquilibriumOutput::rollers and the displacement there, at the displacement `start` [m].
  void start_near(const double* rollers) { input_.near_rollers = rollers; }
  void start_at(const Eigen::Vector2d& near, const Eigen::Vector2d& start, int lane) {
    input_.near_x[lane] = near.x() / unit_length_;
    input_.near_y[lane] = near.y() / unit_length_;
    input_.start_x[lane] = start.x() / unit_length_;
    input_.start_y[lane] = start.y() / unit_length_;
  }
  /// Solves the block. Its first `count` points are those from `first` on of arrays over points; `rollers`
  /// and `lamina_loads` as in EquilibriumOutput.
  const EquilibriumOutput& solve(Eigen::Index first, Eigen::Index count, Eigen::Array2Xd& displacement,
                                 Eigen::ArrayXXd& inner_load, Eigen::ArrayXXd& outer_load,
                                 double* rollers = nullptr, double* lamina_loads = nullptr);

  double unit_length() const { return unit_length_; }  // [m]  approach of one contact under 1 N

 private:
  BearingGeometry geometry_;
  InertiaSwitches inertia_;
  double unit_length_;
  double cage_mass_;  // [kg]  whose inertial load reaches the outer ring
  std::vector<double> pocket_cosine_, pocket_sine_;
  UnlikeLaminae laminae_;              // drops in units of length, from the least on
  std::vector<double> inner_, outer_;  // [N]  (rollers, kBlock)
  EquilibriumInput input_{};
  EquilibriumOutput output_{};
  std::unique_ptr<EquilibriumEngine> engine_;
};

/// The solver for one bearing. Not for use by two threads at once.
class EquilibriumBatch {
 public:
  explicit EquilibriumBatch(const Bearing& bearing, const InertiaSwitches& inertia = {},
                            mechanics::InstructionSet set = mechanics::best_instruction_set());

  /// Solves all points; each result depends on its own point alone. What the vectorised iteration does not
  /// balance, and all points where races are not round or bend, or rollers unequal, is left to
  /// quasi_static_state(). Throws std::invalid_argument where a load or speed is not finite.
  void solve(std::span<const EquilibriumPoint> points, EquilibriumResults& results);

 private:
  void solve_singly(const EquilibriumPoint& point, std::size_t index, EquilibriumResults& results) const;

  Bearing bearing_;
  InertiaSwitches inertia_;
  EquilibriumBlock block_;
};

}  // namespace orbearing::bearing::vectorised
