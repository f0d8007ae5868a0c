// Steps of gears and bearings with one length for all, but for those bearings whose rollers are in impact:
// they are substepped, that is taken through the step once more in shorter ones of their own, with the motion
// of their bores from the step of all. The strategy of [Savcenco2007], there for ROS2 too; momentum is kept,
// eq. (3) of coupling/system/README.md.
#pragma once

#include <vector>

#include "coupling/integration/rosenbrock2.hpp"
#include "coupling/integration/step_control.hpp"
#include "coupling/system/coupled_system.hpp"

namespace orbearing::system {

/// Allowed errors and bounds of the steps.
struct CoupledStepOptions {
  std::vector<double> gears;    // allowed errors of the gears' part of the state; zero: not weighed
  std::vector<double> bearing;  // the same of one bearing
  double longest_step = 0.0;    // [s]
  int most_substepped = 0;      // [-]  bearings that may be substepped in one step
  long most_steps = 0;          // [-]  of one of these in one step
};

/// A controlled stepper as through_window() asks for.
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
  integration::Rosenbrock2 all_;         // weighs the gears alone
  integration::Rosenbrock2 within_;      // one bearing
  integration::StepControl control_;     // of the steps of all
  std::vector<double> weight_;           // of one bearing
  std::vector<double> errors_, sorted_;  // (bearings)  shares of what is allowed
  std::vector<double> bearing_;          // state of one
  gearset::dynamics::PortLoads missed_;  // impulses [N s], [N m s] that the step of all did not know
  long substepped_ = 0;
};

}  // namespace orbearing::system
