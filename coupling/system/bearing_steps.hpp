// Data of a planet bearing for steppers: allowed errors of a step, lengths of steps, states between two of
// them, and validity of the positions of all bodies.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "bearing/motion/vector_bearing.hpp"
#include "coupling/integration/step_control.hpp"

namespace orbearing::system {

/// Allowed errors of linearly implicit steps are this much larger than those of dopri5 at equal accuracy of
/// loads and speeds: the error estimate is that of the first-order step within, and stiff parts of it die out
/// by themselves.
inline constexpr double kLinearlyImplicitErrorFactor = 1000.0;

/// Typical approach, for the contact stiffness of a run [m].
inline constexpr double kTypicalApproach = 1e-6;
/// Angle of the fastest vibration in the longest step [rad].
inline constexpr double kStepOfImpact = 1.05;
/// Share of the allowed error for the radial speeds of rolling elements that bounce: they open and close the
/// contacts, and affect life more than all other variables together. If the squeeze film stops them
/// (impacts_are_damped()), they are weighed as all others.
inline constexpr double kRadialSpeedShare = 0.2;

/// Allowed errors of a bearing's state by kind: no share relative to angles, which grow. `length` [m] sets
/// all: angles follow by `radius` [m], speeds by `frequency` [rad/s], that of a roller between its races.
Eigen::VectorXd allowed_errors(const bearing::motion::StateLayout& layout, double length, double radius,
                               double frequency);
/// The same with pitch radius and frequency of `model`, the latter at a typical approach.
Eigen::VectorXd allowed_errors(const bearing::motion::BearingModel& model, double length);
/// Those of linearly implicit steps of the padded state, from those of dopri5.
std::vector<double> linearly_implicit_errors(const bearing::vectorised::VectorBearing& bearing,
                                             const Eigen::VectorXd& allowed_error);

/// Whether the squeeze film (bearing/contact/squeeze_film.hpp) takes the energy of a roller's impacts
/// on both races: at pure rolling and the film of the unloaded contact its resistance is kDampedImpact of
/// critical or more, with the stiffness that the contact has at 1 N. The reducer's bearing with its oil has
/// 0.7 at 1000, 0.26 at 6000 and 0.13 at 12000 rpm; with a thousandth of its viscosity rollers bounce as
/// without.
bool impacts_are_damped(const bearing::motion::BearingModel& model);
inline constexpr double kDampedImpact = 0.05;  // [-]

/// Whether oil in the pockets takes the energy of a roller's blows on the bars: its squeeze, at pure rolling,
/// stops a roller that comes at kStoppedBlow before both touch. Rollers of the reducer meet their bars at 10
/// to 100 mm/s; its oil stops 150 mm/s.
bool blows_are_damped(const bearing::motion::BearingModel& model);
inline constexpr double kStoppedBlow = 0.05;  // [m/s]

/// Longest step [s] that still resolves the impact of a roller on its pocket, or on its neighbour where there
/// is no cage, and the ring on its rollers.
double longest_step(const bearing::motion::BearingModel& model);

/// Ratio by which motion is slower than its vibrations: the passage of a roller past the load over
/// kStepsOfPassage of the longest steps, at least 1; at speeds not stated 1. If it is more than 1, inertia
/// and squeeze no longer move the rings, and steps follow the rollers' passage: they may be longer by this
/// factor. Speeds are smaller by the same factor, and their allowed errors must be so too: a step with a
/// larger error excites vibrations that cost more than the short steps, and the loads of rollers are then too
/// high. Only radial speeds of rollers without a cage keep their errors: impacts of neighbours accelerate
/// them as much at any speed.
double slowness(const bearing::motion::BearingModel& model);
/// The same where the cage turns at `cage_speed` [rad/s] against the load, for a driven bearing.
double slowness(const bearing::motion::BearingModel& model, double cage_speed);
/// Whether slowness() is above 2: vibrations then decay so soon against the passage of a roller that they do
/// not add up.
inline bool is_slow(const bearing::motion::BearingModel& model) {
  constexpr double kSlow = 2.0;  // [-]  of slowness()
  return slowness(model) > kSlow;
}
/// The reducer's bearing passes a roller in as many longest steps at 850 rpm.
inline constexpr double kStepsOfPassage = 1200.0;  // [-]

/// The body of `model` with the fastest vibration, its support, the inputs that determine it and what to
/// change: for the reason of a run in which no step was small enough.
std::string fastest_vibration(const bearing::motion::BearingModel& model);

/// Whether the matrix of `model` holds all slopes of its rates, which steps of order 3 and 4 ask for: those
/// of tilts, waves of the rim and turning races by themselves are left out.
bool has_all_slopes(const bearing::motion::BearingModel& model);

/// Order of the linearly implicit steps that suit `model`. Order 2 where impacts keep their energy, for steps
/// that span one err at any order and short ones of order 2 do best, and where the matrix lacks slopes. Order
/// 4 where oil takes the energy of impacts on races and bars and gears shake the ring (`shaken`), whose
/// vibration then keeps its height, or where motion is slow (slowness()). Else order 3: without tooth forces
/// that vary its steps are the longer ones.
int order_of_steps(const bearing::motion::BearingModel& model, bool shaken);

/// Bounds of steps of order 3 or 4.
struct StepBounds {
  std::vector<double> allowed;  // errors, of the padded state
  double longest = 0.0;         // [s]
  integration::StepRule rule = integration::StepRule::last_error;
};

/// Those of `bearing` with damped impacts (impacts_are_damped()), from the allowed errors of dopri5. Energy
/// is as well kept as by steps of order 2, means are as good or better (coupling/integration/README.md).
///
/// If blows on the bars are damped too, there are no impacts, and only the ring on its rollers bounds the
/// step. Then the errors that determine loads and life have more weight: the bore, whose error acts on all
/// rollers at once, most, radial motion next. Motion along the pitch circle, spins and the cage act through
/// oil films some tens of micrometres thick, not through an approach of one, and allow errors larger by as
/// much.
StepBounds third_order_steps(const bearing::vectorised::VectorBearing& bearing,
                             const Eigen::VectorXd& allowed_error);

/// Those of `bearing` with damped blows (blows_are_damped()), from the same: the longest step is that of the
/// ring, and all variables bear alike more than steps of order 2 do, for the estimated error of a step of
/// order 4 holds all that its equations have beyond linear ones.
StepBounds fourth_order_steps(const bearing::vectorised::VectorBearing& bearing,
                              const Eigen::VectorXd& allowed_error);

/// Those of the order that suits `bearing` (order_of_steps()), longer where its motion is slow (`slow`, as
/// slowness() has it).
StepBounds steps_of_order(int order, const bearing::vectorised::VectorBearing& bearing,
                          const Eigen::VectorXd& allowed_error, double slow);

/// Empty while the cage holds its rollers and the rollers lie between the races; else which body has left its
/// position, and by how much. Pockets hold a cage along the pitch circle only: one without a guiding land can
/// leave sideways, and its equations go on without bound.
std::string out_of_place(const bearing::motion::BearingModel& model,
                         const Eigen::Ref<const Eigen::VectorXd>& x);

/// [m/s] (rollers)  Rates of end displacements in a step of `length` [s] between padded states of a bearing;
/// none where rollers do not tilt.
std::vector<double> tilt_rates(const bearing::vectorised::PaddedLayout& layout, const double* from,
                               const double* to, double length);

/// A state within a step: positions by Hermite's cubic from their velocities, velocities in a straight line,
/// which does not ring where they are stiff.
class WithinStep {
 public:
  /// At `time` [s] in the step from `begin` to `end` [s], where `from` and `to` are; writes it into `x`, all
  /// in straight lines at first.
  WithinStep(double begin, const std::vector<double>& from, double end, const std::vector<double>& to,
             double time, std::vector<double>& x);
  /// `count` positions from `position`, whose velocities are those from `velocity`.
  void bend(std::ptrdiff_t position, std::ptrdiff_t velocity, std::ptrdiff_t count) const;
  /// All positions of the bearing whose padded state begins at `first`.
  void bend(const bearing::vectorised::PaddedLayout& layout, std::ptrdiff_t first) const;

 private:
  const std::vector<double>&from_, &to_;
  std::vector<double>& x_;
  double length_;  // [s]
  double share_;   // [-]
};

}  // namespace orbearing::system
