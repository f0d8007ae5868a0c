// One driven planet bearing: motion of bore and carrier in, force and moment out.
#pragma once

#include <memory>
#include <vector>

#include "bearing/motion/bore_motion.hpp"
#include "bearing/motion/model.hpp"
#include "bearing/motion/parameters.hpp"
#include "bearing/motion/snapshot.hpp"
#include "bearing/motion/statistics.hpp"
#include "bearing/parameters.hpp"
#include "coupling/system/participant.hpp"
#include "coupling/system/steady_state.hpp"
#include "mechanics/described.hpp"

namespace orbearing::system {

/// All that is fixed before a run.
struct DrivenBearingSetup {
  bearing::Bearing bearing;
  bearing::motion::DynamicsParameters dynamics;  // no run-up, no excitation: the inputs bring them
  double orbit_radius = 0.0;                     // [m]    from the carrier's axis to the pin's
  double first_roller = 0.0;                     // [rad]  angle of the first roller at the start
  double reduction_factor = 0.83;                // [-]    of the Lundberg-Palmgren life
  /// Inclination [rad] of the bore's axis against the pin's, which stays: it runs along (x, y, 1). Affects
  /// laminae only, and refused without them.
  Eigen::Vector2d bore_tilt = Eigen::Vector2d::Zero();
  bearing::ElasticRace outer_race = {};  // how the outer race bends, under mean forces of the teeth
  double allowed_length_error = 2e-10;   // [m]    of one step; all other variables follow from it
  long bins = 72;                        // [-]    bins on the races, for the life
  long most_steps = 10'000'000;          // [-]    in one call of advance() before it gives up
  double planet_speed = 0.0;   // [rad/s]  of the bore relative to the carrier, at the start if not given
  double carrier_speed = 0.0;  // [rad/s]  the same
  Eigen::Vector2d start_load = Eigen::Vector2d::Zero();  // [N]  of the planet on the bearing, at the start
  /// Start value of the bore's displacement [m]: equilibrium position under that load at these speeds.
  Eigen::Vector2d start_displacement = Eigen::Vector2d::Zero();
};

/// Also used for a drivetrain.
inline described::Row<double> reduction_factor_row(double& reduction_factor) {
  using namespace described;
  return input(
      reduction_factor, "life.reduction_factor",
      "reduction factor of the capacity: the product lambda nu of ISO/TR 1281-1",
      {.range = positive(1.0), .reason = "the product for cylindrical roller bearings in ISO/TR 1281-1"});
}

/// All data besides its inputs on which a bearing's future depends, in the order of an FMU's model.
template <class Visitor>
void describe(Visitor& visit, DrivenBearingSetup& m) {
  using namespace described;
  const Details angle{.dimension = dimension::angle};
  members(visit, m, part(m.bearing), part(m.dynamics),
          internal(m.orbit_radius, "gearset.centre_distance", "from the carrier's axis to the pin's",
                   {.dimension = dimension::length, .range = {.least = 0.0}}),
          internal(m.first_roller, "first_roller", "angle of the first roller at the start", angle),
          together(
              internal(
                  m.bore_tilt.x(), "bearing.misalignment.x",
                  "tilt of the bore's axis against the pin's: outward at the bearing's positive end; acts on "
                  "laminae",
                  angle),
              internal(m.bore_tilt.y(), "bearing.misalignment.y", "the same in the sense of carrier rotation",
                       angle)),
          together(internal(m.start_load.x(), "start_load.x",
                            "load of the planet on the bearing at the start, outward: without "
                            "planet.displacement, it begins in static equilibrium under this load",
                            {.dimension = dimension::force}),
                   internal(m.start_load.y(), "start_load.y", "the same in the sense of carrier rotation",
                            {.dimension = dimension::force})),
          apart(m.outer_race), reduction_factor_row(m.reduction_factor),
          system::length_error_row(m.allowed_length_error), internal(m.bins, "simulation.bins"),
          internal(m.most_steps, "simulation.most_steps"), internal(m.planet_speed, "operation.planet_speed"),
          internal(m.carrier_speed, "operation.carrier_speed"),
          together(internal(m.start_displacement.x(), "operation.displacement.x"),
                   internal(m.start_displacement.y(), "operation.displacement.y")));
}

/// The model of a driven bearing. Throws std::invalid_argument, with what was found and what is required,
/// where a number has no meaning or for options that follow from speeds or loads before they are known: a
/// run-up, a mesh excitation.
bearing::motion::BearingModel driven_model(const DrivenBearingSetup& setup);

/// Throws std::runtime_error with what was found where a window has no length.
void require_length(const Window& window);

/// At the present time.
struct DrivenBearingOutput {
  bearing::motion::BoreReaction reaction;
  double cage_speed = 0.0;   // [rad/s]  relative to the carrier; without a cage the mean over the rollers
  double cage_slip = 0.0;    // [-]  1 - cage speed / kinematic cage speed; 0 where nothing turns
  double life_used = 0.0;    // [-]  revolutions so far over the life (in revolutions) under the loads so far
  double revolutions = 0.0;  // [-]  of the bore relative to the carrier, since the start; absolute value
  double friction_loss = 0.0;        // [W]
  std::vector<double> inner_load;    // [N]  (rollers)
  std::vector<double> outer_load;    // [N]  (rollers)
  std::vector<double> roller_angle;  // [rad]  (rollers)
};

/// Slopes of the force on the bore [N/m] and [N s/m]: rows x and y; the inner state held.
struct ForceSlopes {
  Eigen::Matrix2d by_displacement = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d by_velocity = Eigen::Matrix2d::Zero();
  Eigen::Vector2d by_speed = Eigen::Vector2d::Zero();  // [N s]  of the bore
};

/// Not for use by two threads at once; any number of objects side by side.
class DrivenBearing final : public Participant {
 public:
  /// Throws std::invalid_argument, with what was found and what is required.
  explicit DrivenBearing(const DrivenBearingSetup& setup);
  ~DrivenBearing() override;
  DrivenBearing(DrivenBearing&&) noexcept;
  DrivenBearing& operator=(DrivenBearing&&) noexcept;

  /// The displacement under the start load, where neither x nor y was given.
  void complete(std::vector<double>& inputs, const std::vector<bool>& given) const override;
  void initialize(double time, const std::vector<double>& inputs) override;
  void advance(const Window& window, const std::vector<InputPolynomial>& inputs) override;
  /// If only the first three are requested, which are the reaction, the rest is not computed.
  std::vector<double> values(const std::vector<double>& inputs, std::size_t number) const override;
  std::vector<double> slopes(const std::vector<double>& inputs, std::size_t input) const override;
  /// Motion of the bore under `inputs`.
  static bearing::motion::BoreMotion motion_of(const std::vector<double>& inputs);

  /// Rollers in equilibrium under the displacement of the bore, all turning at pure rolling. All inputs may
  /// be zero.
  void initialize(const bearing::motion::BoreMotion& motion);
  /// Position of the bore at which the initial force of the bearing is -`load` [N]; speeds of carrier and
  /// bore are those of `motion`. Throws std::runtime_error where no equilibrium is found.
  Eigen::Vector2d position_under(const Eigen::Vector2d& load,
                                 const bearing::motion::BoreMotion& motion) const;
  /// From `window.begin` to its end with `inputs`, whose polynomials count from the beginning. On an error
  /// (std::runtime_error) the state is that at the beginning.
  void advance(const Window& window, const BoreInputs& inputs);
  /// Reaction of the bearing on the bore under the motion at the present time: the cheap part of output().
  bearing::motion::BoreReaction reaction(const bearing::motion::BoreMotion& motion) const;
  /// Under the motion at the present time.
  DrivenBearingOutput output(const bearing::motion::BoreMotion& motion) const;
  ForceSlopes slopes(const bearing::motion::BoreMotion& motion) const;

  /// All that can be read off at the present time.
  void take_snapshot(const bearing::motion::BoreMotion& motion, bearing::motion::Snapshot& into) const;
  /// From now on the loads of every step, weighted by its length, also go to `collector`, which outlives this
  /// or is replaced; null: no longer. No part of the saved state.
  void collect_loads(bearing::motion::StatisticsCollector* collector);

  /// In the order of StateLayout, the bore where it was last.
  Eigen::VectorXd state() const;

  void save(SavedState& state) const override;
  /// Throws std::invalid_argument where `state` is not one of such a bearing.
  void restore(const SavedState& state) override;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace orbearing::system
