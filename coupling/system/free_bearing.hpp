// A single planet bearing, under the load on its bore: its integration, and its motion.
#pragma once

#include "bearing/motion/vector_bearing.hpp"
#include "coupling/system/motion.hpp"

namespace orbearing::system {

/// Sample of a step: the state at its beginning and the duration for which that state counts.
struct StepSample {
  double time = 0.0;              // [s]
  double weight = 0.0;            // [s]  half of the step before and half of the one after
  const double* state = nullptr;  // padded
  bearing::motion::RollerLoads loads;
  Eigen::Vector2d bore_force = Eigen::Vector2d::Zero();  // [N]  of the bearing on the bore
};
using StepObserver = std::function<void(const StepSample&)>;

/// As integration::integrate(), for `bearing` by linearly implicit steps of the order that suits it
/// (order_of_steps()); `options.allowed_error` is that of dopri5.
/// `observe` gets states at the output times, `on_step` every accepted step and the rest of the last one;
/// either may be empty, and a std::runtime_error of theirs ends the run as its message. The loads also go to
/// `collector`, if any. `tilt_rate`, if given, holds tilt_rates() of the step that is being observed.
integration::IntegrationReport integrate_bearing(bearing::vectorised::VectorBearing& bearing,
                                                 Eigen::VectorXd& x, const integration::OutputTimes& output,
                                                 const integration::IntegrationOptions& options,
                                                 const integration::Observer& observe,
                                                 const StepObserver& on_step,
                                                 bearing::motion::StatisticsCollector* collector = nullptr,
                                                 std::vector<double>* tilt_rate = nullptr);

/// By linearly implicit steps, or by the explicit ones on request.
class FreeBearing final : public Motion {
 public:
  /// From the state `start`; `length_error` [m] is allowed in one step, and all other errors follow from it.
  FreeBearing(const bearing::motion::BearingModel& model, Eigen::VectorXd start, double length_error,
              const integration::IntegrationOptions& options);

  int bearings() const override { return 1; }
  bool keeps_to_interval() const override { return false; }
  bool shows_steps() const override { return options_.method == integration::Method::linearly_implicit; }
  void observe_steps(const StepObservers& observers) override { observers_ = observers; }
  /// The last step ends with `times`.
  void advance(const integration::OutputTimes& times,
               const std::function<void(double time)>& observe) override;
  void take_snapshot(int b, bearing::motion::Snapshot& into) const override;
  integration::IntegrationReport report() const override { return report_; }

  const bearing::motion::BearingModel& model() const { return bearing_.model(); }
  /// In the order of StateLayout; after an error the last one that was seen.
  const Eigen::VectorXd& state() const { return state_; }

 private:
  integration::IntegrationReport advance_implicitly(const integration::OutputTimes& times,
                                                    const integration::IntegrationOptions& options,
                                                    const integration::Observer& show);
  integration::IntegrationReport advance_explicitly(const integration::OutputTimes& times,
                                                    const integration::IntegrationOptions& options,
                                                    const integration::Observer& show);

  bearing::vectorised::VectorBearing bearing_;
  integration::IntegrationOptions options_;
  integration::IntegrationReport report_;
  StepObservers observers_{{nullptr}, {}};
  Eigen::VectorXd state_;
  Eigen::VectorXd shown_;
  std::vector<double> tilt_rate_;  // of the step to it
  double time_ = 0.0;              // [s]
};

}  // namespace orbearing::system
