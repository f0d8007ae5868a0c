// Steps of gears and bearings with one length for all, but for those bearings whose rollers are in impact:
// they are substepped, that is taken through the step once more in shorter ones of their own, with the motion
// of their bores from the step of all. The strategy of [Savcenco2007], there for ROS2 too; momentum is kept,
// eq. (3) of coupling/system/README.md.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "bearing/motion/vector_bearing.hpp"
#include "coupling/integration/rosenbrock2.hpp"
#include "coupling/integration/step_control.hpp"
#include "coupling/system/coupled_model.hpp"
#include "coupling/system/driven_system.hpp"
#include "gearset/dynamics/stage_matrix.hpp"

namespace orbearing::system {

// Gear set and vectorised bearings as one system for the linearly implicit stepper: each bearing is reduced
// to two freedoms at its bore, the gear set with these is solved as one matrix, and the bearings
// follow.

/// State: [ gears in the order of SetLayout, padded to a multiple of eight | bearing | bearing | ... ], each
/// bearing in PaddedLayout with its bore where the gear set has it. `CoupledSteps` and `through_window` run
/// it; for steps of order 4 see WithAllSlopes. The matrix always leaves out a small effect:
/// that the carrier's frame and a land on the planet turn at other speeds.
class CoupledSystem {
 public:
  using Vector = Eigen::Map<const Eigen::VectorXd>;

  /// `rotating`: the matrix includes the effects of the planets' rotations on bearings, and vice versa.
  explicit CoupledSystem(const CoupledModel& model, bool rotating = false);

  Eigen::Index freedoms() const { return model_.gears.layout.freedoms(); }
  /// Positions (from 0) or velocities (from freedoms()) of the gears.
  Vector part(const double* x, Eigen::Index from) const { return {x + from, freedoms()}; }

  std::size_t size() const { return static_cast<std::size_t>(gear_size_ + bearings() * bearing_size_); }
  int bearings() const { return model_.bearings(); }
  /// Beginning of the part of bearing `b`.
  std::ptrdiff_t offset(int b) const { return gear_size_ + b * bearing_size_; }
  double* of_bearing(double* x, int b) const { return x + offset(b); }
  const double* of_bearing(const double* x, int b) const { return x + offset(b); }
  const bearing::vectorised::VectorBearing& bearing(int b) const {
    return bearings_[static_cast<std::size_t>(b)];
  }
  bearing::vectorised::VectorBearing& bearing(int b) { return bearings_[static_cast<std::size_t>(b)]; }
  const CoupledModel& model() const { return model_; }
  double true_time(double time) const;

  /// Times of the stepper count from `begin` [s]. The right-hand side is evaluated only within [first, last]
  /// [s], so that it is on the inner side of jumps of the mesh stiffness.
  void set_piece(double begin, double first, double last);

  void linearise(double time, const double* x, double* dx);
  void derivative(double time, const double* x, double* dx);
  bool factor(double g);
  void solve(const double* rhs, double* k);
  void begun(const std::vector<double>& x);
  void stepped(double, double length);
  void settle(double time, std::vector<double>& x) const;

  std::vector<system::LoadsAtStep> loads;  // (bearings)
  std::vector<bool> counted;               // (bearings)  their loads of this step are counted already
  long steps = 0;                          // [-]  accepted since construction

  /// Whether the matrix holds the rotations of the planets.
  bool rotating() const { return rotating_; }

  /// Reaction of bearing `b` on its planet at the last linearisation.
  const bearing::motion::BoreReaction& begin_reaction(int b) const {
    return begin_reactions_[static_cast<std::size_t>(b)];
  }
  /// Reaction of bearing `b` on its planet in the last attempt, mean over the step.
  bearing::motion::BoreReaction mean_reaction(int b) const {
    return stages_[static_cast<std::size_t>(b)].mean();
  }
  /// Adds the effect of impulses [N s], [N m s] on the planets, on top of all else, to the velocities of the
  /// gears in `x`.
  void push(const gearset::dynamics::PortLoads& impulses, double* x);

 protected:
  /// Slope of the rate by time at the last linearisation, which was at `time` [s]: that of the mesh
  /// stiffness.
  void mesh_slope(double time, double* dx);

 private:
  void put_acceleration(int b, const Eigen::Ref<const Eigen::VectorXd>& rate, double* dx) const;
  template <bool WithSlopes>
  void evaluate(double time, const double* x, double* dx);

  const CoupledModel& model_;
  bool rotating_;
  gearset::dynamics::PlanetarySetEquations equations_;
  std::vector<bearing::vectorised::VectorBearing> bearings_;
  std::vector<bearing::motion::BoreReaction> begin_reactions_;  // (bearings)  at the last linearisation
  std::vector<StageReactions> stages_;                          // (bearings)
  std::vector<bearing::vectorised::PortMatrix> port_matrices_;  // (bearings)
  struct Reduced {
    double force[3]{};  // [N], [N m]
  };
  std::vector<Reduced> reduced_;  // (bearings)  of the stage that is being solved
  gearset::dynamics::PortLoads port_loads_, stage_loads_;
  gearset::dynamics::ForceSlopes slopes_;
  gearset::dynamics::StageMatrix matrix_;
  Eigen::VectorXd right_, rate_;
  Eigen::VectorXd linear_gears_;                 // (2 freedoms)  at the last linearisation
  std::vector<double> linear_;                   // all of the state there, where gravity acts
  Eigen::VectorXd gear_rate_, gear_rate_after_;  // (2 freedoms)
  std::ptrdiff_t gear_size_ = 0;
  std::ptrdiff_t bearing_size_ = 0;
  double g_ = 0.0;
  double begin_ = 0.0, first_ = 0.0, last_ = 0.0;  // [s]
};

/// The same for steps that ask for all slopes, as those of order 4 do, that by time alone among them.
class WithAllSlopes : public CoupledSystem {
 public:
  explicit WithAllSlopes(const CoupledModel& model, bool rotating = true) : CoupledSystem(model, rotating) {}
  void time_slope(double time, double* dx) { mesh_slope(time, dx); }
};

/// Allowed errors and bounds of the steps.
struct CoupledStepOptions {
  std::vector<double> gears;    // allowed errors of the gears' part of the state; zero: not weighed
  std::vector<double> bearing;  // the same of one bearing
  double longest_step = 0.0;    // [s]
  int most_substepped = 0;      // [-]  bearings that may be substepped in one step
  long most_steps = 0;          // [-]  of one of these in one step
};

/// A controlled stepper as required by through_window().
class CoupledSteps {
 public:
  CoupledSteps(const CoupledSystem& system, const CoupledStepOptions& options);

  void begin(CoupledSystem& system, const std::vector<double>& x, double t) { all_.begin(system, x, t); }
  integration::StepResult try_step(CoupledSystem& system, std::vector<double>& x, double& t, double& dt);

  long substepped() const { return substepped_; }  // [-]  bearings substepped since construction

 private:
  void take_errors(const CoupledSystem& system, double h);
  bool is_kept(double gears) const;
  double cheapest_error(double gears) const;
  void substep_all(CoupledSystem& system, const std::vector<double>& before, double t, double h,
                   std::vector<double>& x);
  bearing::motion::BoreReaction substep(CoupledSystem& system, int b, const std::vector<double>& before,
                                        double t, double h, std::vector<double>& x);

  CoupledStepOptions options_;
  integration::Rosenbrock2 all_;         // weighs the gears only
  integration::Rosenbrock2 within_;      // one bearing
  integration::StepControl control_;     // of the steps of all
  std::vector<double> weight_;           // of one bearing
  std::vector<double> errors_, sorted_;  // (bearings)  shares of what is allowed
  std::vector<double> bearing_;          // state of one
  gearset::dynamics::PortLoads missed_;  // impulses [N s], [N m s] that the step of all did not include
  long substepped_ = 0;
};

}  // namespace orbearing::system
