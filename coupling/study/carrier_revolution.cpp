#include "coupling/study/carrier_revolution.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "bearing/life/basic_life.hpp"
#include "coupling/study/tilting_planet.hpp"
#include "gearset/planet_angles.hpp"
#include "mechanics/record.hpp"

namespace orbearing::study {

namespace {

using described::Record;
namespace dimension = described::dimension;
namespace spatial = gearset::spatial;
constexpr auto kRoller = bearing::rating::RollingElement::roller;

void require_length(const std::vector<double>& list, std::size_t length, const std::string& name,
                    bool may_lack) {
  if (list.size() == length || (may_lack && list.empty())) return;
  throw std::invalid_argument("gearset.carrier." + name + ": found " + std::to_string(list.size()) +
                              " values; required: " + (may_lack ? "none or " : "") + std::to_string(length));
}

void require_lists(const spatial::CarrierMounting& mounting) {
  const std::size_t bearings = mounting.positions.size();
  if (bearings < 2)
    throw std::invalid_argument("gearset.carrier.bearing_positions: found " + std::to_string(bearings) +
                                " values; required: at least two bearings, which hold the carrier against "
                                "tilting");
  require_length(mounting.radial_stiffness, bearings, "bearing_stiffness", false);
  require_length(mounting.clearances, bearings, "bearing_clearance", true);
  require_length(mounting.rotor_force, 3, "rotor_force", true);
  require_length(mounting.rotor_moment, 2, "rotor_moment", true);
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
          .base_helix = base_helix_angle};
}

BearingOverRevolution over_revolution(const Eigen::ArrayXd& load, int planet, double position,
                                      double capacity, double speed) {
  BearingOverRevolution over{.planet = planet,
                             .position = position,
                             .least = load.minCoeff(),
                             .mean = load.mean(),
                             .largest = load.maxCoeff()};
  const double exponent = bearing::rating::life_exponent(kRoller);
  over.equivalent_load = std::pow(load.pow(exponent).mean(), 1.0 / exponent);
  const double life = bearing::rating::basic_rating_life(kRoller, capacity, over.equivalent_load);
  over.basic_life_hours = bearing::hours(life, speed);
  return over;
}

// A row of rollers holds its planet against tilting: springs along the rollers take the place of one.
constexpr int kRowParts = 5;

double row_load(const spatial::SpatialBalance& at, int row, int planet) {
  const auto sum = [&](const Eigen::MatrixXd& parts) {
    return parts.col(planet).segment(row * kRowParts, kRowParts).sum();
  };
  return std::hypot(sum(at.bearing_radial), sum(at.bearing_tangential));
}

double row_position(const spatial::SpatialSet& set, int row) {
  return set.planet_bearings[static_cast<std::size_t>(row * kRowParts + kRowParts / 2)].position;
}

// What one angle adds to the largest of all.
void widen(const spatial::SpatialBalance& at, CarrierRevolution& revolution) {
  const auto to = [](double& largest, double value) { largest = std::max(largest, value); };
  to(revolution.mesh_load_factor, at.sun_mesh.maxCoeff() / at.sun_mesh.mean());
  to(revolution.mesh_load_factor, at.ring_mesh.maxCoeff() / at.ring_mesh.mean());
  to(revolution.sun_face_load, at.sun_face_load.maxCoeff());
  to(revolution.ring_face_load, at.ring_face_load.maxCoeff());
  to(revolution.carrier_shift, at.carrier_shift.head<2>().norm());
  to(revolution.carrier_tilt, at.carrier_tilt.head<2>().norm());
}

void describe_bearing(Record& row, const BearingOverRevolution& bearing) {
  row.value("planet", dimension::ratio, "counted from 1", bearing.planet + 1.0);
  row.value("position_mm", dimension::length, "along the axis, from the middle of the face",
            bearing.position);
  row.value("load_min_N", dimension::force, "least over a revolution of the carrier", bearing.least);
  row.value("load_mean_N", dimension::force, "mean", bearing.mean);
  row.value("load_max_N", dimension::force, "largest", bearing.largest);
  row.value("equivalent_load_N", dimension::force, "P: mean of the power 10/3", bearing.equivalent_load);
  row.value("L10h_h", dimension::hours, "basic rating life under P", bearing.basic_life_hours);
}

void describe_carrier_bearing(Record& row, const CarrierBearingOverRevolution& bearing) {
  row.value("position_mm", dimension::length, "along the axis, from the middle of the face",
            bearing.position);
  row.value("load_min_N", dimension::force, "least radial load over a revolution", bearing.least);
  row.value("load_max_N", dimension::force, "largest", bearing.largest);
}

}  // namespace

double CarrierRevolution::largest_share() const {
  return load.maxCoeff() / expected_load;
}

const BearingOverRevolution& CarrierRevolution::worst() const {
  return *std::ranges::min_element(bearings, {}, &BearingOverRevolution::basic_life_hours);
}

void describe(Record& record, const CarrierRevolution& revolution) {
  record.value("expected_load_N", dimension::force, "of one planet bearing: the torque shared evenly",
               revolution.expected_load);
  record.value("largest_load_share", dimension::ratio, "largest load of one bearing over the expected one",
               revolution.largest_share());
  record.value("shortest_L10h_h", dimension::hours, "basic rating life of the worst bearing",
               revolution.worst().basic_life_hours);
  record.value("K_gamma", dimension::ratio, "mesh load factor: largest mesh force of a planet over the mean",
               revolution.mesh_load_factor);
  record.value("K_Hbeta_sun", dimension::ratio, "face load factor: largest load per width over its mean",
               revolution.sun_face_load);
  record.value("K_Hbeta_ring", dimension::ratio, "the same of the ring meshes", revolution.ring_face_load);
  record.value("carrier_shift_um", dimension::small_length, "largest, radial, at the middle of the face",
               revolution.carrier_shift);
  record.value("carrier_tilt_mrad", dimension::small_angle, "largest", revolution.carrier_tilt);
  record.table("bearings", "bearing", "planet bearings", revolution.bearings, describe_bearing);
  record.table("carrier_bearings", "carrier_bearing", "bearings of the carrier", revolution.carrier_bearings,
               describe_carrier_bearing);
  record.array("carrier_angle_deg", dimension::angle, "of the carrier; the first planet is upward at 90 deg",
               {"angle"}, revolution.angle);
  record.array("bearing_loads_N", dimension::force, "radial load of each planet bearing",
               {"angle", "bearing"}, revolution.load.transpose().eval());
}

spatial::SpatialSet spatial_set(const PlanetaryDrivetrain& drivetrain,
                                const gearset::dynamics::SetModel& model, double base_helix_angle,
                                const spatial::CarrierMounting& mounting) {
  require_lists(mounting);
  const gearset::dynamics::SetParameters& from = model.parameters;
  const double width = drivetrain.set.face_width;
  spatial::SpatialSet set{.angles = gearset::angles_of_planets(drivetrain.set),
                          .centre_distance = from.carrier.radius,
                          .face_width = width,
                          .planet_base_radius = from.planet.radius,
                          .sun = mesh_of(from.sun_mesh, base_helix_angle, width),
                          .ring = mesh_of(from.ring_mesh, base_helix_angle, width),
                          .planet_bearings = {},
                          // Axial forces of both meshes cancel on a planet: washers hold what is left.
                          .planet_axial_stiffness = from.planet.bearing_stiffness,
                          .carrier_bearings = carrier_bearings(mounting),
                          .sun_axial_stiffness = from.planet.bearing_stiffness,
                          .sun_radial_stiffness = from.sun.support.stiffness,
                          .planet_mass = from.planet.mass,
                          .sun_mass = from.sun.mass,
                          .carrier_mass = from.carrier.mass,
                          .carrier_centre = mounting.centre_of_mass,
                          .pin_errors = from.pin_error};
  const double part = 1.0 / kRowParts, length = drivetrain.bearing.rollers().length;
  for (const double position : axial_positions(drivetrain))
    for (int i = 0; i < kRowParts; ++i)
      set.planet_bearings.push_back(
          {.position = position + ((i + 0.5) * part - 0.5) * length,
           .radial_stiffness = part * from.planet.bearing_stiffness / drivetrain.bearings_per_planet});
  return set;
}

spatial::SpatialLoad spatial_load(const gearset::dynamics::SetModel& model,
                                  const spatial::CarrierMounting& mounting) {
  spatial::SpatialLoad load{
      .torque = model.operation.torques.carrier,
      .speed = model.parameters.frame.centrifugal ? model.operation.speeds.carrier : 0.0,
      .gravity = mounting.gravity,
      .axis_tilt = mounting.axis_tilt};
  if (!mounting.rotor_force.empty())
    load.rotor.force = Eigen::Map<const Eigen::Vector3d>(mounting.rotor_force.data());
  if (!mounting.rotor_moment.empty())
    load.rotor.moment.head<2>() = Eigen::Map<const Eigen::Vector2d>(mounting.rotor_moment.data());
  return load;
}

CarrierRevolution carrier_revolution(const spatial::SpatialSet& set, const spatial::SpatialLoad& load,
                                     double dynamic_capacity, double speed,
                                     const RevolutionOptions& options) {
  const auto planets = static_cast<int>(set.angles.size()),
             rows = static_cast<int>(set.planet_bearings.size()) / kRowParts;
  CarrierRevolution revolution;
  revolution.expected_load = std::abs(load.torque) / (planets * rows * set.centre_distance);
  revolution.angle =
      Eigen::ArrayXd::LinSpaced(options.angles + 1, 0.0, 2.0 * std::numbers::pi).head(options.angles);
  revolution.load.resize(options.angles, planets * rows);
  Eigen::ArrayXXd of_carrier(options.angles, static_cast<Eigen::Index>(set.carrier_bearings.size()));
  spatial::SpatialBalance at;
  for (int i = 0; i < options.angles; ++i) {
    at = spatial::balance(set, load, revolution.angle[i], options.slices, at.position);
    for (int b = 0; b < planets * rows; ++b) revolution.load(i, b) = row_load(at, b % rows, b / rows);
    of_carrier.row(i) = at.carrier_bearing.transpose();
    widen(at, revolution);
  }
  for (int b = 0; b < planets * rows; ++b)
    revolution.bearings.push_back(over_revolution(revolution.load.col(b), b / rows,
                                                  row_position(set, b % rows), dynamic_capacity, speed));
  for (Eigen::Index i = 0; i < of_carrier.cols(); ++i)
    revolution.carrier_bearings.push_back({set.carrier_bearings[static_cast<std::size_t>(i)].position,
                                           of_carrier.col(i).minCoeff(), of_carrier.col(i).maxCoeff()});
  return revolution;
}

}  // namespace orbearing::study
