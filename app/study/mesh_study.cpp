#include "app/study/mesh_study.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <utility>

#include "app/case/machine_of.hpp"
#include "app/case/set_case.hpp"
#include "app/errors.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/units.hpp"
#include "coupling/analysis/pair_meshes.hpp"
#include "gearset/checks.hpp"
#include "gearset/mesh/loaded/tooth_pairs.hpp"

namespace orbearing::app {

namespace {

void add_texts(const gearset::Warnings& warnings, std::vector<std::string>& texts) {
  for (const gearset::Warning& warning : warnings) texts.push_back(warning.key + ": " + warning.text);
}

mechanics::Material elasticity_of(const ResolvedCase& in) {
  return {.youngs_modulus = in.quantity("material.youngs_modulus"),
          .poisson_ratio = in.number("material.poisson_ratio")};
}

std::optional<double> held_race_of(const study::PlanetaryDrivetrain& drivetrain) {
  if (drivetrain.rim == study::PlanetRim::rigid) return std::nullopt;
  return bearing::geometry_of(drivetrain.bearing).outer_radius;
}

// All that meshes follow from: the set and its material as the case states them, and what others give.
using MeshKey = std::pair<std::vector<std::string>, std::vector<double>>;

MeshKey mesh_key(const ResolvedCase& in, const study::PlanetaryDrivetrain& drivetrain,
                 const gearset::MeshMotion& motion, const std::optional<double>& held_race) {
  MeshKey key;
  for (const Input& input : in.inputs()) {
    const bool gears = input.path.starts_with("gearset.") && !input.path.starts_with("gearset.dynamics.");
    if (!in.has(input.path) || !(gears || input.path.starts_with("material."))) continue;
    const FieldValue& value = in.value(input.path);
    key.first.push_back(input.path);
    if (!is_numeric(*input.field)) key.first.push_back(value.given);
    key.second.push_back(value.number);
    key.second.insert(key.second.end(), value.list.begin(), value.list.end());
  }
  key.second.insert(key.second.end(), {drivetrain.set.planet_bore, motion.sun_drives ? 1.0 : 0.0,
                                       motion.sun_anticlockwise ? 1.0 : 0.0, held_race.value_or(-1.0)});
  return key;
}

// Points of a sweep and variants of a case mostly have the same teeth, which take longer than a bearing at
// rest.
class KnownMeshes {
 public:
  using Meshes = std::shared_ptr<const gearset::PlanetaryMeshes>;

  template <class Build>
  Meshes find_or(MeshKey key, const Build& build) {
    if (Meshes found = find(key)) return found;
    Meshes built = std::make_shared<const gearset::PlanetaryMeshes>(build());
    const std::scoped_lock lock(one_at_a_time_);
    if (known_.size() >= most) known_.clear();
    return known_.emplace(std::move(key), std::move(built)).first->second;
  }

 private:
  static constexpr std::size_t most = 64;

  Meshes find(const MeshKey& key) {
    const std::scoped_lock lock(one_at_a_time_);
    const auto found = known_.find(key);
    return found == known_.end() ? nullptr : found->second;
  }

  std::map<MeshKey, Meshes> known_;
  std::mutex one_at_a_time_;
};

}  // namespace

gearset::PlanetaryMeshes planetary_meshes_of(const ResolvedCase& in,
                                             const study::PlanetaryDrivetrain& drivetrain,
                                             const gearset::WorkingGeometry& geometry) {
  static KnownMeshes known;
  const gearset::dynamics::Operation operation = study::set_operation(drivetrain, geometry);
  const gearset::MeshMotion motion =
      gearset::mesh_motion(operation.torques.sun, operation.speeds.sun - operation.speeds.carrier);
  const std::optional<double> held_race = held_race_of(drivetrain);
  return *known.find_or(mesh_key(in, drivetrain, motion, held_race), [&] {
    return gearset::planetary_meshes(drivetrain.set, geometry,
                                     {.sun_bore = in.number("gearset.sun_bore_ratio"),
                                      .ring_outside = in.number("gearset.ring_outside_ratio")},
                                     elasticity_of(in), motion, held_race);
  });
}

namespace {

void load_teeth(const gearset::LoadedTeeth& teeth, double force, NamedMesh& mesh) {
  mesh.stiffness.curve = gearset::tangent_spring(teeth, force).stiffness;
  mesh.error = gearset::transmission_error(teeth, force);
}

MeshStudy set_study(const ResolvedCase& in) {
  const study::PlanetaryDrivetrain drivetrain = drivetrain_without_gear_set(in);
  const gearset::PlanetarySet& set = drivetrain.set;
  const gearset::WorkingGeometry geometry = gearset::working_geometry(set);
  const gearset::PlanetaryMeshes meshes = planetary_meshes_of(in, drivetrain, geometry);
  const mechanics::Material material = elasticity_of(in);
  const double shift = geometry.planet_shift;
  NamedMesh sun{.first = "sun", .second = "planet", .stiffness = meshes.sun, .face_width = set.face_width};
  NamedMesh ring{.first = "ring", .second = "planet", .stiffness = meshes.ring, .face_width = set.face_width};
  const gearset::BasicRack planet_rack = rack_of(set, set.planet_heights);
  sun.standard = gearset::iso6336_stiffness({set.sun_teeth, set.planet_teeth, set.sun_shift, shift,
                                             rack_of(set, set.sun_heights), sun.stiffness.contact_ratio,
                                             material, set.helix_angle, set.web, planet_rack});
  // The standard takes the shift of a ring as that of an external gear: positive inward.
  ring.standard = gearset::iso6336_stiffness({set.planet_teeth, 0, shift, -set.ring_shift, planet_rack,
                                              ring.stiffness.contact_ratio, material, set.helix_angle,
                                              set.web, rack_of(set, set.ring_heights)});
  MeshStudy study;
  const gearset::MeanLoads loads = gearset::mean_loads(set, geometry, drivetrain.drive);
  sun.error = gearset::transmission_error(sun.stiffness.curve, loads.normal_force);
  ring.error = gearset::transmission_error(ring.stiffness.curve, loads.normal_force);
  if (set.flanks.contact == gearset::ToothContact::loaded) {
    const gearset::SetTeeth teeth = gearset::set_teeth(set, meshes);
    load_teeth(teeth.sun.teeth, loads.normal_force, sun);
    load_teeth(teeth.ring.teeth, loads.normal_force, ring);
    add_texts(gearset::edge_warnings(teeth, loads.normal_force), study.warnings);
  }
  if (set.helix_angle != 0.0) {
    study.axial = {geometry.base_helix_angle, loads, set.sun_thrust, gearset::axial_reactions(set, loads)};
  }
  const auto add = [&study](NamedMesh mesh, const std::vector<double>& lags) {
    for (std::size_t n = 0; n < lags.size(); ++n) {
      mesh.name = fmt::format("{}-planet {}", mesh.first, n + 1);
      mesh.phase = lags[n];
      study.meshes.push_back(mesh);
    }
  };
  if (drivetrain.rim == study::PlanetRim::elastic) study.planet_rim = study::derive(drivetrain).rim;
  add(sun, meshes.sun_lag);
  add(ring, meshes.ring_lag);
  study.gears = gear_circles(geometry);
  add_texts(gearset::tooth_warnings(geometry), study.warnings);
  for (std::string& text : ring_sign_warnings(in)) study.warnings.push_back(std::move(text));
  for (const gearset::Warning& warning : gearset::foundation_warnings(meshes))
    study.warnings.push_back(location_in_case(in, warning.key) + ": " + warning.text);
  warn_of_standard(sun, study.warnings);
  warn_of_standard(ring, study.warnings);
  return study;
}

}  // namespace

std::vector<GearCircles> gear_circles(const gearset::WorkingGeometry& geometry) {
  const double sun_mesh = geometry.sun_mesh.working_pressure_angle,
               ring_mesh = geometry.ring_mesh.working_pressure_angle;
  std::vector<GearCircles> gears{analysis::circles_of("sun", geometry.sun, sun_mesh),
                                 analysis::circles_of("planet", geometry.planet, sun_mesh),
                                 analysis::circles_of("ring", geometry.ring, ring_mesh)};
  if (geometry.second)
    gears.push_back(analysis::circles_of("stepped_planet", *geometry.second, ring_mesh));
  else
    gears[1].at_ring = analysis::circles_of("planet", geometry.planet, ring_mesh).pitch;
  return gears;
}

std::vector<Derived> circle_quantities(const std::string& prefix, const std::vector<GearCircles>& gears) {
  std::vector<Derived> rows;
  for (const GearCircles& one : gears) {
    std::string gear = one.gear;
    std::ranges::replace(gear, ' ', '_');
    const auto add = [&](const char* circle, double diameter, const char* meaning) {
      rows.push_back({prefix + gear + "." + circle + "_diameter", per_milli * diameter, "mm", meaning});
    };
    add("tip", one.tip, "of the tip circle");
    add("reference", one.reference, "of the reference circle");
    add("pitch", one.pitch,
        one.at_ring ? "of the working pitch circle in the sun mesh" : "of the working pitch circle");
    if (one.at_ring) add("ring_pitch", *one.at_ring, "of the working pitch circle in the ring mesh");
    add("base", one.base, "of the base circle");
    add("root", one.root, "of the root circle");
  }
  return rows;
}

MeshStudy mesh_study(const ResolvedCase& resolved) {
  if (resolved.model() == gear_pair) return analysis::meshes_of_pair(machine_of<analysis::ElasticPair>(resolved));
  if (resolved.model() == planetary_drivetrain && resolved.shape().several)
    throw BadInput(resolved.file() +
                   ": sets: found several sets; required: one set, as gearset at the top of a case");
  if (resolved.model() == planetary_drivetrain && !resolved.shape().teeth)
    throw BadInput(resolved.file() +
                   ": gearset.teeth: missing; required: teeth, which the meshes follow from");
  if (resolved.model() == planetary_drivetrain) return set_study(resolved);
  throw BadInput(resolved.origin("model") + ": model: found " + resolved.choice("model") +
                 "; required: gear-pair or planetary-drivetrain, which have meshes");
}

gearset::PlanetaryMeshes planetary_meshes_of(const ResolvedCase& resolved) {
  const study::PlanetaryDrivetrain drivetrain = drivetrain_without_gear_set(resolved);
  return planetary_meshes_of(resolved, drivetrain, gearset::working_geometry(drivetrain.set));
}

}  // namespace orbearing::app
