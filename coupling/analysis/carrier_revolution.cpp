#include "coupling/analysis/carrier_revolution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>

#include "bearing/life/rating_record.hpp"
#include "coupling/analysis/rated_bearing.hpp"
#include "coupling/analysis/tilting_planet.hpp"
#include "coupling/system/steady_state.hpp"
#include "gearset/planet_angles.hpp"
#include "gearset/spatial/housing_stiffness.hpp"
#include "gearset/spatial/spatial_balance.hpp"
#include "mechanics/checks.hpp"
#include "mechanics/record.hpp"

namespace orbearing::analysis {

namespace {

using described::Record;
namespace dimension = described::dimension;
namespace spatial = gearset::spatial;
using Eigen::Index;
using Eigen::Vector2d;
using gearset::dynamics::SetParameters;

void require_length(const std::vector<double>& list, std::size_t length, const std::string& name,
                    bool may_lack) {
  if (list.size() == length || (may_lack && list.empty())) return;
  throw std::invalid_argument("gearset.carrier." + name + ": found " + std::to_string(list.size()) +
                              " values; required: " + (may_lack ? "none or " : "") + std::to_string(length));
}

// Checks a list; a file of it is checked line by line as it is read.
void require_housing(const spatial::CarrierMounting& mounting) {
  if (mounting.housing.empty()) return;
  const std::size_t rows = spatial::kSeatDirections * mounting.positions.size();
  require_length(mounting.housing, rows * rows, "housing_stiffness", true);
  if (const auto fault =
          spatial::housing_fault(spatial::matrix_of_rows(mounting.housing), mounting.positions))
    throw std::invalid_argument("gearset.carrier.housing_stiffness: found " + fault->found +
                                "; required: " + fault->required);
}

std::vector<spatial::CarrierBearing> carrier_bearings(const spatial::CarrierMounting& mounting) {
  std::vector<spatial::CarrierBearing> bearings;
  for (std::size_t i = 0; i < mounting.positions.size(); ++i) {
    const double radial = mounting.radial_stiffness[i];
    bearings.push_back({.position = mounting.positions[i],
                        .radial_stiffness = radial,
                        .axial_stiffness = i == 0 ? radial : 0.0,
                        .clearance = mounting.clearances.empty() ? 0.0 : 0.5 * mounting.clearances[i]});
  }
  return bearings;
}

// A mean stiffness of the transverse section, along the normal of helical flanks and per width.
spatial::SpatialMesh mesh_of(const gearset::dynamics::Mesh& mesh, double base_helix_angle, double width) {
  const double cosine = std::cos(base_helix_angle);
  return {.stiffness = mesh.stiffness.mean() / (cosine * cosine * width),
          .pressure_angle = mesh.pressure_angle,
          .base_helix = base_helix_angle,
          .backlash = mesh.backlash};
}

spatial::SpatialLoad spatial_load(const gearset::dynamics::Operation& operation, bool centrifugal,
                                  const spatial::CarrierMounting& mounting) {
  spatial::SpatialLoad load{.torque = operation.torques.carrier,
                            .speed = centrifugal ? operation.speeds.carrier : 0.0,
                            .gravity = mounting.gravity,
                            .axis_tilt = mounting.axis_tilt};
  if (!mounting.rotor_force.empty())
    load.rotor.force = Eigen::Map<const Eigen::Vector3d>(mounting.rotor_force.data());
  if (!mounting.rotor_moment.empty())
    load.rotor.moment.head<2>() = Eigen::Map<const Eigen::Vector2d>(mounting.rotor_moment.data());
  return load;
}

// A row of rollers holds its planet against tilting: several springs along the rollers replace one.
constexpr int kRowParts = 5;

// Load of the row on the bore of its planet, outward and ahead.
Vector2d row_load(const spatial::SpatialBalance& at, Index row, Index planet) {
  const auto sum = [&](const Eigen::MatrixXd& parts) {
    return parts.col(planet).segment(row * kRowParts, kRowParts).sum();
  };
  return -Vector2d(sum(at.bearing_radial), sum(at.bearing_tangential));
}

double row_position(const spatial::SpatialSet& set, Index row) {
  return set.planet_bearings[static_cast<std::size_t>(row * kRowParts + kRowParts / 2)].position;
}

// Angles of the carrier over a revolution. Equal planets at equal steps have the same loads one after
// another: then one step between them is sufficient.
struct Angles {
  Index all = 0;       // of the revolution
  Index computed = 0;  // from the first on
  Index step = 0;      // by so many the next planet is ahead; 0: planets are unlike

  double at(Index i) const {
    return 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(all);
  }
};

Angles angles_of(const spatial::SpatialSet& set, bool even, const RevolutionOptions& options) {
  const auto planets = static_cast<Index>(set.angles.size());
  const Index least = (options.angles + planets - 1) / planets;
  const Index step = (least + options.life_step - 1) / options.life_step * options.life_step;
  const bool alike = even && set.pin_errors.cols() == 0;
  return {planets * step, alike ? step : planets * step, alike ? step : 0};
}

// Loads and tilts of planets over the revolution: columns of planets and their rows, or of one planet if all
// are equal, by its position in the revolution.
struct History {
  std::vector<Eigen::Matrix2Xd> load;  // [N]    (rows of planets)  (2, angles)  of the rows on the bore
  std::vector<Eigen::Matrix2Xd> tilt;  // [rad]  (planets)  (2, angles)
};

class Revolution {
 public:
  Revolution(const spatial::SpatialSet& set, const spatial::SpatialLoad& load, const Angles& angles,
             const RevolutionOptions& options)
      : set_(set),
        angles_(angles),
        planets_(static_cast<Index>(set.angles.size())),
        rows_(static_cast<Index>(set.planet_bearings.size()) / kRowParts) {
    const Index unlike = angles.step > 0 ? 1 : planets_;
    history_.load.assign(static_cast<std::size_t>(unlike * rows_), Eigen::Matrix2Xd(2, angles.all));
    history_.tilt.assign(static_cast<std::size_t>(unlike), Eigen::Matrix2Xd(2, angles.all));
    begin(options);
    spatial::SpatialBalance at;
    for (Index i = 0; i < angles.computed; ++i) {
      at = spatial::balance(set, load, angles.at(i), options.slices, at.position);
      add(at, i);
    }
    finish();
  }

  const History& history() const { return history_; }
  const CarrierRevolution& result() const { return result_; }
  Index rows() const { return rows_; }
  Index planets() const { return planets_; }

 private:
  void begin(const RevolutionOptions& options) {
    const double width = set_.face_width / options.slices;
    result_.height = (Eigen::ArrayXd::LinSpaced(options.slices, 0.5, options.slices - 0.5) * width) -
                     0.5 * set_.face_width;
    for (Index p = 0; p < planets_; ++p)
      for (const bool of_sun : {true, false})
        result_.meshes.push_back({.planet = static_cast<int>(p), .of_sun = of_sun, .by_width = {}});
    for (const spatial::CarrierBearing& bearing : set_.carrier_bearings)
      result_.carrier_bearings.push_back({bearing.position, std::numeric_limits<double>::infinity(), 0.0});
  }

  // Contribution of one angle.
  void add(const spatial::SpatialBalance& at, Index i) {
    for (Index p = 0; p < planets_; ++p) {
      // Column in which the first planet is at the present angle of this one.
      const Index column = angles_.step > 0 ? (i + p * angles_.step) % angles_.all : i;
      const std::size_t planet = angles_.step > 0 ? 0 : static_cast<std::size_t>(p);
      history_.tilt[planet].col(column) = at.planet_tilt.col(p);
      for (Index row = 0; row < rows_; ++row)
        history_.load[planet * static_cast<std::size_t>(rows_) + static_cast<std::size_t>(row)].col(column) =
            row_load(at, row, p);
      widen(at.sun_mesh, p, result_.meshes[2 * static_cast<std::size_t>(p)]);
      widen(at.ring_mesh, p, result_.meshes[2 * static_cast<std::size_t>(p) + 1]);
    }
    const auto to = [](double& largest, double value) { largest = std::max(largest, value); };
    for (const spatial::MeshForces* mesh : {&at.sun_mesh, &at.ring_mesh})
      to(result_.mesh_load_factor, mesh->force.maxCoeff() / mesh->force.mean());
    to(result_.carrier_shift, at.carrier_shift.head<2>().norm());
    to(result_.carrier_tilt, at.carrier_tilt.head<2>().norm());
    for (std::size_t b = 0; b < result_.carrier_bearings.size(); ++b) {
      CarrierBearingOverRevolution& bearing = result_.carrier_bearings[b];
      const double load = at.carrier_bearing[static_cast<Index>(b)];
      bearing.least = std::min(bearing.least, load);
      to(bearing.largest, load);
    }
  }

  static void widen(const spatial::MeshForces& at, Index planet, MeshOverRevolution& mesh) {
    mesh.mean += at.force[planet];  // a sum until all are in
    mesh.largest = std::max(mesh.largest, at.force[planet]);
    mesh.largest_back = std::max(mesh.largest_back, at.back[planet]);
    mesh.face_load = std::max(mesh.face_load, at.face_load[planet]);
    const Eigen::ArrayXd by_width = at.by_width.col(planet);
    if (mesh.by_width.size() == 0 || by_width.maxCoeff() > mesh.by_width.maxCoeff()) mesh.by_width = by_width;
  }

  // Meshes of planets that are alike have each seen but a part of what all see in turn.
  void finish() {
    for (MeshOverRevolution& mesh : result_.meshes) mesh.mean /= static_cast<double>(angles_.computed);
    if (angles_.step == 0) return;
    for (const bool of_sun : {true, false}) {
      MeshOverRevolution all{.of_sun = of_sun, .by_width = {}};
      for (const MeshOverRevolution& mesh : result_.meshes) {
        if (mesh.of_sun != of_sun) continue;
        all.mean += mesh.mean / static_cast<double>(planets_);
        all.largest = std::max(all.largest, mesh.largest);
        all.largest_back = std::max(all.largest_back, mesh.largest_back);
        all.face_load = std::max(all.face_load, mesh.face_load);
        if (all.by_width.size() == 0 || mesh.by_width.maxCoeff() > all.by_width.maxCoeff())
          all.by_width = mesh.by_width;
      }
      for (MeshOverRevolution& mesh : result_.meshes) {
        if (mesh.of_sun != of_sun) continue;
        all.planet = mesh.planet;
        mesh = all;
      }
    }
  }

  const spatial::SpatialSet& set_;
  Angles angles_;
  Index planets_, rows_;
  History history_;
  CarrierRevolution result_;
};

// The same bearing at each angle.
std::vector<BearingDuty> duties_of(const BearingDuty& even, const Eigen::Matrix2Xd& load,
                                   const Eigen::Matrix2Xd& tilt) {
  std::vector<BearingDuty> duties;
  for (Index i = 0; i < load.cols(); ++i) {
    duties.push_back(even);
    duties.back().point.bore_load = load.col(i);
    duties.back().point.bore_tilt = tilt.col(i);
  }
  return duties;
}

// Its loads with cage and rollers, and its lives.
BearingOverRevolution over_revolution(const PlanetBearingRating& rating, BearingsAtRest& at_rest,
                                      const std::vector<BearingDuty>& duties, int life_step,
                                      std::vector<double>& loads) {
  BearingOverRevolution over;
  std::vector<bearing::motion::WindowStatistics> means;
  const PlanetaryDrivetrain& drivetrain = rating.drivetrain();
  const int laminae = drivetrain.bearing.rollers().laminae;
  const auto add_pressure = [&](const bearing::motion::WindowStatistics& at) {
    const auto largest = [&](const bearing::motion::RaceStatistics& race) {
      return race.lamina_load_max > 0.0 ? laminae * race.lamina_load_max : race.load_max;
    };
    over.largest_pressure =
        std::max(over.largest_pressure,
                 largest_hertz_pressure(drivetrain, rating.geometry(), largest(at.inner), largest(at.outer)));
  };
  for (std::size_t i = 0; i < duties.size(); ++i) {
    loads.push_back(rating.load_of(duties[i]));
    over.mean += loads.back() / static_cast<double>(duties.size());
    over.largest_tilt = std::max(over.largest_tilt, duties[i].point.bore_tilt.norm());
    if (i % static_cast<std::size_t>(life_step) == 0) means.push_back(at_rest.one(duties[i]).means);
  }
  const auto most = static_cast<std::size_t>(std::ranges::max_element(loads) - loads.begin());
  over.least = std::ranges::min(loads);
  over.largest = loads[most];
  for (const bearing::motion::WindowStatistics& at : means) add_pressure(at);
  if (most % static_cast<std::size_t>(life_step) != 0) add_pressure(at_rest.one(duties[most]).means);
  over.equivalent_load = mean_by_basic_life(loads);
  const bearing::motion::WindowStatistics pooled = system::pooled(means);
  over.least_film = std::min(pooled.inner.least_film, pooled.outer.least_film);
  const PlanetBearingRating::Lives lives = rating.of(pooled, over.equivalent_load, over.largest);
  over.static_load = lives.rating.static_load;
  over.static_safety = lives.rating.static_safety();
  over.life_hours = lives.hours;
  over.rated_hours = lives.rated_hours;
  return over;
}

void describe_bearing(Record& row, const BearingOverRevolution& bearing) {
  row.value("planet", dimension::ratio, "counted from 1", bearing.planet + 1.0);
  row.value("position_mm", dimension::length, "along the axis, from the middle of the face",
            bearing.position);
  row.value("load_min_N", dimension::force, "least over a revolution of the carrier", bearing.least);
  row.value("load_mean_N", dimension::force, "mean", bearing.mean);
  row.value("load_max_N", dimension::force, "largest", bearing.largest);
  row.value("tilt_max_mrad", dimension::small_angle, "largest tilt of the bore against the pin",
            bearing.largest_tilt);
  row.value("film_um", dimension::small_length, "least film of both races", bearing.least_film);
  row.value("equivalent_load_N", dimension::force, "P: mean of the power 10/3", bearing.equivalent_load);
  row.value("static_load_N", dimension::force, "P0: the largest load", bearing.static_load);
  row.value("S0", dimension::ratio, "basic static load rating over P0", bearing.static_safety);
  row.value("pressure_max_MPa", dimension::pressure, "largest over a revolution, after Hertz",
            bearing.largest_pressure);
  row.value("L10h_h", dimension::hours, "basic rating life under P", bearing.rated_hours.basic);
  for (const bearing::rating::RatedLife& life : bearing::rating::kRatedLives)
    if (life.hours != &bearing::rating::RatedHours::basic)
      row.value(life.name, dimension::hours, life.meaning, bearing.rated_hours.*life.hours);
  row.value("life_h", dimension::hours, "by Lundberg and Palmgren, of the loads of its rollers",
            bearing.life_hours);
}

void describe_carrier_bearing(Record& row, const CarrierBearingOverRevolution& bearing) {
  row.value("position_mm", dimension::length, "along the axis, from the middle of the face",
            bearing.position);
  row.value("load_min_N", dimension::force, "least radial load over a revolution", bearing.least);
  row.value("load_max_N", dimension::force, "largest", bearing.largest);
}

constexpr described::Dimension kLoadPerWidth{"force by width", "N/m", "N/mm", "", 1e3};

void describe_mesh(Record& row, const MeshOverRevolution& mesh) {
  row.value("planet", dimension::ratio, "counted from 1", mesh.planet + 1.0);
  row.value("with", "sun or ring", mesh.of_sun ? "sun" : "ring");
  row.value("force_mean_N", dimension::force, "normal force of the driving flanks, mean over a revolution",
            mesh.mean);
  row.value("force_max_N", dimension::force, "largest", mesh.largest);
  row.value("back_force_max_N", dimension::force, "largest normal force of the back flanks",
            mesh.largest_back);
  row.value("K_Hbeta", dimension::ratio, "face load factor: largest load per width over its mean",
            mesh.face_load);
  row.array("face_load_N_per_mm", kLoadPerWidth, "load per width over the face where it is largest",
            {"slice"}, mesh.by_width)
      .detail = true;
}

}  // namespace

double CarrierRevolution::largest_share() const {
  return load.maxCoeff() / expected_load;
}

double CarrierRevolution::face_load(bool of_sun) const {
  double largest = 0.0;
  for (const MeshOverRevolution& mesh : meshes)
    if (mesh.of_sun == of_sun) largest = std::max(largest, mesh.face_load);
  return largest;
}

double CarrierRevolution::back_flank_load() const {
  return std::ranges::max_element(meshes, {}, &MeshOverRevolution::largest_back)->largest_back;
}

const BearingOverRevolution& CarrierRevolution::worst(double bearing::rating::RatedHours::*hours) const {
  return *std::ranges::min_element(bearings, {},
                                   [&](const BearingOverRevolution& one) { return one.rated_hours.*hours; });
}

const BearingOverRevolution& CarrierRevolution::most_loaded(double BearingOverRevolution::*loads) const {
  return *std::ranges::max_element(bearings, {}, loads);
}

void describe(Record& record, const CarrierRevolution& revolution) {
  record.value("expected_load_N", dimension::force, "of one planet bearing: the torque shared evenly",
               revolution.expected_load);
  record.value("largest_load_share", dimension::ratio, "largest load of one bearing over the expected one",
               revolution.largest_share());
  record.value("shortest_L10h_h", dimension::hours, "basic rating life of the worst bearing",
               revolution.worst().rated_hours.basic);
  record.value("K_gamma", dimension::ratio, "mesh load factor: largest mesh force of a planet over the mean",
               revolution.mesh_load_factor);
  record.value("K_Hbeta_sun", dimension::ratio, "face load factor: largest load per width over its mean",
               revolution.face_load(true));
  record.value("K_Hbeta_ring", dimension::ratio, "the same of the ring meshes", revolution.face_load(false));
  record.value("back_flank_load_N", dimension::force,
               "largest normal force of back flanks; 0: driving flanks alone carry",
               revolution.back_flank_load());
  record.value("carrier_shift_um", dimension::small_length, "largest, radial, at the middle of the face",
               revolution.carrier_shift);
  record.value("carrier_tilt_mrad", dimension::small_angle, "largest", revolution.carrier_tilt);
  record.table("bearings", "planet_bearing", "planet bearings", revolution.bearings, describe_bearing);
  record.table("carrier_bearings", "carrier_bearing", "bearings of the carrier", revolution.carrier_bearings,
               describe_carrier_bearing);
  record.table("meshes", "mesh", "meshes of the planets", revolution.meshes, describe_mesh);
  record
      .array("face_position_mm", dimension::length, "middles of slices, from the middle of the face",
             {"slice"}, revolution.height)
      .detail = true;
  record.array("carrier_angle_deg", dimension::angle, "of the carrier; the first planet is upward at 90 deg",
               {"carrier_angle"}, revolution.angle);
  record.array("bearing_loads_N", dimension::force, "radial load of each planet bearing",
               {"carrier_angle", "planet_bearing"}, revolution.load);
}

void require_sound(const spatial::CarrierMounting& mounting) {
  const std::size_t bearings = mounting.positions.size();
  if (bearings < 2) require_length(mounting.positions, 2, "bearing_positions", false);
  require_length(mounting.radial_stiffness, bearings, "bearing_stiffness", false);
  require_length(mounting.clearances, bearings, "bearing_clearance", true);
  require_housing(mounting);
  require_length(mounting.rotor_force, 3, "rotor_force", true);
  require_length(mounting.rotor_moment, 2, "rotor_moment", true);
}

namespace {

// Two bearings on a pin that both walls hold bend it alike: that is in their stiffness.
bool pin_links_rows(const PlanetaryDrivetrain& drivetrain) {
  return drivetrain.seats.tilt == TiltState::computed &&
         (drivetrain.seats.ends != bearing::PinEnds::both || drivetrain.bearings_per_planet > 2);
}

// A pin links the rows on it: rows in the middle of one that both walls hold deflect further, and carry
// less. Its compliance is that of the beam, in proportion so that its mean over the rows is that of
// support.stiffness, which the springs of the rows contain.
void put_pins(const PlanetaryDrivetrain& drivetrain, spatial::SpatialSet& set) {
  const bearing::PinBeam beam = planet_pin(drivetrain);
  std::vector<double> positions;
  double rows = 0.0;  // [N/m]  with their pin
  for (const spatial::PlanetBearing& row : set.planet_bearings) {
    positions.push_back(row.position);
    rows += row.radial_stiffness;
  }
  const double pin = drivetrain.bearings_per_planet * drivetrain.dynamics.support.stiffness;  // [N/m]
  std::ostringstream less;
  less << "less than that of its pin, " << pin
       << " N/m by support.stiffness, where bearing.tilt_state is computed";
  mechanics::require(rows < pin, "gearset.dynamics.planet.bearing_stiffness [N/m]", rows, less.str());
  const auto count = static_cast<Index>(positions.size());
  const Eigen::MatrixXd compliance = bearing::pin_compliance(beam, positions).topLeftCorner(count, count);
  set.pin_compliance = compliance / (compliance.mean() * pin);
  for (spatial::PlanetBearing& row : set.planet_bearings) row.radial_stiffness *= pin / (pin - rows);
}

}  // namespace

spatial::SpatialSet spatial_set(const PlanetaryDrivetrain& drivetrain, const SetParameters& bodies,
                                double base_helix_angle) {
  const spatial::CarrierMounting& mounting = *drivetrain.carrier_mounting;
  require_sound(mounting);
  const double width = drivetrain.set.face_width;
  spatial::SpatialSet set{.angles = gearset::angles_of_planets(drivetrain.set),
                          .centre_distance = bodies.carrier.radius,
                          .face_width = width,
                          .planet_base_radius = bodies.planet.radius,
                          .sun = mesh_of(bodies.sun_mesh, base_helix_angle, width),
                          .ring = mesh_of(bodies.ring_mesh, base_helix_angle, width),
                          .planet_bearings = {},
                          // Axial forces of both meshes cancel on a planet: washers hold what is left, which
                          // no load depends on. In small vibration they have play: moving_set().
                          .planet_axial_stiffness = bodies.planet.bearing_stiffness,
                          .carrier_bearings = carrier_bearings(mounting),
                          .housing_stiffness = spatial::matrix_of_rows(mounting.housing),
                          .sun_axial_stiffness = bodies.planet.bearing_stiffness,
                          .sun_radial_stiffness = bodies.sun.support.stiffness,
                          .sun_tilt_stiffness = mounting.sun_tilt_stiffness,
                          .planet_mass = bodies.planet.mass,
                          .sun_mass = bodies.sun.mass,
                          .carrier_mass = bodies.carrier.mass,
                          .carrier_centre = mounting.centre_of_mass,
                          .pin_errors = bodies.pin_error};
  const double part = 1.0 / kRowParts, length = drivetrain.bearing.rollers().length;
  for (const double position : axial_positions(drivetrain))
    for (int i = 0; i < kRowParts; ++i)
      set.planet_bearings.push_back(
          {.position = position + ((i + 0.5) * part - 0.5) * length,
           .radial_stiffness = part * bodies.planet.bearing_stiffness / drivetrain.bearings_per_planet});
  if (pin_links_rows(drivetrain)) put_pins(drivetrain, set);
  return set;
}

spatial::MovingSet moving_set(const PlanetaryDrivetrain& drivetrain, const SetParameters& bodies,
                              double base_helix_angle) {
  const double width = drivetrain.set.face_width;
  const auto disc = [&](double mass, double inertia, double radius) {
    const double polar = inertia * radius * radius;
    return spatial::RoundBody{mass, polar, 0.5 * polar + mass * width * width / 12.0, 0.0};
  };
  const auto central = [&](const gearset::dynamics::CentralMember& member) {
    return disc(member.mass, member.inertia, member.radius);
  };
  const auto turning = [](const gearset::dynamics::CentralMember& member) {
    return spatial::BodySupport{.torsion = member.support.torsional_stiffness * member.radius * member.radius,
                                .held_in_rotation = member.support.held_in_rotation};
  };
  spatial::MovingSet moving{.set = spatial_set(drivetrain, bodies, base_helix_angle),
                            .carrier = central(bodies.carrier),
                            .sun = central(bodies.sun),
                            .planet = disc(bodies.planet.mass, bodies.planet.inertia, bodies.planet.radius),
                            .ring = central(bodies.ring),
                            .carrier_support = turning(bodies.carrier),
                            .sun_support = turning(bodies.sun),
                            .ring_support = turning(bodies.ring)};
  moving.carrier.centre = drivetrain.carrier_mounting->centre_of_mass;
  moving.set.planet_axial_stiffness = drivetrain.carrier_mounting->planet_axial_stiffness;
  moving.set.sun_axial_stiffness = drivetrain.carrier_mounting->sun_axial_stiffness;
  const double stiffness = bodies.ring.support.stiffness;
  moving.ring_support.radial = moving.ring_support.axial = stiffness;
  moving.ring_support.tilt = 0.5 * stiffness * bodies.ring.radius * bodies.ring.radius;
  return moving;
}

CarrierRevolution carrier_revolution(const PlanetaryDrivetrain& drivetrain,
                                     const DrivetrainGeometry& geometry, const RevolutionOptions& options) {
  const SetParameters bodies = drivetrain.gear_set();
  const auto operation = gearset::dynamics::operation_of(drivetrain.set, drivetrain.drive);
  const spatial::SpatialSet set = spatial_set(drivetrain, bodies, geometry.gears.base_helix_angle);
  const spatial::SpatialLoad load =
      spatial_load(operation, bodies.frame.centrifugal, *drivetrain.carrier_mounting);
  const Angles angles = angles_of(set, !gearset::is_unequally_spaced(drivetrain.set), options);
  const Revolution turned(set, load, angles, options);
  const Index rows = turned.rows();
  CarrierRevolution revolution = turned.result();
  revolution.expected_load =
      std::abs(load.torque) / (static_cast<double>(turned.planets() * rows) * set.centre_distance);
  revolution.angle.resize(angles.all);
  for (Index i = 0; i < angles.all; ++i) revolution.angle[i] = angles.at(i);
  revolution.load.resize(angles.all, turned.planets() * rows);
  PlanetaryDrivetrain tilted = drivetrain;  // by this equilibrium, for any setting of the planets' tilt
  tilted.seats = {};
  tilted.misalignment = {};
  const BearingDuty even = bearing_duty(tilted, geometry);
  const PlanetBearingRating rating(tilted, geometry, even);
  BearingsAtRest at_rest(tilted, geometry);
  const PlanetaryDrivetrain cut = is_rated_on_laminae(tilted) ? cut_for_rating(tilted) : tilted;
  const PlanetBearingRating cut_rating(cut, geometry, even);
  BearingsAtRest cut_at_rest(cut, geometry);
  const History& history = turned.history();
  for (std::size_t b = 0; b < history.load.size(); ++b) {
    const std::size_t planet = b / static_cast<std::size_t>(rows);
    const Index row = static_cast<Index>(b) % rows;
    const std::vector<BearingDuty> duties = duties_of(even, history.load[b], history.tilt[planet]);
    std::vector<double> loads, same_loads;
    BearingOverRevolution over = over_revolution(rating, at_rest, duties, options.life_step, loads);
    if (is_rated_on_laminae(tilted)) {
      const BearingOverRevolution rated =
          over_revolution(cut_rating, cut_at_rest, duties, options.life_step, same_loads);
      over.rated_hours = rated.rated_hours;
      over.largest_pressure = rated.largest_pressure;
    }
    over.position = row_position(set, row);
    const auto first = static_cast<Index>(planet), last = angles.step > 0 ? turned.planets() : first + 1;
    for (Index p = first; p < last; ++p) {
      over.planet = static_cast<int>(p);
      revolution.bearings.push_back(over);
      for (Index i = 0; i < angles.all; ++i)
        revolution.load(i, p * rows + row) =
            loads[static_cast<std::size_t>((i + p * angles.step) % angles.all)];
    }
  }
  std::ranges::stable_sort(revolution.bearings, {}, &BearingOverRevolution::planet);
  return revolution;
}

}  // namespace orbearing::analysis
