// Gear set and all planet bearings solved as one system: the finest rung, against which schemes of
// co-simulation are measured.
#pragma once

#include <memory>
#include <vector>

#include "coupling/system/coupled_model.hpp"
#include "coupling/system/motion.hpp"

namespace orbearing::system {

/// Not for use by two threads at once; any number of objects side by side.
class Monolithic final : public system::Motion {
 public:
  /// Throws std::invalid_argument, with what was found and what is required; so where the vectorised bearing
  /// does not know all of the model (oil in the pockets).
  explicit Monolithic(const CoupledSetup& setup);
  ~Monolithic() override;
  Monolithic(Monolithic&&) noexcept;
  Monolithic& operator=(Monolithic&&) noexcept;

  /// See coupled_start().
  void initialize(double time);
  /// To this state of gears and bearings, which stand where their planets do.
  void initialize(double time, const CoupledStart& start);
  /// From `window.begin`, where the system stands, to its end. On an error (std::runtime_error) the state is
  /// that at the beginning.
  void advance(const Window& window);
  /// To `time` [s], not before the present one: as fast as steps go, which may pass it; what is shown of the
  /// state is then interpolated. In place of windows, and without save() and restore(). On an error
  /// (std::runtime_error) the state is not to be used.
  void follow(double time);
  /// By follow().
  void advance(const integration::OutputTimes& times,
               const std::function<void(double time)>& observe) override;
  /// Begins the sums over time anew: loads, lives, revolutions.
  void forget();

  int planets() const;
  /// Of all planets; bearing b belongs to planet b / bearings_per_planet.
  int bearings() const override;
  double time() const;  // [s]
  DrivenGearsOutput gears() const;
  /// What bearing `b` does to its planet.
  bearing::motion::BoreReaction reaction(int b) const;
  DrivenBearingOutput bearing(int b) const;
  void take_snapshot(int b, bearing::motion::Snapshot& into) const override;
  void observe_steps(const system::StepObservers& observers) override;
  /// Life [rev] under the loads since the start, or since forget().
  bearing::BearingLife life(int b) const;
  /// States in the orders of SetLayout and StateLayout.
  CoupledStart state() const;
  /// Steps since construction.
  integration::IntegrationReport report() const override;
  long substepped() const;  // [-]  bearings substepped

  void save(SavedState& state) const;
  /// Throws std::invalid_argument where `state` is not one of such a system.
  void restore(const SavedState& state);

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace orbearing::system
