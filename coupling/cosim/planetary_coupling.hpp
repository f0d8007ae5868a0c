// A planetary drivetrain in co-simulation: its gear set, and every bearing of every planet.
//
// Each mass and spring once: the gear set has the planets with the outer rings of their bearings and all
// their inertial loads; a bearing has rollers, cage, pin ring and the support of its pin.
#pragma once

#include <memory>
#include <vector>

#include "coupling/cosim/coupled_run.hpp"
#include "coupling/system/coupled_model.hpp"
#include "coupling/system/motion.hpp"

namespace orbearing::cosim {

struct PlanetaryCoupling {
  std::unique_ptr<system::DrivenGears> gears;
  std::vector<system::DrivenBearing> bearings;  // those of planet 1, then of planet 2, ...
  Sides sides;                                  // gears first, then the bearings
};

/// The ports of planet n, counted from 1, are "planet_n.x", "planet_n.y" and "planet_n.rotation"; the last is
/// relative to the carrier and beyond the nominal rotation. Throws std::invalid_argument, with what was found
/// and what is required, as gears and bearings do.
PlanetaryCoupling planetary_coupling(const system::CoupledSetup& setup);

/// Gears and bearings of a drivetrain in motion together, by exchange in windows.
class CoSimulatedMotion final : public system::Motion {
 public:
  /// From rest in each other's forces. A whole number of windows, no longer than those of `options`, lasts
  /// `interval` [s]: the motion is advanced by multiples of it.
  CoSimulatedMotion(const system::CoupledSetup& setup, const CoupledOptions& options, double interval);

  int bearings() const override { return static_cast<int>(parts_.bearings.size()); }
  void observe_steps(const system::StepObservers& observers) override;
  void advance(const integration::OutputTimes& times,
               const std::function<void(double time)>& observe) override;
  void take_snapshot(int b, bearing::motion::Snapshot& into) const override;
  integration::IntegrationReport report() const override;
  /// All exchanges since the start.
  const CoupledReport& exchange() const { return exchange_; }

 private:
  PlanetaryCoupling parts_;
  double window_;  // [s]
  CoupledRun run_;
  CoupledReport exchange_;
  long done_ = 0;  // windows
};

}  // namespace orbearing::cosim
