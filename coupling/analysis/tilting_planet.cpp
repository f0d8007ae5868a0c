#include "coupling/analysis/tilting_planet.hpp"

#include <cmath>
#include <stdexcept>

#include "gearset/dynamics/model.hpp"
#include "gearset/stepped_planet.hpp"

namespace orbearing::analysis {

std::vector<double> axial_positions(const PlanetaryDrivetrain& drivetrain) {
  if (!drivetrain.seats.axial_positions.empty()) return drivetrain.seats.axial_positions;
  if (const std::optional<double>& distance = drivetrain.rows.distance;
      distance && drivetrain.rows.is_tapered())
    return {-0.5 * *distance, 0.5 * *distance};
  const double face = gearset::gear_planes(drivetrain.set).length;
  const int bearings = drivetrain.bearings_per_planet;
  std::vector<double> positions;
  for (int k = 0; k < bearings; ++k) positions.push_back(face * ((k + 0.5) / bearings - 0.5));
  return positions;
}

bearing::PinBeam planet_pin(const PlanetaryDrivetrain& drivetrain) {
  const PinSeats& seats = drivetrain.seats;
  constexpr double default_value = 1.25;  // half a wall at either side, each a quarter of the face
  const double span = gearset::gear_planes(drivetrain.set).length *
                      (seats.ends == bearing::PinEnds::both ? default_value : 1.0);
  const bool bored =
      drivetrain.mounting.state == bearing::ClearanceState::unmounted;    // else a case cannot say so
  const bool ringed = drivetrain.mounting.rings == bearing::Rings::both;  // else rollers run on the pin
  const double bore = ringed ? drivetrain.bearing.inner.seat_diameter
                             : 2.0 * bearing::geometry_of(drivetrain.bearing).inner_radius;
  const bool sleeved = seats.ends == bearing::PinEnds::flexpin;
  return {.diameter = sleeved ? seats.diameter.value_or(bore) : bore,
          .bore = bored ? drivetrain.mounting.pin_bore : 0.0,
          .span = seats.span.value_or(span),
          .ends = seats.ends,
          .material = drivetrain.bearing.material};
}

Eigen::MatrixXd carrier_twist_compliance(const PlanetaryDrivetrain& drivetrain) {
  if (!drivetrain.seats.carrier_twist) return {};
  const double span = planet_pin(drivetrain).span;
  const double radius = gearset::working_geometry(drivetrain.set).centre_distance;
  const std::vector<double> positions = axial_positions(drivetrain);
  const auto count = static_cast<Eigen::Index>(positions.size());
  Eigen::VectorXd at_wall(2 *
                          count);  // by a displacement of the positive wall: of the seats, then their slopes
  for (Eigen::Index k = 0; k < count; ++k) {
    at_wall[k] = 0.5 + positions[static_cast<std::size_t>(k)] / span;
    at_wall[count + k] = 1.0 / span;
  }
  return drivetrain.set.planets * radius * radius / *drivetrain.seats.carrier_twist * at_wall *
         at_wall.transpose();
}

Eigen::Matrix2d mesh_tilt_stiffness(const PlanetaryDrivetrain& drivetrain) {
  if (!drivetrain.gear_set)
    throw std::invalid_argument("tilt of a planet: found gears without meshes; required: one set with teeth");
  gearset::dynamics::SetParameters set = drivetrain.gear_set();
  linearise_meshes(set, set_operation(drivetrain, gearset::working_geometry(drivetrain.set)));
  const auto of_mesh = [](const gearset::dynamics::Mesh& mesh, double face, double side) -> Eigen::Matrix2d {
    const double lever = face * face / 12.0;  // [m^2]
    const Eigen::Vector2d along(side * std::sin(mesh.pressure_angle), std::cos(mesh.pressure_angle));
    return lever * mesh.stiffness.mean() * along * along.transpose();
  };
  return of_mesh(set.sun_mesh, drivetrain.set.face_width, 1.0) +
         of_mesh(set.ring_mesh, gearset::ring_face(drivetrain.set), -1.0);
}

PlanetSeat planet_seat(const PlanetaryDrivetrain& drivetrain) {
  const PinSeats& seats = drivetrain.seats;
  PlanetSeat seat{.positions = axial_positions(drivetrain),
                  .clearance_differences = seats.clearance_differences};
  seat.clearance_differences.resize(seat.positions.size(), 0.0);
  seat.pin_compliance = bearing::pin_compliance(planet_pin(drivetrain), seat.positions);
  if (const Eigen::MatrixXd twist = carrier_twist_compliance(drivetrain); twist.size() > 0)
    seat.tangential_compliance = seat.pin_compliance + twist;
  seat.pin_inclination = {seats.radial_inclination, seats.tangential_inclination};
  seat.tilt_stiffness = mesh_tilt_stiffness(drivetrain);
  return seat;
}

PlanetSeat unlike_planet_seat(const PlanetaryDrivetrain& drivetrain, const BearingDuty& mean) {
  PlanetSeat seat = planet_seat(drivetrain);
  if (seat.tangential_compliance.size() == 0) return seat;
  const bearing::laminae::PlanetOnPinResult planet = tilting_planet(seat, drivetrain, mean);
  const double span = planet_pin(drivetrain).span;
  const double radius = gearset::working_geometry(drivetrain.set).centre_distance;
  double at_wall = 0.0;  // [N]  of each planet on the wall at the positive end, along y
  for (std::size_t k = 0; k < planet.bearings.size(); ++k)
    at_wall += planet.bearings[k].total_bore_load.y() * (0.5 + seat.positions[k] / span) -
               planet.bearings[k].moment.y() / span;
  const double displacement =
      drivetrain.set.planets * radius * radius / *drivetrain.seats.carrier_twist * at_wall;  // [m]
  seat.pin_inclination.y() += displacement / span;  // half of it shifts all pins alike, and loads none
  seat.tangential_compliance.resize(0, 0);
  return seat;
}

PlanetSeat seat_of_each(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry) {
  if (!drivetrain.uneven_planets) return planet_seat(drivetrain);
  return unlike_planet_seat(drivetrain, bearing_duty(drivetrain, geometry));
}

bearing::laminae::PlanetOnPin planet_on(const PlanetSeat& seat, const bearing::Bearing& bearing) {
  bearing::laminae::PlanetOnPin planet{.position = seat.positions,
                                       .pin_compliance = seat.pin_compliance,
                                       .tangential_compliance = seat.tangential_compliance};
  for (const double difference : seat.clearance_differences) {
    bearing::Bearing one = bearing;
    one.radial_clearance += difference;
    planet.bearings.emplace_back(one);
  }
  planet.pin_inclination.assign(seat.positions.size(), seat.pin_inclination);
  for (const double position : seat.positions) planet.pin_error.push_back(position * seat.pin_inclination);
  planet.tilt_stiffness = seat.tilt_stiffness;
  return planet;
}

bearing::laminae::PlanetOnPinResult tilting_planet(const bearing::laminae::PlanetOnPin& planet,
                                                   const bearing::OperatingPoint& point,
                                                   const Eigen::Vector2d& moment,
                                                   const bearing::QuasiStaticOptions& options,
                                                   const bearing::laminae::PlanetOnPinResult* near) {
  bearing::OperatingPoint whole = point;
  whole.bore_load *= static_cast<double>(planet.bearings.size());
  bearing::laminae::PlanetOnPinResult result =
      bearing::laminae::planet_on_pin_over_a_pitch(planet, whole, moment, options, near);
  if (!result.report.converged) throw std::runtime_error(result.report.message);
  return result;
}

bearing::laminae::PlanetOnPinResult tilting_planet(const PlanetSeat& seat,
                                                   const PlanetaryDrivetrain& drivetrain,
                                                   const BearingDuty& duty) {
  return tilting_planet(planet_on(seat, drivetrain.bearing), duty.point,
                        Eigen::Vector2d(duty.gears.overturning_moment, 0.0) + duty.couple,
                        quasi_static_options(drivetrain));
}

namespace {

// Forces of the rollers of one bearing on the waves of an elastic race, mean over the cage angles.
struct PressedWaves {
  Eigen::ArrayXd cosine, sine;  // [N]  (orders)
};

PressedWaves pressed_waves(const bearing::QuasiStaticResult& bearing, Eigen::Index orders, int positions) {
  PressedWaves waves{Eigen::ArrayXd::Zero(orders), Eigen::ArrayXd::Zero(orders)};
  for (Eigen::Index n = 0; n < orders; ++n) {
    const Eigen::ArrayXd turned = static_cast<double>(n) * bearing.angle;
    waves.cosine[n] = (bearing.outer_load * turned.cos()).sum() / positions;
    waves.sine[n] = (bearing.outer_load * turned.sin()).sum() / positions;
  }
  return waves;
}

// The race of each bearing as if all pressed alike, and by the differences of the others' forces: at rest the
// form is that of the planet.
void put_others(const std::vector<bearing::QuasiStaticResult>& bearings, int positions,
                std::vector<SeatedBearing>& seated) {
  const bearing::ElasticRace& race = seated.front().duty.point.outer_race;
  if (race.is_rigid()) return;
  const Eigen::Index orders = race.compliance.size();
  std::vector<PressedWaves> pressed;
  for (const bearing::QuasiStaticResult& one : bearings)
    pressed.push_back(pressed_waves(one, orders, positions));
  const Eigen::ArrayXd by_one = race.compliance / static_cast<double>(bearings.size());
  for (std::size_t k = 0; k < seated.size(); ++k) {
    bearing::ElasticRace& own = seated[k].duty.point.outer_race;
    for (const PressedWaves& other : pressed) {
      own.cosine += by_one * (other.cosine - pressed[k].cosine);
      own.sine += by_one * (other.sine - pressed[k].sine);
    }
  }
}

}  // namespace

std::vector<SeatedBearing> seated_bearings(const PlanetSeat& seat, const PlanetaryDrivetrain& drivetrain,
                                           const DrivetrainGeometry& geometry, const BearingDuty& duty) {
  const bearing::laminae::PlanetOnPinResult planet = tilting_planet(seat, drivetrain, duty);
  bearing::OperatingPoint unloaded = duty.point;
  unloaded.bore_load.setZero();
  const Eigen::Vector2d through_cage =
      total_bore_load(drivetrain.bearing, geometry.bearing, unloaded, drivetrain.dynamics.inertia);
  std::vector<SeatedBearing> all;
  for (std::size_t k = 0; k < planet.bearings.size(); ++k) {
    SeatedBearing one{drivetrain, geometry, duty};
    one.drivetrain.bearing.radial_clearance += seat.clearance_differences[k];
    one.geometry.bearing = bearing::geometry_of(one.drivetrain.bearing);
    one.duty.point.bore_load = planet.bearings[k].total_bore_load - through_cage;
    one.duty.point.bore_tilt = planet.bearing_tilt[k];
    one.duty.share = one.duty.point.bore_load.norm() / duty.point.bore_load.norm();
    one.pin_offset =
        planet.shift - planet.bearings[k].displacement +
        (duty.point.bore_load - one.duty.point.bore_load) / drivetrain.dynamics.support.stiffness;
    all.push_back(std::move(one));
  }
  put_others(planet.bearings, drivetrain.cage_positions, all);
  return all;
}

}  // namespace orbearing::analysis
