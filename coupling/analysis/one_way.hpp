// A planet bearing driven by gears that move without it, on springs and dampers that are fitted to how it
// moved: one way, and yet what gears and bearings do together.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "coupling/analysis/mesh_excitation.hpp"
#include "coupling/system/steady_state.hpp"
#include "gearset/dynamics/parameters.hpp"

namespace orbearing::analysis {

// The linear law that best fits the motion of a bearing: stiffness, damping and offset by least squares.

/// A law and how well it holds. Shares are of its forces under the last motion at the orders that were
/// fitted.
struct FittedBearing {
  gearset::dynamics::AffineBearing bearing;
  double residual = 0.0;  // [-]  what the law leaves of the whole force
  // From another law to that of the last motion only:
  double stiffness_change = 0.0;  // [-]  of the springs' force
  double damping_change = 0.0;    // [-]  of the dampers' force
};

/// Gathers the motions of a bore that is driven at multiples of one frequency. Only motion at these multiples
/// counts: motion of the bore excited by the rollers is resisted by the bore's mass, and would draw a fit of
/// forces over motion towards that mass.
class AffineFit {
 public:
  /// @param angular_frequency [rad/s]
  AffineFit(double angular_frequency, int orders);

  void add(const system::BoreSample& sample);

  /// Begins another motion of the same bearing: one law is fitted to all of them, each weighted by its
  /// duration and half as much as the one after it.
  void begin_motion();

  /// Force = offset - stiffness x position - damping x velocity over all orders and in the mean. `expected`
  /// is what is known beforehand, its stiffness to kExpectedStiffness of the largest, its damping to as much
  /// as it is: it holds where the motion shows no more than its own scatter, as across an orbit that is a
  /// line. Dampers give no energy: where the best ones would, their symmetric part is the nearest that does
  /// not. Offset and shares are those of the last motion.
  /// @param before what changes are counted from: along the motion, since nothing is known across it
  FittedBearing law(const gearset::dynamics::AffineBearing& expected,
                    const gearset::dynamics::AffineBearing& before) const;

  static constexpr double kExpectedStiffness = 0.2;  // [-]

 private:
  using Row = Eigen::Matrix<double, 1, 6>;  // position, velocity, force
  struct Order {
    Row cosine = Row::Zero(), sine = Row::Zero();
    double cosine_weight = 0.0, sine_weight = 0.0;
  };

  // Harmonics of the present motion: twice as many rows as orders, columns of Row.
  Eigen::MatrixXd harmonics() const;

  double angular_frequency_;
  Eigen::MatrixXd before_ = Eigen::MatrixXd(0, 6);  // harmonics of earlier motions, times root of weight
  double before_weight_ = 0.0;                      // of all those rows
  std::vector<Order> orders_;
  Row sum_ = Row::Zero();
  double weight_ = 0.0;
};

/// Conditions under which the law that replaces the bearings counts as found.
struct OneWayOptions {
  double stiffness_change = 0.01;  // [-]  from one run to the next, in its force along the motion
  double damping_change = 0.1;     // [-]  not applied in slow motion (system::is_slow())
  double load_difference = 0.002;  // [-]  of the mean load: a hundredth of the life
  int most_runs = 8;               // of gears and bearing; then the last one is used, and reports it
};

/// The law that replaced the bearings in the gears' motion.
struct OneWayRecord {
  FittedBearing fitted;  // after the last run; its changes are from what the gears moved on in that run
  int runs = 0;          // of gears and bearing
  // [-]  of the gears' mean force on the bearings from the load under which the bearing ran, over that load:
  // the gears have what displaced planets make of it, as where back flanks touch, the bearing has not
  double load_difference = 0.0;
  bool accepted = false;  // both changes, and that difference, within what is allowed
};

/// A bearing in its steady state, and what drove it.
struct OneWayRun {
  system::SteadyStateResult bearing;
  std::optional<OneWayRecord> fit;  // none where the gears give nothing but their mean loads
  // [-]  of the gears' mean force on the bearings from the load of the run, as in OneWayRecord; without one,
  // that of the gears at rest on the bearings' tangent. None where no gears move
  std::optional<double> load_difference = std::nullopt;
};

/// Gears on the tangent of their bearings (`gears`), the bearing under the load that they give it
/// (excitation_of()), the affine law fitted to its motion, and both again on that law until a run agrees with
/// the law that it was driven on. The gears move on the law fitted to all runs but the first (AffineFit),
/// since the results of single runs scatter about it. Runs that do not agree are stopped after a third of the
/// windows, one at least; the last one is observed to its end. If the gears would be unstable on a law, the
/// run that it is fitted to is the last one; if they are all the same, the bearing is driven as before once
/// more. Each run starts from the end of the one before.
/// The bearing has its own outer ring as its part of the planet's mass, and the gears' load is the force that
/// moves that ring as the planet moved: nearly the force of the bearing. With the whole mass, which is as
/// good for a linear bearing, the ring's own vibration on the rollers falls among the mesh harmonics, where a
/// small error of the law is a large one of the motion.
/// @param start state of the bearing to begin with; none: its quasi-static state
/// @throws std::runtime_error where the gears' motion cannot be computed
OneWayRun run_one_way(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                      const BearingDuty& duty, const GearsOnTangent& gears,
                      const std::optional<Eigen::VectorXd>& start = std::nullopt,
                      const OneWayOptions& options = {});

}  // namespace orbearing::analysis
