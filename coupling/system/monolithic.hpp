// Gear set and all planet bearings solved as one system: the finest rung, against which schemes of
// co-simulation are measured.
#pragma once

#include <optional>
#include <vector>

#include "coupling/integration/rosenbrock4.hpp"
#include "coupling/system/coupled_model.hpp"
#include "coupling/system/coupled_steps.hpp"
#include "coupling/system/motion.hpp"

namespace orbearing::system {

/// Either advanced from window to window or followed, not both. Not for use by two threads at once; any
/// number of objects side by side.
class Monolithic final : public Motion {
 public:
  /// Throws std::invalid_argument, with what was found and what is required; so where the vectorised bearing
  /// does not support all of the model (oil in the pockets).
  explicit Monolithic(const CoupledSetup& setup);
  Monolithic(const Monolithic&) = delete;
  Monolithic& operator=(const Monolithic&) = delete;

  /// See coupled_start().
  void initialize(double time);
  /// To this state of gears and bearings; bores are at the positions of their planets.
  void initialize(double time, const CoupledStart& start);
  /// From `window.begin`, its present time, to its end, piece by piece between the jumps of the mesh
  /// stiffness. On an error (std::runtime_error) the state is not to be used.
  void advance(const Window& window);
  /// To `time` [s], not before the present one: as fast as steps go, which may pass it; what is shown of the
  /// state is then interpolated, positions by cubics, velocities in straight lines. On an error
  /// (std::runtime_error) the state is not to be used.
  void follow(double time);
  /// By follow().
  void advance(const integration::OutputTimes& times,
               const std::function<void(double time)>& observe) override;

  int planets() const { return static_cast<int>(model_.ports.size()); }
  /// Number over all planets; bearing b belongs to planet b / bearings_per_planet.
  int bearings() const override { return system_.bearings(); }
  double time() const { return time_; }  // [s]
  DrivenGearsOutput gears() const;
  /// Reaction of bearing `b` on its planet.
  bearing::motion::BoreReaction reaction(int b) const;
  void take_snapshot(int b, bearing::motion::Snapshot& into) const override;
  void observe_steps(const StepObservers& observers) override;
  /// States in the orders of SetLayout and StateLayout.
  CoupledStart state() const;
  /// Steps since construction.
  integration::IntegrationReport report() const override;
  /// [-]  bearings substepped
  long substepped() const { return substepping_ ? substepping_->substepped() : 0; }

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
  void require_containment() const;
  Eigen::VectorXd gear_state() const;
  Eigen::VectorXd bearing_state(int b) const;
  bearing::motion::BoreMotion planet_motion(int b) const;
  Eigen::Index freedoms() const { return model_.gears.layout.freedoms(); }

  CoupledSetup setup_;
  CoupledModel model_;
  gearset::dynamics::PlanetarySetEquations equations_;
  WithAllSlopes system_;
  std::optional<CoupledSteps> substepping_;         // of order 2
  std::optional<integration::Rosenbrock4> smooth_;  // instead of it if nothing bounces
  long rejected_ = 0;                               // [-]  attempts
  std::vector<double> x_;                           // as far as steps have gone
  std::vector<double> before_;                      // where the last step of follow() began
  std::vector<double> shown_;
  double time_ = 0.0, reached_ = 0.0, reached_before_ = 0.0;  // [s]  shown, of x_, of before_
  double step_ = 1e-6;                                        // [s]  to try next
  Piece piece_;
  bool following_ = false;
};

}  // namespace orbearing::system
