// The planet bearing in time, vectorised over rollers, with its Jacobian in block-arrow form.
//
// A roller couples only with pin, bore and cage. In the stages of a linearly implicit method positions follow
// from velocities, so one roller leaves three unknowns and the rings seven; eliminating the rollers costs
// O(rollers).
#pragma once

#include <memory>
#include <vector>

#include "bearing/motion/model_constants.hpp"
#include "mechanics/packs/instruction_set.hpp"

namespace orbearing::bearing::vectorised {

/// The vectorised bearing: engine, layout and conversion from and to the flat state of bearing/motion.
class VectorBearing {
 public:
  explicit VectorBearing(const motion::BearingModel& model,
                         mechanics::InstructionSet set = mechanics::best_instruction_set());

  const PaddedLayout& layout() const { return given_.layout(); }
  const motion::BearingModel& model() const { return model_; }
  mechanics::InstructionSet instruction_set() const { return set_; }

  /// Rate `dx` of the padded state `x` at `time` [s].
  void derivative(double time, const double* x, double* dx);
  /// As derivative(), and keeps the Jacobian for factor() and solve().
  void linearise(double time, const double* x, double* dx);
  /// Derivative of the right-hand side by time only, through the load on the bore at `time` [s], and in a
  /// run-up through all that it changes, into `rate` (padded), at the point of the last linearisation. That
  /// of waves and scratches that turn with a race at a steady speed is left out: the order does not require
  /// it.
  void time_slope(double time, double* rate);
  /// Contribution of gravity to such a derivative in the padded state `x`, without the planet's weight; the
  /// carrier has turned by `carrier_angle` [rad].
  void add_weight_slope(double carrier_angle, double carrier_speed, const double* x, double* rate) const;
  bool factor(double g) { return engine_->factor(g); }
  void solve(const double* rhs, double* k) const { engine_->solve(rhs, k); }
  ContactLoads loads() const { return engine_->loads(); }
  /// At the last evaluation.
  const Surroundings& surroundings() const { return now_; }

  /// As derivative(), of a state in the order of motion/layout.hpp.
  void derivative(double time, const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> dx);

  /// As their namesakes, for a bore that is driven: its position is that of its four entries of `x`, and its
  /// velocity changes at the acceleration of `motion`; position and velocity of `motion` are not used.
  void derivative(const motion::BoreMotion& motion, const double* x, double* dx);
  void linearise(const motion::BoreMotion& motion, const double* x, double* dx);
  /// Rate of a state in the order of motion/layout.hpp, with its bore following `motion`; returns the
  /// reaction of the bearing on it.
  motion::BoreReaction derivative(const motion::BoreMotion& motion,
                                  const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> dx);
  /// Reaction of the bearing on the bore, at the last evaluation.
  motion::BoreReaction reaction() const;
  /// Slopes of its force, at the last linearisation.
  BoreSlopes bore_slopes() const { return engine_->bore_slopes(); }
  /// As factor() and solve() with the bore open: engine.hpp. The planet's row of a stage becomes
  ///   (mass + port) rate = mass rhs + force,   rate: of the bore's velocity and rotation.
  bool factor_open(double g, bool rotating, PortMatrix& port) {
    return engine_->factor_open(g, rotating, port);
  }
  void reduce(const double* rhs, double* k, double (&force)[3]) { engine_->reduce(rhs, k, force); }
  void complete(const double* rhs, const double (&rate)[3], double* k) const {
    engine_->complete(rhs, rate, k);
  }

  std::vector<double> padded(const Eigen::Ref<const Eigen::VectorXd>& flat) const {
    return given_.padded(flat);
  }
  void flatten(const double* padded, Eigen::Ref<Eigen::VectorXd> flat) const { given_.flatten(padded, flat); }

 private:
  void set(const Surroundings& now);

  motion::BearingModel model_;
  ModelConstants given_;  // of model_
  mechanics::InstructionSet set_;
  bool changes_;
  Surroundings now_;
  std::unique_ptr<Engine> engine_;
  std::vector<double> flat_state_, flat_rate_;  // padded, of a flat state
  std::vector<double> last_state_,
      last_rate_;  // padded, of the last linearisation in a run-up or with weight
};

}  // namespace orbearing::bearing::vectorised
