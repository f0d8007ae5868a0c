#include "coupling/analysis/planet_scratch.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "coupling/analysis/driven_setups.hpp"
#include "coupling/analysis/load_sharing.hpp"
#include "coupling/analysis/low_pass.hpp"
#include "coupling/analysis/tilting_planet.hpp"
#include "coupling/diagnosis/defect_view.hpp"
#include "coupling/system/monolithic.hpp"
#include "gearset/mean_loads.hpp"
#include "gearset/planet_angles.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::analysis {

namespace {

using constants::two_pi;

// Outward, along, housing.
using PlanetLowPass = InstrumentLowPass<3>;

// Share of a ring mesh that an instrument on the housing measures, the planet being `angle` [rad] from it.
double share_at_sensor(double angle) {
  return 0.5 * (1.0 + std::cos(angle));
}

// Angles that turn at the nominal speeds, run-up included.
class Turning {
 public:
  explicit Turning(const gearset::dynamics::Operation& operation) : operation_(operation) {}

  double carrier(double time) const { return operation_.speeds.carrier * passed(time); }         // [rad]
  double planet(double time) const { return operation_.speeds.planet_relative * passed(time); }  // [rad]

 private:
  double passed(double time) const {
    return mesh_periods(operation_, time) / operation_.mesh_frequency;
  }  // [s]

  const gearset::dynamics::Operation& operation_;
};

double housing_force(const system::DrivenGearsOutput& gears, const std::vector<double>& positions,
                     double carrier_angle) {
  double force = 0.0;
  for (std::size_t i = 0; i < gears.planets.size(); ++i)
    force += share_at_sensor(carrier_angle + positions[i]) * gears.planets[i].ring_mesh_force;
  return force;
}

struct Plan {
  long settling = 0, samples = 0;  // [-]
  double rate = 0.0;               // [Hz]

  long instants() const {
    return PlanetLowPass::kOversampling * (settling + samples + 2 * PlanetLowPass::kReach);
  }
  double interval() const { return 1.0 / (static_cast<double>(PlanetLowPass::kOversampling) * rate); }  // [s]
};

// A run-up of mean speed (1 + from)/2 takes as many revolutions in a longer time.
Plan plan_of(const PlanetSampling& sampling, double carrier_speed) {
  const double revolution = two_pi / std::abs(carrier_speed);  // [s]
  const double from = sampling.run_up_from;
  return {std::lround(sampling.settling_revolutions * revolution / from * sampling.rate),
          std::max(2L, std::lround(sampling.revolutions * revolution * 2.0 / (1.0 + from) * sampling.rate)),
          sampling.rate};
}

Eigen::Index scratched_roller(const std::vector<system::ScratchedPlanet>& scratched) {
  if (scratched.empty()) return 0;
  for (const bearing::defect::Scratch& one : scratched.front().scratches)
    if (of_element(one.race)) return one.element - 1;
  return 0;
}

}  // namespace

PlanetFrequencies planet_frequencies(const PlanetaryDrivetrain& drivetrain) {
  const gearset::dynamics::Operation operation =
      set_operation(drivetrain, gearset::working_geometry(drivetrain.set));
  const double planet = operation.speeds.planet_relative;
  return {.carrier = std::abs(operation.speeds.carrier) / two_pi,
          .planet = std::abs(planet) / two_pi,
          .mesh = operation.mesh_frequency,
          .planets = drivetrain.set.planets,
          .bearing = bearing::defect::passing_frequencies(drivetrain.bearing, 0.0, planet)};
}

Eigen::Vector2d load_on_bearing(const PlanetaryDrivetrain& drivetrain, int planet, int bearing) {
  const DrivetrainGeometry geometry = derive(drivetrain);
  if (drivetrain.seats.tilt != TiltState::computed) return bearing_duty(drivetrain, geometry).point.bore_load;
  const std::vector<BearingDuty> duties = planet_duties(drivetrain, geometry);
  const BearingDuty& duty = duties.at(duties.size() == 1 ? 0 : static_cast<std::size_t>(planet));
  return seated_bearings(seat_of_each(drivetrain, geometry), drivetrain, geometry, duty)
      .at(static_cast<std::size_t>(bearing))
      .duty.point.bore_load;
}

PlanetVibration sample_vibration(const PlanetaryDrivetrain& drivetrain,
                                 const std::vector<system::ScratchedPlanet>& scratched,
                                 const PlanetSampling& sampling,
                                 const std::function<void(double)>& progress) {
  constexpr long kShown = 100;  // times that progress is reported
  system::CoupledSetup setup = coupled_setup(drivetrain, derive(drivetrain));
  setup.scratched = scratched;
  gearset::dynamics::Operation& operation = setup.gears.operation;
  const Plan plan = plan_of(sampling, operation.speeds.carrier);
  if (sampling.run_up_from < 1.0)
    operation.run_up = {sampling.run_up_from, static_cast<double>(plan.instants()) * plan.interval()};
  const int planet = scratched.empty() ? 0 : scratched.front().planet;
  const int bearing =
      planet * setup.bearings_per_planet + (scratched.empty() ? 0 : scratched.front().bearing);
  const Turning rotating(operation);
  const std::vector<double> positions = gearset::angles_of_planets(drivetrain.set);

  system::Monolithic motion(setup);
  PlanetVibration out{.rate = plan.rate,
                      .begin = static_cast<double>(plan.settling + PlanetLowPass::kReach) / plan.rate};
  out.acceleration.resize(2, plan.samples);
  for (Eigen::ArrayXd* one : {&out.housing, &out.carrier_angle, &out.planet_angle}) one->resize(plan.samples);
  PlanetLowPass low_pass;
  bearing::motion::Snapshot shown;
  double cage_then = 0.0, time_then = 0.0;
  const Eigen::Index roller = scratched_roller(scratched);
  try {
    motion.initialize(0.0);
    Eigen::Vector2d before = motion.gears().planets[static_cast<std::size_t>(planet)].velocity;
    for (long i = 1; i <= plan.instants(); ++i) {
      const double time = static_cast<double>(i) * plan.interval();
      motion.follow(time);
      const system::DrivenGearsOutput gears = motion.gears();
      const Eigen::Vector2d velocity = gears.planets[static_cast<std::size_t>(planet)].velocity;
      const Eigen::Vector2d acceleration = (velocity - before) / plan.interval();
      before = velocity;
      low_pass.take(
          {acceleration.x(), acceleration.y(), housing_force(gears, positions, rotating.carrier(time))});
      if (i % PlanetLowPass::kOversampling != 0) continue;
      const long now = i / PlanetLowPass::kOversampling - plan.settling - PlanetLowPass::kReach;
      if (now >= 0 && now < plan.samples) {
        out.carrier_angle[now] = rotating.carrier(time);
        out.planet_angle[now] = rotating.planet(time);
        motion.take_snapshot(bearing, shown);
        out.largest_load =
            std::max({out.largest_load, shown.inner.load.maxCoeff(), shown.outer.load.maxCoeff()});
        out.roller_speed += shown.spin[roller] / static_cast<double>(plan.samples);
        if (now == 0) cage_then = shown.orbit_angle, time_then = time;
        if (now == plan.samples - 1) {
          out.cage_speed = (shown.orbit_angle - cage_then) / (time - time_then);
          out.planet_speed = (out.planet_angle[now] - out.planet_angle[0]) / (time - time_then);
        }
      }
      const long done = now - PlanetLowPass::kReach;
      if (done >= 0 && done < plan.samples) {
        const Eigen::Array3d passed = low_pass.value();
        out.acceleration.col(done) = passed.head<2>();
        out.housing[done] = passed[2];
      }
      if (progress && i % std::max(1L, plan.instants() / kShown) == 0)
        progress(static_cast<double>(i) / static_cast<double>(plan.instants()));
    }
    out.report = motion.report();
  } catch (const std::runtime_error& error) {
    return {.rate = plan.rate, .report = {.message = error.what()}};
  }
  return out;
}

PlanetFrequencies as_turned(const PlanetFrequencies& rolling, const PlanetVibration& motion, int rollers,
                            bool run_up) {
  PlanetFrequencies turned = rolling;
  if (run_up) {
    const double share = std::abs(motion.planet_speed) / (two_pi * rolling.planet);
    for (double* one : {&turned.carrier, &turned.planet, &turned.mesh}) *one *= share;
    turned.bearing = diagnosis::slower(rolling.bearing, share);
  }
  bearing::defect::PassingFrequencies& at = turned.bearing;
  at.cage = std::abs(motion.cage_speed) / two_pi;
  at.outer_pass = rollers * std::abs(motion.planet_speed - motion.cage_speed) / two_pi;
  at.inner_pass = rollers * at.cage;
  at.element_pass = 2.0 * std::abs(motion.roller_speed - motion.cage_speed) / two_pi;
  return turned;
}

}  // namespace orbearing::analysis
