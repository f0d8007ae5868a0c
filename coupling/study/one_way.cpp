#include "coupling/study/one_way.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace orbearing::study {

namespace {

using gearset::dynamics::AffineBearing;
using system::SteadyStateResult;

// [-]  of the observed windows, after which the law is looked at: what leads near it need not be reported.
constexpr int kLookShare = 3;
constexpr double kLookMargin = 2.0;  // [-]  on the changes that are allowed: less motion scatters more

AffineBearing times(double factor, const AffineBearing& law) {
  return {factor * law.force, factor * law.stiffness, factor * law.damping};
}

// With its own outer ring, where it has one, for a bore: the planet's body stays with the gears. The support keeps
// its damper, which is stated as a ratio of what moves.
bearing::motion::DynamicsParameters on_its_ring(const DrivetrainGeometry& geometry,
                                                bearing::motion::DynamicsParameters parameters) {
  const double pin = geometry.bearing.inner_ring_mass, ring = geometry.bearing.outer_ring_mass;
  if (ring == 0.0) return parameters;
  parameters.support.damping_ratio *= std::sqrt((parameters.bore_mass + pin) / (ring + pin));
  parameters.bore_mass = ring;
  return parameters;
}

// Gears and bearing in turn: where they stand, and what is known of the law.
class OneWay {
 public:
  OneWay(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry, const BearingDuty& duty,
         const std::optional<Eigen::VectorXd>& start, const OneWayOptions& options)
      : drivetrain_(drivetrain),
        geometry_(geometry),
        duty_(duty),
        options_(options),
        parameters_(on_its_ring(geometry, bearing_dynamics(drivetrain, geometry))),
        bearing_state_(start) {}

  /// Until a run agrees with the law that it was driven on, or there is no better law to go to.
  OneWayRun run(const GearsOnTangent& gears) {
    tangent_ = gears.tangent;
    if (!drive(tangent_, gears.run))
      return {run_bearing(bearing_dynamics(drivetrain_, geometry_), drivetrain_.steady_state), std::nullopt};
    OneWayRun result;
    do {
      last_ = ++record_.runs >= options_.most_runs || last_;
      result.bearing = run_driven();
      if (!result.bearing.completed) return result;
      record_.accepted = is_close(1.0);
    } while (!record_.accepted && !last_ && go_to_fitted_law());
    record_.accepted = record_.accepted && record_.load_difference <= options_.load_difference;
    result.fit = record_;
    return result;
  }

 private:
  // By gears that moved on `law`; false where they give nothing but their mean loads.
  bool drive(const AffineBearing& law, const GearRunResult& gears) {
    law_ = law;
    gear_state_ = gears.final_state;
    parameters_.excitation = excitation_of(gears, drivetrain_, duty_, law, parameters_.bore_mass);
    if (parameters_.excitation.harmonics.empty()) return false;
    const PlanetStatistics& planet = gears.planets[static_cast<std::size_t>(duty_.planet)];
    const Eigen::Vector2d on_planet(planet.radial_force.mean, planet.tangential_force.mean),
        load = drivetrain_.bearings_per_planet * duty_.point.bore_load;
    record_.load_difference = (on_planet + load).norm() / load.norm();
    return true;
  }

  SteadyStateResult run_bearing(const bearing::motion::DynamicsParameters& parameters,
                                const system::SteadyStateOptions& options) const {
    return run_to_steady_state(drivetrain_.bearing, duty_.point, parameters, options, bearing_state_);
  }

  // The bearing as it is driven now, looked at on the way.
  SteadyStateResult run_driven() {
    begin_motion();
    system::SteadyStateOptions options = drivetrain_.steady_state;
    options.on_bore = [this](const system::BoreSample& sample) { fit_->add(sample); };
    options.look = {std::max(1, options.observed_windows / kLookShare), [this] { return goes_on(); }};
    SteadyStateResult result = run_bearing(parameters_, options);
    if (!result.completed) return result;
    bearing_state_ = result.final_state;
    if (whole_) fit();  // else to what the look saw
    return result;
  }

  // The first motion only leads near the law: it is forgotten.
  void begin_motion() {
    if (record_.runs > 2) return fit_->begin_motion();
    fit_.emplace(parameters_.excitation.angular_frequency, excitation_orders(drivetrain_, geometry_, law_));
  }

  // The tangent is what is known beforehand, in each run alike: drawn to the law before, what no motion shows
  // would wander.
  void fit() {
    const double number = drivetrain_.bearings_per_planet;
    record_.fitted = fit_->law(times(1.0 / number, tangent_), times(1.0 / number, law_));
    record_.fitted.bearing = times(number, record_.fitted.bearing);
  }

  // Asked in a run: is it to be observed to its end?
  bool goes_on() {
    fit();
    next_.reset();
    whole_ = last_ || is_close(kLookMargin);
    if (whole_) return true;
    next_.emplace(drivetrain_, geometry_, record_.fitted.bearing);
    return whole_ = last_ = !next_->stay_on();  // there is no better law to go to
  }

  // False where gears run away on it, and the last run was observed to its end.
  bool go_to_fitted_law() {
    if (!next_) next_.emplace(drivetrain_, geometry_, record_.fitted.bearing);
    if (!next_->stay_on()) return false;
    const GearRunResult gears = next_->run(gear_state_);
    if (gears.completed) {
      drive(record_.fitted.bearing, gears);
      return true;
    }
    last_ = true;  // driven as before, once more
    return !whole_;
  }

  /// @param margin on what is allowed
  bool is_close(double margin) const {
    return record_.fitted.stiffness_change <= margin * options_.stiffness_change &&
           record_.fitted.damping_change <= margin * options_.damping_change;
  }

  const PlanetaryDrivetrain& drivetrain_;
  const DrivetrainGeometry& geometry_;
  const BearingDuty& duty_;
  const OneWayOptions& options_;
  bearing::motion::DynamicsParameters parameters_;
  AffineBearing tangent_, law_;  // law_: that the gears moved on
  std::optional<Eigen::VectorXd> gear_state_, bearing_state_;
  std::optional<AffineFit> fit_;
  OneWayRecord record_;
  std::optional<GearsOnLaw> next_;  // on the fitted law, where it was asked for
  bool last_ = false;               // of the runs, whatever comes of it
  bool whole_ = false;              // the run was observed to its end
};

}  // namespace

OneWayRun run_one_way(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                      const BearingDuty& duty, const GearsOnTangent& gears,
                      const std::optional<Eigen::VectorXd>& start, const OneWayOptions& options) {
  return OneWay(drivetrain, geometry, duty, start, options).run(gears);
}

}  // namespace orbearing::study
