#include "app/study/gear_case.hpp"

#include "app/case/described_case.hpp"
#include "app/case/set_case.hpp"
#include "app/errors.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/study/mesh_study.hpp"
#include "coupling/study/bearing_tangent.hpp"
#include "coupling/study/planet_stiffness.hpp"
#include "gearset/mesh/loaded/tooth_pairs.hpp"

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

gearset::dynamics::SetModel geometric_model(const ResolvedCase& in,
                                            const study::PlanetaryDrivetrain& drivetrain) {
  const study::GearDynamicsChoice choice = gears_of(in);
  double rings = 0.0, stiffness = 0.0;
  study::DrivetrainGeometry geometry;
  if (in.shape().bearing) {
    geometry = study::derive(drivetrain);
    rings = planet_rings(drivetrain, geometry);
    if (!choice.bearing_stiffness) stiffness = study::planet_bearing_stiffness(drivetrain, geometry);
  } else {
    geometry.gears = gearset::working_geometry(drivetrain.set);
  }
  gearset::dynamics::Operation operation = gearset::dynamics::operation_of(drivetrain.set, drivetrain.drive);
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

Derived row(const std::string& path, double value, const char* unit, const char* meaning) {
  return {kBlock + path, value, unit, meaning};
}

}  // namespace

gearset::dynamics::SetModel gear_model_of(const ResolvedCase& resolved,
                                          const study::PlanetaryDrivetrain& drivetrain) {
  require_one_set(resolved);
  if (!resolved.shape().teeth) return lumped_model(resolved, 0.0);
  try {
    return geometric_model(resolved, drivetrain);
  } catch (const std::domain_error& error) {
    throw BadInput(resolved.file() + ": gearset: " + error.what());
  }
}

gearset::dynamics::SetModel gear_model_at(const ResolvedCase& resolved, double carrier_speed) {
  require_one_set(resolved);
  return resolved.shape().teeth ? gear_model_of(resolved, drivetrain_without_gear_set(resolved))
                                : lumped_model(resolved, carrier_speed);
}

gearset::dynamics::SetModel gear_model_of(const ResolvedCase& resolved) {
  return gear_model_at(resolved, 0.0);
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

std::vector<Derived> gear_dynamics_quantities(const ResolvedCase& resolved) {
  const gearset::dynamics::SetModel model = gear_model_of(resolved);
  const gearset::dynamics::SetParameters& set = model.parameters;
  std::vector<Derived> rows;
  const auto add_body = [&](const std::string& member, double mass, double inertia) {
    rows.push_back(row(member + ".mass", mass, "kg", "as the dynamics have it"));
    rows.push_back(row(member + ".equivalent_mass", inertia, "kg", "moment of inertia / radius^2"));
  };
  add_body("sun", set.sun.mass, set.sun.inertia);
  add_body("ring", set.ring.mass, set.ring.inertia);
  add_body("carrier", set.carrier.mass, set.carrier.inertia);
  add_body("planet", set.planet.mass, set.planet.inertia);
  rows.push_back(row("planet.bearing_stiffness", set.planet.bearing_stiffness, "N/m",
                     "all bearings of a planet with their pins"));
  rows.push_back(row("mesh_stiffness.sun", set.sun_mesh.stiffness.mean(), "N/m", "mean over a mesh period"));
  rows.push_back(
      row("mesh_stiffness.ring", set.ring_mesh.stiffness.mean(), "N/m", "mean over a mesh period"));
  if (model.operation.mesh_frequency > 0.0)
    rows.push_back(row("mesh_frequency", model.operation.mesh_frequency, "Hz", "at input.speed"));
  return rows;
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

}  // namespace orbearing::app
