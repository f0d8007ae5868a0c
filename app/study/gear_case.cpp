#include "app/study/gear_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "app/case/bearing_type.hpp"
#include "app/case/check_table.hpp"
#include "app/case/described_case.hpp"
#include "app/case/set_case.hpp"
#include "app/errors.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/study/mesh_study.hpp"
#include "coupling/study/planet_stiffness.hpp"
#include "gearset/mesh/loaded/tooth_pairs.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::app {

namespace {

const std::string kBlock = "gearset.dynamics.";

study::GearDynamicsChoice gears_of(const ResolvedCase& in) {
  auto choice = from_case<study::GearDynamicsChoice>(in);
  if (!in.shape().teeth) return choice;
  choice.bodies = {.sun_bore = in.number("gearset.sun_bore_ratio"),
                   .ring_outside = in.number("gearset.ring_outside_ratio")};
  choice.run_up = {.from = in.number(kBlock + "run_up.from"),
                   .duration = in.quantity(kBlock + "run_up.duration")};
  choice.frame = {.coriolis = in.flag("inertia.coriolis"),
                  .centrifugal = in.flag("inertia.carrier_centrifugal"),
                  .euler = in.flag("inertia.euler")};
  return choice;
}

// Loads come from teeth, so a set without them only swings.
gearset::dynamics::SetModel lumped_model(const ResolvedCase& in, double carrier_speed) {
  gearset::dynamics::Operation operation;
  operation.speeds.carrier = carrier_speed;
  return set_model(
      study::lumped_set(
          gears_of(in), in.integer("gearset.planets"), in.quantity("gearset.pressure_angle"),
          in.has("gearset.planet_angles") ? in.list("gearset.planet_angles") : std::vector<double>{}),
      operation);
}

double planet_rings(const study::PlanetaryDrivetrain& drivetrain, const study::DrivetrainGeometry& geometry) {
  return drivetrain.bearings_per_planet * geometry.bearing.outer_ring_mass;
}

// Geometry of the drivetrain; without a bearing that of its gears alone.
study::DrivetrainGeometry geometry_of(const ResolvedCase& in, const study::PlanetaryDrivetrain& drivetrain) {
  if (in.shape().bearing) return study::derive(drivetrain);
  study::DrivetrainGeometry geometry;
  geometry.gears = gearset::working_geometry(drivetrain.set);
  return geometry;
}

gearset::dynamics::SetModel geometric_model(const ResolvedCase& in,
                                            const study::PlanetaryDrivetrain& drivetrain,
                                            const study::DrivetrainGeometry& geometry) {
  const study::GearDynamicsChoice choice = gears_of(in);
  double rings = 0.0, stiffness = 0.0;
  if (in.shape().bearing) {
    rings = planet_rings(drivetrain, geometry);
    if (!choice.bearing_stiffness) stiffness = study::planet_bearing_stiffness(drivetrain, geometry);
  }
  gearset::dynamics::Operation operation = study::set_operation(drivetrain, geometry.gears);
  operation.run_up = choice.run_up;
  gearset::dynamics::SetParameters set =
      study::geometric_set(choice, drivetrain.set, geometry.gears,
                           planetary_meshes_of(in, drivetrain, geometry.gears), rings, stiffness);
  linearise_meshes(set, operation);
  if (geometry.rim)
    set.planet.linked = {study::planet_stiffness(drivetrain, geometry, set.sun_mesh.stiffness.mean(),
                                                 set.ring_mesh.stiffness.mean())};
  return set_model(std::move(set), operation);
}

void require_one_set(const ResolvedCase& in) {
  if (in.model() != planetary_drivetrain)
    throw BadInput(in.origin("model") + ": model: found " + in.choice("model") +
                   "; required: planetary-drivetrain, whose gears have dynamics");
  if (in.shape().several)
    throw BadInput(in.file() +
                   ": sets: found several sets; required: one set, as gearset at the top of a case");
}

// The springs that replace the bearings are those of cylindrical rollers.
void require_known_springs(const ResolvedCase& in) {
  if (has_cylindrical_rollers(in)) return;
  throw BadInput(
      fmt::format("{}: bearing.type: found {}; required: cylindrical-roller, of which the stiffness under "
                  "moving gears is "
                  "computed; run, sweep and mesh take other types",
                  in.origin("bearing.type"), in.choice("bearing.type")));
}

Derived row(const std::string& path, double value, const char* unit, const char* meaning) {
  return {kBlock + path, value, unit, meaning};
}

}  // namespace

gearset::dynamics::SetModel gear_model_of(const ResolvedCase& resolved,
                                          const study::PlanetaryDrivetrain& drivetrain,
                                          const std::optional<study::DrivetrainGeometry>& known) {
  require_one_set(resolved);
  if (!resolved.shape().teeth) return lumped_model(resolved, 0.0);
  if (!known) require_known_springs(resolved);
  try {
    return geometric_model(resolved, drivetrain, known ? *known : geometry_of(resolved, drivetrain));
  } catch (const std::domain_error& error) {
    throw BadInput(resolved.file() + ": gearset: " + error.what());
  }
}

gearset::dynamics::SetModel gear_model_of(const ResolvedCase& resolved, double carrier_speed) {
  require_one_set(resolved);
  return resolved.shape().teeth ? gear_model_of(resolved, drivetrain_without_gear_set(resolved))
                                : lumped_model(resolved, carrier_speed);
}

gearset::dynamics::SetModel moving_gears_of(const ResolvedCase& resolved) {
  const gearset::dynamics::SetModel model = gear_model_of(resolved);
  return resolved.shape().teeth && !resolved.flag("gearset.mesh_variation")
             ? gearset::dynamics::averaged(model)
             : model;
}

study::GearRunOptions gear_run_options(const ResolvedCase& resolved) {
  study::GearRunOptions options;
  options.observed_periods = resolved.integer(kBlock + "observed_periods");
  options.most_windows =
      static_cast<int>(resolved.integer(kBlock + "settling_periods") / options.window_periods);
  options.series_periods = std::min(options.series_periods, options.observed_periods);
  return options;
}

namespace {

constexpr const char* kBearingStiffness = "planet.bearing_stiffness";

std::vector<Derived> rows_of_gears(const gearset::dynamics::SetModel& model) {
  const gearset::dynamics::SetParameters& set = model.parameters;
  std::vector<Derived> rows;
  const auto add_body = [&](const std::string& member, double mass, double inertia) {
    rows.push_back(row(member + ".mass", mass, "kg", "as used by the dynamics"));
    rows.push_back(row(member + ".equivalent_mass", inertia, "kg", "moment of inertia / radius^2"));
  };
  add_body("sun", set.sun.mass, set.sun.inertia);
  add_body("ring", set.ring.mass, set.ring.inertia);
  add_body("carrier", set.carrier.mass, set.carrier.inertia);
  add_body("planet", set.planet.mass, set.planet.inertia);
  rows.push_back(row(kBearingStiffness, set.planet.bearing_stiffness, "N/m",
                     "all bearings of a planet with their pins"));
  rows.push_back(row("mesh_stiffness.sun", set.sun_mesh.stiffness.mean(), "N/m", "mean over a mesh period"));
  rows.push_back(
      row("mesh_stiffness.ring", set.ring_mesh.stiffness.mean(), "N/m", "mean over a mesh period"));
  if (model.operation.mesh_frequency > 0.0)
    rows.push_back(row("mesh_frequency", model.operation.mesh_frequency, "Hz", "at input.speed"));
  return rows;
}

}  // namespace

// If the bearings have no stiffness, e.g. without contact, the other quantities are those with any other
// spring instead.
std::vector<Derived> gear_dynamics_quantities(const ResolvedCase& resolved) {
  const std::vector<Derived> rows =
      or_reason(kBlock + kBearingStiffness, [&] { return rows_of_gears(gear_model_of(resolved)); });
  if (!std::isnan(rows.front().value) || resolved.has(kBlock + kBearingStiffness)) return rows;
  std::vector<Derived> all = or_reason(kBlock + "mesh_stiffness", [&] {
    return rows_of_gears(gear_model_of(
        resolved.with({{"gearset.planet_rim", "rigid"}, {kBlock + kBearingStiffness, "1e9 N/m"}})));
  });
  std::erase_if(all, [&](const Derived& one) { return one.path == rows.front().path; });
  all.push_back(rows.front());
  return all;
}

std::vector<std::string> gear_dynamics_warnings(const ResolvedCase& resolved) {
  std::vector<std::string> texts = gear_warnings(resolved);
  for (std::string& text : planar_warnings(resolved)) texts.push_back(std::move(text));
  if (!resolved.shape().teeth) return texts;
  const gearset::PlanetaryMeshes meshes = planetary_meshes_of(resolved);
  gearset::Warnings warnings = gearset::foundation_warnings(meshes);
  const study::PlanetaryDrivetrain drivetrain = drivetrain_without_gear_set(resolved);
  if (drivetrain.set.flanks.contact == gearset::ToothContact::loaded) {
    const double force =
        gearset::mean_loads(drivetrain.set, gearset::working_geometry(drivetrain.set), drivetrain.drive)
            .normal_force;
    for (gearset::Warning& warning :
         gearset::edge_warnings(gearset::set_teeth(drivetrain.set, meshes), force))
      warnings.push_back(std::move(warning));
  }
  for (const gearset::Warning& warning : warnings)
    texts.push_back(location_in_case(resolved, warning.key) + ": " + warning.text);
  return texts;
}

namespace {

using described::each;
using described::Record;
using gearset::dynamics::Mode;
using gearset::dynamics::ModeKind;
using study::GearRunResult;
using study::PlanetStatistics;
using study::SignalStatistics;
namespace dimension = described::dimension;

struct NamedSignal {
  const char* key;   // of its table in JSON
  const char* name;  // of its series
  const described::Dimension& of;
  const char* meaning;
  SignalStatistics PlanetStatistics::*statistics;
  Eigen::ArrayXXd study::GearSeries::*series;
};

constexpr NamedSignal kMeshForces[] = {
    {"sun", "sun_mesh_force", dimension::force, "force of the sun mesh along the line of action",
     &PlanetStatistics::sun_mesh_force, &study::GearSeries::sun_mesh_force},
    {"ring", "ring_mesh_force", dimension::force, "force of the ring mesh along the line of action",
     &PlanetStatistics::ring_mesh_force, &study::GearSeries::ring_mesh_force}};
constexpr NamedSignal kBearingForces[] = {
    {"x", "bearing_force_x", dimension::force, "force of its bearings on the planet, outward",
     &PlanetStatistics::radial_force, &study::GearSeries::radial_force},
    {"y", "bearing_force_y", dimension::force,
     "force of its bearings on the planet, in the sense of carrier rotation",
     &PlanetStatistics::tangential_force, &study::GearSeries::tangential_force}};
constexpr NamedSignal kAccelerations[] = {
    {"x_of_planets", "planet_acceleration_x", dimension::acceleration,
     "acceleration of the planet in the carrier's frame, outward", &PlanetStatistics::radial_acceleration,
     &study::GearSeries::radial_acceleration},
    {"y_of_planets", "planet_acceleration_y", dimension::acceleration,
     "acceleration of the planet in the carrier's frame, in the sense of carrier rotation",
     &PlanetStatistics::tangential_acceleration, &study::GearSeries::tangential_acceleration}};

// A row for each planet, and the series of all.
template <class Signals>
void describe_signals(Record& record, const Signals& signals, const GearRunResult& result) {
  for (const NamedSignal& signal : signals) {
    record
        .table(signal.key, "planet", signal.meaning, result.planets,
               [&](Record& row, const PlanetStatistics& planet) {
                 const SignalStatistics& s = planet.*signal.statistics;
                 row.value("mean", signal.of, "mean", s.mean);
                 row.value("rms", signal.of, "root mean square", s.rms);
                 row.value("min", signal.of, "least value", s.least);
                 row.value("max", signal.of, "largest value", s.largest);
                 row.array("mesh_harmonics", signal.of, "amplitude at orders of the mesh frequency",
                           {"order"}, s.amplitudes)
                     .variable = "harmonics";
               })
        .variable = signal.name;
    record.series(signal.name, signal.of, signal.meaning, {"planet", "time"}, result.series.*signal.series);
  }
}

// rms over all planets, and the largest of all.
void describe_all_planets(Record& record, const char* name, const GearRunResult& result,
                          SignalStatistics PlanetStatistics::*signal) {
  double square = 0.0, largest = 0.0;
  for (const PlanetStatistics& planet : result.planets) {
    square += (planet.*signal).rms * (planet.*signal).rms / static_cast<double>(result.planets.size());
    largest = std::max(largest, (planet.*signal).maximum);
  }
  record.array(name, dimension::acceleration, "of all planets", {{"statistic", {"rms", "max"}}},
               std::array{std::sqrt(square), largest});
}

// rms over all planets, along any one direction of the housing.
double housing_acceleration(const GearRunResult& result) {
  double square = 0.0;
  for (const PlanetStatistics& planet : result.planets)
    square += planet.housing_acceleration * planet.housing_acceleration /
              static_cast<double>(result.planets.size());
  return std::sqrt(square);
}

void describe_accelerations(Record& record, const GearRunResult& result) {
  describe_all_planets(record, "x", result, &PlanetStatistics::radial_acceleration);
  describe_all_planets(record, "y", result, &PlanetStatistics::tangential_acceleration);
  for (const char* axis : {"x", "y"})
    record.entry(axis).variable = std::string("planet_acceleration_all_") + axis;
  record
      .value("housing_rms", dimension::acceleration, "along any direction fixed in the housing",
             housing_acceleration(result))
      .variable = "planet_acceleration_housing_rms";
  describe_signals(record, kAccelerations, result);
}

}  // namespace

const char* kind_name(ModeKind kind) {
  switch (kind) {
    case ModeKind::rotational:
      return "rotational";
    case ModeKind::translational:
      return "translational";
    case ModeKind::planet:
      break;
  }
  return "planet";
}

ModeShape shape_of(const Mode& mode) {
  constexpr double alike = 1e-6;  // relative
  const Eigen::VectorXd reach = mode.shapes.rowwise().norm();
  const auto most =
      std::ranges::find_if(reach, [&](double r) { return r >= (1.0 - alike) * reach.maxCoeff(); });
  const Eigen::Index largest = most - reach.begin();
  const Eigen::VectorXcd shape =
      mode.shapes * mode.shapes.row(largest).adjoint() / (reach[largest] * reach[largest]);
  const auto rows = [](const Eigen::VectorXd& values) -> Eigen::MatrixX3d {
    return values.reshaped<Eigen::RowMajor>(values.size() / 3, 3);
  };
  return {rows(shape.real()), rows(Eigen::VectorXd::Zero(shape.size()) - shape.imag())};
}

void describe(Record& record, const ModeStudy& study) {
  record.table("modes", "mode", "natural modes", study.modes, [&](Record& row, const Mode& mode) {
    row.value("frequency_Hz", dimension::cycles, "natural frequency", mode.frequency);
    row.value("kind", "rotational, translational or planet", kind_name(mode.kind));
    row.value("multiplicity", "modes of this frequency and kind", mode.multiplicity);
    row.value("growth_per_s", dimension::growth, "rate at which the motion grows", mode.growth);
    row.value("over_planet_frequency", dimension::ratio, "over that of a planet on its bearing alone",
              mode.frequency / study.planet_frequency);
    const ModeShape shape = shape_of(mode);
    const std::vector<described::Along> along{"member", "direction"};
    row.array("shape", dimension::ratio,
              "x, y and rotation times radius of sun, ring, carrier and planets over the largest; of planets "
              "outward and tangential",
              along, shape.position)
        .detail = true;
    // Without rotation all members move in phase: the second shape would be zero.
    if (shape.quarter.cwiseAbs().maxCoeff() > 0.0)
      row.array("shape_quarter", dimension::ratio, "the same a quarter of a period later", along,
                shape.quarter)
          .detail = true;
  });
}

ModeStudy mode_study(const gearset::dynamics::SetModel& model, bool at_speed) {
  const auto& planet = model.parameters.planet;
  return {at_speed ? modes_at_speed(model) : modes_at_rest(model),
          std::sqrt(planet.bearing_stiffness / planet.mass) / constants::two_pi};
}

void describe_campbell(Record& record, const gearset::dynamics::SetModel& model, double nominal_speed) {
  constexpr int steps = 20;
  constexpr int harmonics = 4;
  std::vector<double> factors, speeds;
  std::vector<std::array<double, harmonics>> mesh;
  for (int i = 0; i <= steps; ++i) {
    factors.push_back(static_cast<double>(i) / steps);
    speeds.push_back(factors.back() * nominal_speed);
    for (int order = 1; order <= harmonics; ++order) {
      if (order == 1) mesh.emplace_back();
      mesh.back()[static_cast<std::size_t>(order - 1)] =
          order * factors.back() * model.operation.mesh_frequency;
    }
  }
  record.array("speed_rpm", dimension::angular_speed, "from rest to the nominal speed", {"speed"}, speeds);
  record.array("frequencies_Hz", dimension::cycles, "natural, ascending", {"speed", "frequency"},
               campbell_frequencies(model, factors).transpose().eval());
  record.array("mesh_harmonics_Hz", dimension::cycles, "orders 1 to 4 of the mesh frequency",
               {"speed", "order"}, mesh);
}

void describe_gear_run(Record& record, const GearRunResult& result) {
  record.value("mesh_frequency_Hz", dimension::cycles, "teeth that come into contact per time",
               result.mesh_frequency);
  record.value("steady", "whether the motion repeats", result.steady);
  const auto add = [&](const char* name, const char* meaning, const auto& fill) {
    record.child(name, meaning, result, fill).variable = "";
  };
  add("planet_acceleration_m_per_s2", "of the planets", describe_accelerations);
  add("mesh_force_N", "of the teeth",
      [](Record& forces, const GearRunResult& of) { describe_signals(forces, kMeshForces, of); });
  add("bearing_force_N", "on the planets",
      [](Record& forces, const GearRunResult& of) { describe_signals(forces, kBearingForces, of); });
  add("load_sharing", "tangential bearing force over the mean of all planets",
      [](Record& shares, const GearRunResult& of) {
        shares
            .array("mean", dimension::ratio, "over time", {"planet"},
                   each(of.planets, &PlanetStatistics::load_share))
            .variable = "load_share";
        shares
            .array("largest", dimension::ratio, "at an instant", {"planet"},
                   each(of.planets, &PlanetStatistics::most_load_share))
            .variable = "largest_load_share";
      });
  record
      .value("separated_fraction", dimension::ratio, "fraction of time with separated teeth",
             result.separated)
      .former = "share_of_time_with_parted_teeth";
  record.child("run", "of the integration", result, [](Record& run, const GearRunResult& of) {
    run.value("windows", "until steady", of.windows);
    run.value("simulated_s", dimension::time, "", of.report.reached);
    run.value("steps", "", of.report.steps);
    run.value("rhs_calls", "", of.report.rhs_calls);
  });
  std::vector<double> orders(result.planets.front().sun_mesh_force.amplitudes.size());
  std::iota(orders.begin(), orders.end(), 1.0);
  record.series("order", dimension::ratio, "order of the mesh frequency", {"order"}, orders);
  record.series("time", dimension::time, "since the start of the run", {"time"}, result.series.time);
}

}  // namespace orbearing::app
