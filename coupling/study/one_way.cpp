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

// With its own outer ring for a bore: the planet's body stays with the gears. The support keeps its damper,
// which is stated as a ratio of what moves.
bearing::motion::DynamicsParameters on_its_ring(const DrivetrainGeometry& geometry,
                                                bearing::motion::DynamicsParameters parameters) {
  const double pin = geometry.bearing.inner_ring_mass, ring = geometry.bearing.outer_ring_mass;
  if (!(ring > 0.0)) return parameters;
  parameters.support.damping_ratio *= std::sqrt((parameters.bore_mass + pin) / (ring + pin));
  parameters.bore_mass = ring;
  return parameters;
}

// The runs so far: where gears and bearing stand.
class OneWay {
 public:
  OneWay(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry, const BearingDuty& duty,
         const std::optional<Eigen::VectorXd>& start)
      : drivetrain_(drivetrain),
        geometry_(geometry),
        duty_(duty),
        parameters_(on_its_ring(geometry, bearing_dynamics(drivetrain, geometry))),
        bearing_state_(start) {}

  /// Driven by gears that moved on `law`; false where they give nothing but their mean loads.
  bool drive(const AffineBearing& law, const GearRunResult& gears) {
    const bearing::motion::MeshExcitation excitation =
        excitation_of(gears, drivetrain_, duty_, law, parameters_.bore_mass);
    gear_state_ = gears.final_state;
    parameters_.excitation = excitation;
    return !excitation.harmonics.empty();
  }
  /// The same by a new run of `gears`, which are on `law`. False where they run away: the bearing is driven
  /// as before then.
  bool drive_by(const GearsOnLaw& gears, const AffineBearing& law) {
    const GearRunResult run = gears.run(gear_state_);
    if (run.completed) drive(law, run);
    return run.completed;
  }

  SteadyStateResult run_bearing(const bearing::motion::DynamicsParameters& parameters,
                                const system::SteadyStateOptions& options) const {
    return run_to_steady_state(drivetrain_.bearing, duty_.point, parameters, options, bearing_state_);
  }

  /// The bearing as it is driven now, on gears that moved on `law`. The law fitted to it, and to the motions
  /// before but for the first, which only leads near it, is shown to `goes_on` after a part of the windows:
  /// where that says no, the run ends there. `tangent` is what is known beforehand, in each run alike: drawn
  /// to the law before, what no motion shows would wander.
  SteadyStateResult run(const AffineBearing& law, const AffineBearing& tangent,
                        const std::function<bool(const FittedBearing&)>& goes_on, FittedBearing& fitted) {
    begin_motion(law);
    const double number = drivetrain_.bearings_per_planet;
    const auto fit = [&] {
      fitted = fit_->law(times(1.0 / number, tangent), times(1.0 / number, law));
      fitted.bearing = times(number, fitted.bearing);
    };
    system::SteadyStateOptions options = drivetrain_.steady_state;
    options.on_bore = [&](const system::BoreSample& sample) { fit_->add(sample); };
    options.look = {std::max(1, options.observed_windows / kLookShare), [&] {
                      fit();
                      return goes_on(fitted);
                    }};
    SteadyStateResult result = run_bearing(parameters_, options);
    if (!result.completed) return result;
    bearing_state_ = result.final_state;
    fit();
    return result;
  }

 private:
  void begin_motion(const AffineBearing& law) {
    if (runs_++ > 1) return fit_->begin_motion();
    fit_.emplace(parameters_.excitation.angular_frequency, excitation_orders(drivetrain_, geometry_, law));
  }

  const PlanetaryDrivetrain& drivetrain_;
  const DrivetrainGeometry& geometry_;
  const BearingDuty& duty_;
  bearing::motion::DynamicsParameters parameters_;
  std::optional<Eigen::VectorXd> gear_state_, bearing_state_;
  std::optional<AffineFit> fit_;
  int runs_ = 0;
};

/// @param margin on what is allowed
bool is_close(const FittedBearing& fitted, const OneWayOptions& options, double margin = 1.0) {
  return fitted.stiffness_change <= margin * options.stiffness_change &&
         fitted.damping_change <= margin * options.damping_change;
}

}  // namespace

OneWayRun run_one_way(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                      const BearingDuty& duty, const GearsOnTangent& gears,
                      const std::optional<Eigen::VectorXd>& start, const OneWayOptions& options) {
  OneWay one_way(drivetrain, geometry, duty, start);
  OneWayRun result;
  const AffineBearing& tangent = gears.tangent;
  if (!one_way.drive(tangent, gears.run)) {
    result.bearing = one_way.run_bearing(bearing_dynamics(drivetrain, geometry), drivetrain.steady_state);
    return result;
  }
  AffineBearing law = tangent;
  OneWayRecord record;
  std::optional<GearsOnLaw> next;
  bool last = false;   // whatever comes of it
  bool whole = false;  // observed to its end
  const auto goes_on = [&](const FittedBearing& fitted) {
    whole = last || is_close(fitted, options, kLookMargin);
    if (whole) return true;
    next.emplace(drivetrain, geometry, fitted.bearing);
    return whole = last = !next->stay_on();  // there is no better law to go to
  };
  while (true) {
    last = ++record.runs >= options.most_runs || last;
    next.reset();
    result.bearing = one_way.run(law, tangent, goes_on, record.fitted);
    if (!result.bearing.completed) return result;
    record.accepted = is_close(record.fitted, options);
    if (record.accepted || last) break;
    if (!next) next.emplace(drivetrain, geometry, record.fitted.bearing);
    if (!next->stay_on()) break;
    if (one_way.drive_by(*next, record.fitted.bearing)) {
      law = record.fitted.bearing;
      continue;
    }
    if (whole) break;
    last = true;  // driven as before, and observed to the end
  }
  result.fit = record;
  return result;
}

}  // namespace orbearing::study
