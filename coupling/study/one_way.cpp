#include "coupling/study/one_way.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace orbearing::study {

namespace {

using gearset::dynamics::AffineBearing;
using system::SteadyStateResult;

// The first run is so much shorter: it has to lead near the law, not to be reported.
constexpr int kFirstShare = 3;

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
    if (excitation.harmonics.empty()) return false;
    gear_state_ = gears.final_state;
    parameters_.excitation = excitation;
    return true;
  }
  /// The same by a new run of the gears, on the law `before` where they run away on `law`, as meshes that
  /// pump can make them: it becomes the law then.
  bool drive_anew(AffineBearing& law, const AffineBearing& before) {
    GearRunResult gears = gears_on(drivetrain_, geometry_, law, gear_state_);
    if (!gears.completed) gears = gears_on(drivetrain_, geometry_, law = before, gear_state_);
    require_completed(gears);
    return drive(law, gears);
  }

  SteadyStateResult run_bearing(const bearing::motion::DynamicsParameters& parameters,
                                const system::SteadyStateOptions& options) const {
    return run_to_steady_state(drivetrain_.bearing, duty_.point, parameters, options, bearing_state_);
  }

  /// The bearing as it is driven now; what is fitted to it goes into `fitted`. `tangent` is what is known
  /// beforehand, in each run alike: drawn to the law before, what no motion shows would wander.
  SteadyStateResult run(const AffineBearing& law, const AffineBearing& tangent, bool first,
                        FittedBearing& fitted) {
    AffineFit fit(parameters_.excitation.angular_frequency, excitation_orders(drivetrain_, geometry_, law));
    system::SteadyStateOptions options = drivetrain_.steady_state;
    if (first) options.observed_windows = std::max(1, options.observed_windows / kFirstShare);
    options.on_bore = [&](const system::BoreSample& sample) { fit.add(sample); };
    SteadyStateResult result = run_bearing(parameters_, options);
    if (!result.completed) return result;
    bearing_state_ = result.final_state;
    const double number = drivetrain_.bearings_per_planet;
    fitted = fit.law(times(1.0 / number, tangent), times(1.0 / number, law));
    fitted.bearing = times(number, fitted.bearing);
    return result;
  }

 private:
  const PlanetaryDrivetrain& drivetrain_;
  const DrivetrainGeometry& geometry_;
  const BearingDuty& duty_;
  bearing::motion::DynamicsParameters parameters_;
  std::optional<Eigen::VectorXd> gear_state_, bearing_state_;
};

// Gears on a law that gives energy run away: such a law is chance, of a motion too short or too small.
// Dampers that take energy are asked for beside: what the gears' own dampers make up for would still be no
// bearing.
bool may_stand(const PlanetaryDrivetrain& drivetrain, const AffineBearing& law) {
  const Eigen::Matrix2d both = law.damping + law.damping.transpose();
  return both.trace() > 0.0 && both.determinant() > 0.0 && gears_stay_on(drivetrain, law);
}

// The last run in `record`, which it may be accepted with.
void note(const FittedBearing& fitted, const OneWayOptions& options, OneWayRecord& record) {
  ++record.runs;
  record.fitted = fitted;
  record.accepted = record.runs > 1 && fitted.stiffness_change <= options.stiffness_change &&
                    fitted.damping_change <= options.damping_change;
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
  AffineBearing law = tangent, before = tangent;
  OneWayRecord record;
  do {
    FittedBearing fitted;
    result.bearing = one_way.run(law, tangent, record.runs == 0, fitted);
    if (!result.bearing.completed) return result;
    note(fitted, options, record);
    before = law;
    if (may_stand(drivetrain, fitted.bearing)) law = fitted.bearing;
  } while (record.runs < options.most_runs && !record.accepted && one_way.drive_anew(law, before));
  result.fit = record;
  return result;
}

}  // namespace orbearing::study
