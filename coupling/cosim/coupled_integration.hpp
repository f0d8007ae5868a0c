// The state of gears and bearings as one system, and its way through time.
#pragma once

#include <vector>

#include "coupling/cosim/coupled_steps.hpp"
#include "coupling/cosim/participant.hpp"

namespace orbearing::cosim {

/// What Monolithic runs. One object is either advanced from window to window or followed, not both.
class CoupledIntegration {
 public:
  /// Throws std::invalid_argument as Monolithic.
  explicit CoupledIntegration(const CoupledSetup& setup);
  CoupledIntegration(const CoupledIntegration&) = delete;
  CoupledIntegration& operator=(const CoupledIntegration&) = delete;

  void start(double time, const CoupledStart& start);
  void forget();
  /// Piece by piece between the jumps of the mesh stiffness; the last step ends with the window. The state is
  /// lost on an error.
  void advance(const Window& window);
  /// To `time` [s], which steps may pass: the state shown is interpolated, positions by cubics, velocities in
  /// straight lines.
  void follow(double time);

  double time() const { return time_; }
  Eigen::VectorXd gear_state() const;
  Eigen::VectorXd bearing_state(int b) const;
  bearing::dynamics::BoreMotion motion(int b) const;
  double turned(int b) const { return turned_[static_cast<std::size_t>(b)]; }  // [rad]  there and back

  /// Throws std::runtime_error between two steps of follow().
  SavedState saved();
  /// What saved() gave; false where it is not of such a system, and then nothing has changed.
  bool put(const SavedState& state);

  const CoupledSetup& setup() const { return setup_; }
  const CoupledModel& model() const { return model_; }
  CoupledSystem& system() { return system_; }
  const CoupledSystem& system() const { return system_; }
  const CoupledSteps& stepper() const { return stepper_; }

 private:
  // Between two jumps.
  struct Piece {
    double begin = 0.0, end = 0.0;  // [s]
    double done = 0.0;              // [s]  since its beginning
  };

  Piece piece_from(double begin) const;
  void enter(const Piece& piece);
  void one_step();
  void show(double time);
  void show_all();
  void count_turns();
  void require_in_place() const;
  template <class Visit>
  void each(Visit visit);
  Eigen::Index freedoms() const { return model_.gears.layout.freedoms(); }

  CoupledSetup setup_;
  CoupledModel model_;
  CoupledSystem system_;
  CoupledSteps stepper_;
  std::vector<double> x_;       // as far as steps have gone
  std::vector<double> before_;  // where the last step of follow() began
  std::vector<double> shown_;
  std::vector<double> turned_, angle_;                        // [rad]  (bearings)
  double time_ = 0.0, reached_ = 0.0, reached_before_ = 0.0;  // [s]  shown, of x_, of before_
  double step_ = 1e-6;                                        // [s]  to try next
  Piece piece_;
  bool following_ = false;
};

}  // namespace orbearing::cosim
