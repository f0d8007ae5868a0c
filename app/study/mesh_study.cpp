#include "app/study/mesh_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "app/case/pair_case.hpp"
#include "app/case/set_case.hpp"
#include "app/errors.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/units.hpp"
#include "gearset/checks.hpp"
#include "gearset/mesh/loaded/tooth_pairs.hpp"
#include "gearset/planet_body.hpp"

namespace orbearing::app {

namespace {

void add_texts(const gearset::Warnings& warnings, std::vector<std::string>& texts) {
  for (const gearset::Warning& warning : warnings) texts.push_back(warning.key + ": " + warning.text);
}

mechanics::Material elasticity_of(const ResolvedCase& in) {
  return {.youngs_modulus = in.quantity("material.youngs_modulus"),
          .poisson_ratio = in.number("material.poisson_ratio")};
}

void warn_standard(const NamedMesh& mesh, std::vector<std::string>& texts) {
  if (mesh.standard.in_range) return;
  texts.push_back(
      mesh.first + " and " + mesh.second +
      ": profile shifts or helix outside the range of ISO 6336-1, method B (pinion's shift not "
      "below the wheel's, sum from -0.5 to 2, helix up to 30 deg); its values are shown all the same");
}

MeshStudy pair_study(const ResolvedCase& in) {
  const gearset::GearPair pair = pair_of(in);
  const gearset::PairGeometry geometry = gearset::pair_geometry(pair);
  const mechanics::Material material = elasticity_of(in);
  const auto gear = [&](std::size_t i) {
    return gearset::make_mesh_gear(geometry.gears.at(i), 0.5 * pair.bore, pair.face_width, material);
  };
  const gearset::MeshingGears gears =
      gearset::meshing_gears(gear(0), gear(1), geometry.centre_distance, true);
  MeshStudy study;
  study.meshes.push_back({.name = "pair",
                          .first = "first gear",
                          .second = "second gear",
                          .stiffness = gearset::mesh_stiffness(gears),
                          .standard = gearset::iso6336_stiffness(
                              {pair.teeth[0], pair.teeth[1], pair.shift[0], pair.shift[1], pair.rack,
                               geometry.contact_ratio, material, pair.helix_angle, pair.web}),
                          .face_width = pair.face_width});
  gearset::PeriodicCurve& curve = study.meshes.front().stiffness.curve;
  if (pair.web.thickness) curve = curve.times(gearset::web_factor(pair.web));
  const double position = gearset::pitch_point(gears);
  add_texts(gearset::pair_warnings(geometry), study.warnings);
  add_texts(
      gearset::foundation_warnings(gears.first, gears.line_length - position, "first gear", "pair.bore"),
      study.warnings);
  add_texts(gearset::foundation_warnings(gears.second, position, "second gear", "pair.bore"), study.warnings);
  warn_standard(study.meshes.front(), study.warnings);
  return study;
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
  const gearset::MeanLoads loads = gearset::mean_loads(drivetrain.set, geometry, drivetrain.drive);
  const gearset::MeshMotion motion =
      gearset::mesh_motion(loads.sun_torque, loads.sun_speed - loads.carrier_speed);
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
  // The standard counts the shift of a ring as that of an external gear: positive inward.
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
  add_texts(gearset::tooth_warnings(geometry), study.warnings);
  for (std::string& text : ring_sign_warnings(in)) study.warnings.push_back(std::move(text));
  for (const gearset::Warning& warning : gearset::foundation_warnings(meshes))
    study.warnings.push_back(location_in_case(in, warning.key) + ": " + warning.text);
  warn_standard(sun, study.warnings);
  warn_standard(ring, study.warnings);
  return study;
}

double mass(const gearset::ExternalTooth& gear, const gearset::GearPair& pair, double density) {
  return density * pair.face_width * gearset::section_moments(gear, 0.5 * pair.bore).area;
}

}  // namespace

MeshStudy mesh_study(const ResolvedCase& resolved) {
  if (resolved.model() == gear_pair) return pair_study(resolved);
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

std::vector<Derived> pair_quantities(const ResolvedCase& resolved, const MeshStudy& study) {
  const gearset::GearPair pair = pair_of(resolved);
  const gearset::PairGeometry geometry = gearset::pair_geometry(pair);
  const double density = resolved.quantity("material.density");
  return {{"pair.centre_distance", 1e3 * geometry.centre_distance, "mm", "working, without backlash"},
          {"pair.working_pressure_angle", kDegree * geometry.working_pressure_angle, "deg", "working"},
          {"pair.contact_ratio", geometry.contact_ratio, "1",
           "where the involutes end; of helical teeth transverse"},
          {"pair.overlap_ratio", geometry.overlap_ratio, "1", "face width in axial pitches"},
          {"pair.mass.first", mass(geometry.gears[0], pair, density), "kg", "the driving gear"},
          {"pair.mass.second", mass(geometry.gears[1], pair, density), "kg", "the driven gear"},
          {"pair.mesh_stiffness", study.meshes.front().stiffness.curve.mean(), "N/m",
           "mean over the mesh period, from tooth geometry"}};
}

}  // namespace orbearing::app
