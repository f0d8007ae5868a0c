#include "app/study/mesh_study.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <utility>

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
      ": profile shifts or helix outside the range of ISO 6336-1, method B. Range: pinion shift not below "
      "wheel shift, sum -0.5 to 2, helix up to 30 deg. The values are shown nevertheless");
}

constexpr const char* kGearNames[] = {"first gear", "second gear"};

// A pair of either kind. The ring is the first gear of its mesh, whichever drives.
struct MeshedPair {
  std::size_t first = 0, second = 1;    // of the mesh, among the gears of the case
  double centre_distance = 0.0;         // [m]
  double working_pressure_angle = 0.0;  // [rad]
  double contact_ratio = 0.0;           // [-]
  std::array<double, 2> area{};         // [m^2]  of the gears of the case in section
  gearset::MeshingGears gears;
  gearset::Warnings warnings;
  std::array<GearCircles, 2> circles{};  // of the gears of the case
};

// Of a gear of either kind in one mesh.
template <class Tooth>
GearCircles circles_of(const char* gear, const Tooth& tooth, double working_pressure_angle) {
  return {.gear = gear,
          .tip = 2.0 * tooth.tip_radius,
          .reference = 2.0 * tooth.pitch_radius,
          .base = 2.0 * tooth.base_radius,
          .root = 2.0 * tooth.root_radius,
          .pitch = 2.0 * tooth.base_radius / std::cos(working_pressure_angle),
          .at_ring = {}};
}

MeshedPair meshed_pair(const gearset::GearPair& pair, const mechanics::Material& material) {
  const auto gear = [&](std::size_t which, const gearset::ExternalTooth& tooth) {
    return gearset::make_mesh_gear(tooth, 0.5 * pair.bore_of(which), pair.face_width, material);
  };
  const auto area = [&](std::size_t which, const gearset::ExternalTooth& tooth) {
    return gearset::section_moments(tooth, 0.5 * pair.bore_of(which)).area;
  };
  if (!pair.is_internal()) {
    const gearset::PairGeometry g = gearset::pair_geometry(pair);
    const auto& [driving, driven] = g.gears;
    return {.centre_distance = g.centre_distance,
            .working_pressure_angle = g.working_pressure_angle,
            .contact_ratio = g.contact_ratio,
            .area = {area(0, driving), area(1, driven)},
            .gears = gearset::meshing_gears(gear(0, driving), gear(1, driven), g.centre_distance, true),
            .warnings = gearset::pair_warnings(g),
            .circles = {circles_of(kGearNames[0], driving, g.working_pressure_angle),
                        circles_of(kGearNames[1], driven, g.working_pressure_angle)}};
  }
  const gearset::InternalMesh g = gearset::internal_mesh(pair);
  const double outside = pair.ring_outside * g.ring.root_radius;
  MeshedPair found{
      .first = pair.ring(),
      .second = pair.inside(),
      .centre_distance = g.centre_distance,
      .working_pressure_angle = g.mesh.working_pressure_angle,
      .contact_ratio = g.mesh.contact_ratio,
      .gears = gearset::meshing_gears(gearset::make_mesh_gear(g.ring, outside, pair.face_width, material),
                                      gear(pair.inside(), g.inside), g.centre_distance, pair.ring() == 0),
      .warnings = gearset::pair_warnings(g)};
  found.circles.at(pair.ring()) = circles_of(kGearNames[pair.ring()], g.ring, g.mesh.working_pressure_angle);
  found.circles.at(pair.inside()) =
      circles_of(kGearNames[pair.inside()], g.inside, g.mesh.working_pressure_angle);
  found.area.at(pair.ring()) = gearset::section_moments(g.ring, outside).area;
  found.area.at(pair.inside()) = area(pair.inside(), g.inside);
  return found;
}

MeshStudy pair_study(const ResolvedCase& in) {
  const gearset::GearPair pair = pair_of(in);
  const mechanics::Material material = elasticity_of(in);
  const MeshedPair meshed = meshed_pair(pair, material);
  const std::size_t first = meshed.first, second = meshed.second;
  const bool ring = pair.is_internal();
  MeshStudy study;
  study.gears = {meshed.circles.begin(), meshed.circles.end()};
  // The standard counts the shift of a ring as that of an external gear: positive inward.
  study.meshes.push_back({.name = "pair",
                          .first = kGearNames[first],
                          .second = kGearNames[second],
                          .stiffness = gearset::mesh_stiffness(meshed.gears),
                          .standard = gearset::iso6336_stiffness(
                              {pair.teeth.at(second), ring ? 0 : pair.teeth.at(first), pair.shift.at(second),
                               ring ? -pair.shift.at(first) : pair.shift.at(first), pair.rack,
                               meshed.contact_ratio, material, pair.helix_angle, pair.web}),
                          .face_width = pair.face_width});
  gearset::PeriodicCurve& curve = study.meshes.front().stiffness.curve;
  if (pair.web.thickness) curve = curve.times(gearset::web_factor(pair.web));
  const double position = gearset::pitch_point(meshed.gears);
  add_texts(meshed.warnings, study.warnings);
  add_texts(gearset::foundation_warnings(meshed.gears.first, meshed.gears.line_length - position,
                                         kGearNames[first], gearset::bore_key(pair, first)),
            study.warnings);
  add_texts(gearset::foundation_warnings(meshed.gears.second, position, kGearNames[second],
                                         gearset::bore_key(pair, second)),
            study.warnings);
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
  study.gears = gear_circles(geometry);
  add_texts(gearset::tooth_warnings(geometry), study.warnings);
  for (std::string& text : ring_sign_warnings(in)) study.warnings.push_back(std::move(text));
  for (const gearset::Warning& warning : gearset::foundation_warnings(meshes))
    study.warnings.push_back(location_in_case(in, warning.key) + ": " + warning.text);
  warn_standard(sun, study.warnings);
  warn_standard(ring, study.warnings);
  return study;
}

}  // namespace

std::vector<GearCircles> gear_circles(const gearset::WorkingGeometry& geometry) {
  const double sun_mesh = geometry.sun_mesh.working_pressure_angle,
               ring_mesh = geometry.ring_mesh.working_pressure_angle;
  std::vector<GearCircles> gears{circles_of("sun", geometry.sun, sun_mesh),
                                 circles_of("planet", geometry.planet, sun_mesh),
                                 circles_of("ring", geometry.ring, ring_mesh)};
  if (geometry.second)
    gears.push_back(circles_of("stepped_planet", *geometry.second, ring_mesh));
  else
    gears[1].at_ring = circles_of("planet", geometry.planet, ring_mesh).pitch;
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
  const MeshedPair geometry = meshed_pair(pair, elasticity_of(resolved));
  const double mass_per_area = resolved.quantity("material.density") * pair.face_width;
  std::vector<Derived> rows{
      {"pair.centre_distance", 1e3 * geometry.centre_distance, "mm", "working, without backlash"},
      {"pair.working_pressure_angle", kDegree * geometry.working_pressure_angle, "deg", "working"},
      {"pair.contact_ratio", geometry.contact_ratio, "1",
       "where the involutes end; of helical teeth transverse"},
      {"pair.overlap_ratio", gearset::overlap_ratio(pair.face_width, pair.module, pair.helix_angle), "1",
       "face width in axial pitches"},
      {"pair.mass.first", mass_per_area * geometry.area[0], "kg", "the driving gear"},
      {"pair.mass.second", mass_per_area * geometry.area[1], "kg", "the driven gear"},
      {"pair.mesh_stiffness", study.meshes.front().stiffness.curve.mean(), "N/m",
       "mean over the mesh period, from tooth geometry"}};
  for (Derived& row : circle_quantities("pair.", study.gears)) rows.push_back(std::move(row));
  return rows;
}

namespace {

using described::Dimension;
using described::Record;
namespace dimension = described::dimension;

constexpr int kCurveSamples = 200;     // of the curve, a period
constexpr std::size_t kErrorStep = 4;  // of the samples of a transmission error, one is written

// Least or largest stiffness while `pairs` pairs touch; NaN where that many never do, or helical teeth come
// into contact one end first.
double while_pairs_touch(const gearset::MeshStiffness& mesh, int pairs, bool largest) {
  constexpr int samples = 2000;
  double found = std::numeric_limits<double>::quiet_NaN();
  if (mesh.overlap_ratio > 0.0) return found;
  for (int i = 0; i < samples; ++i) {
    const double fraction = (i + 0.5) / samples;
    if (std::ceil(mesh.contact_ratio - fraction) != pairs) continue;
    const double value = mesh.curve.value(fraction);
    if (!(largest ? found >= value : found <= value)) found = value;
  }
  return found;
}

void describe_parts(Record& record, const gearset::GearCompliance& gear) {
  record.value("bending_N_per_m", dimension::stiffness, "of the tooth", 1.0 / gear.tooth.bending);
  record.value("shear_N_per_m", dimension::stiffness, "of the tooth", 1.0 / gear.tooth.shear);
  record.value("axial_N_per_m", dimension::stiffness, "of the tooth", 1.0 / gear.tooth.axial);
  record.value("foundation_N_per_m", dimension::stiffness, "of the body below it", 1.0 / gear.foundation);
}

void describe_pitch_point(Record& record, const NamedMesh& mesh) {
  const gearset::PairCompliance& pair = mesh.stiffness.at_pitch_point;
  describe_parts(record, pair.first);
  record.value("hertz_N_per_m", dimension::stiffness, "of the contact", 1.0 / pair.hertz);
  record.value("pair_N_per_m", dimension::stiffness, "of all in series", 1.0 / pair.sum());
  const std::array gears{std::pair(mesh.first, pair.first), std::pair(mesh.second, pair.second)};
  record.table("gears", "gear", "both gears", gears, [](Record& row, const auto& gear) {
    describe_parts(row, gear.second);
    row.value("gear", "", gear.first);
  });
}

void describe_standard(Record& record, const NamedMesh& mesh) {
  const gearset::Iso6336Stiffness& standard = mesh.standard;
  record.value("c_th_N_per_mm_um", dimension::tooth_stiffness, "theoretical, of one pair",
               standard.theoretical_single);
  record.value("c_prime_N_per_mm_um", dimension::tooth_stiffness, "of one pair", standard.single);
  record.value("c_gamma_N_per_mm_um", dimension::tooth_stiffness, "of the mesh", standard.mesh);
  record.value("mean_N_per_m", dimension::stiffness, "the same over the face width",
               standard.mesh * mesh.face_width);
  record.value("in_range", "whether the gears lie in the range of the standard", standard.in_range);
}

std::vector<std::array<double, 2>> sampled(const gearset::PeriodicCurve& curve) {
  std::vector<std::array<double, 2>> points;
  for (int i = 0; i < kCurveSamples; ++i) {
    const double fraction = double(i) / kCurveSamples;
    points.push_back({fraction, curve.value(fraction)});
  }
  return points;
}

void describe_error(Record& record, const gearset::TransmissionError& error) {
  constexpr Dimension fraction_and_um{"transmission error", "um", "um", ""};
  std::vector<std::array<double, 2>> curve;
  const double samples = static_cast<double>(error.curve.size());
  for (std::size_t i = 0; i < error.curve.size(); i += kErrorStep)
    curve.push_back({(static_cast<double>(i) + 0.5) / samples, 1e6 * error.curve[i]});
  record.value("force_N", dimension::force, "of the mesh", error.force);
  record.value("mean_um", dimension::small_length, "over a mesh period", error.mean);
  record.value("peak_to_peak_um", dimension::small_length, "over a mesh period", error.peak_to_peak);
  record.array("harmonics_um", dimension::small_length, "at orders 1, 2, ... of the mesh frequency",
               {"order"}, error.harmonics);
  record.array("curve_um", fraction_and_um, "fraction of the mesh period, error", {"sample", "pair"}, curve);
}

void describe_form(Record& record, const gearset::rim::RaceForm& form) {
  record.array("cosine_m_per_N", dimension::race_compliance, "orders 0, 1, ...", {"wave"}, form.cosine);
  record.array("sine_m_per_N", dimension::race_compliance, "orders 0, 1, ...", {"wave"}, form.sine);
}

void describe_axial(Record& record, const AxialForces& axial) {
  const gearset::MeanLoads& loads = axial.loads;
  record.value("base_helix_angle_deg", dimension::angle, "of the teeth", axial.base_helix_angle);
  record.value("tooth_normal_force_N", dimension::force, "of one mesh of one planet", loads.tooth_force);
  record.value("sun_on_planet_N", dimension::force, "along the axis", loads.axial_force);
  record.value("ring_on_planet_N", dimension::force, "along the axis", 0.0 - loads.axial_force);
  record.value("planet_overturning_moment_N_m", dimension::torque, "of both on a planet",
               loads.overturning_moment);
  record.value("thrust_on_sun_N", dimension::force, "of all planets", loads.sun_thrust);
  record.value("thrust_on_ring_N", dimension::force, "of all planets", 0.0 - loads.sun_thrust);
  record.value("sun_thrust_held_by", "", described::text_of(axial.held_by));
  record.child("held_by_housing", "axial reactions", axial.reactions, [](Record& held, const auto& of) {
    held.value("sun_N", dimension::force, "", of.sun);
    held.value("carrier_N", dimension::force, "", of.carrier);
    held.value("ring_N", dimension::force, "", of.ring);
  });
}

void describe_rim(Record& record, const gearset::rim::RimInfluence& rim) {
  record.array("race_by_rollers_m_per_N", dimension::race_compliance, "orders 0, 1, ...", {"wave"}, rim.race);
  record.child("race_by_sun", "race by a force of the sun", rim.by_sun, describe_form);
  record.child("race_by_ring", "race by a force of the ring", rim.by_ring, describe_form);
  record.array("teeth_m_per_N", dimension::race_compliance, "teeth by forces of the meshes",
               {{"mesh", {"sun_by_sun", "sun_by_ring", "ring_by_ring"}}},
               std::array{rim.meshes(0, 0), rim.meshes(0, 1), rim.meshes(1, 1)});
}

// Stiffness over the mesh period, from zero on.
std::string mesh_chart(const gearset::MeshStiffness& mesh, const std::string& title, Glyphs glyphs) {
  constexpr int columns = 60, lines = 8, label_width = 9;
  const bool plain = glyphs == Glyphs::ascii;
  Canvas canvas(columns, lines, glyphs);
  const double largest = mesh.curve.largest();
  for (int x = 0; x < canvas.width(); ++x) {
    const double value = mesh.curve.value((x + 0.5) / canvas.width());
    canvas.dot(x, static_cast<int>(std::lround(value / largest * (canvas.height() - 1))));
  }
  std::string text = fmt::format("{:>{}}   {}\n", "[N/um]", label_width, title);
  const std::vector<std::string> drawn = canvas.lines();
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const std::string label =
        i == 0 ? fmt::format("{:.4g}", 1e-6 * largest) : (i + 1 == drawn.size() ? "0" : "");
    text += fmt::format("{:>{}} {}{}\n", label, label_width, plain ? "|" : "│", drawn[i]);
  }
  text += fmt::format("{:>{}} {}", "", label_width, plain ? "+" : "└");
  for (int i = 0; i < columns; ++i) text += plain ? "-" : "─";
  return text + fmt::format("\n{:>{}}  {:<{}}{}  [mesh period since a pair came into contact]\n", "",
                            label_width, "0", columns - 1, "1");
}

}  // namespace

void describe(Record& row, const NamedMesh& mesh) {
  const gearset::MeshStiffness& stiffness = mesh.stiffness;
  const gearset::PeriodicCurve& curve = stiffness.curve;
  row.value("name", "", mesh.name);
  row.value("contact_ratio", dimension::ratio, "transverse", stiffness.contact_ratio);
  row.value("overlap_ratio", dimension::ratio, "of helical teeth", stiffness.overlap_ratio);
  row.value("total_contact_ratio", dimension::ratio, "sum of both",
            stiffness.contact_ratio + stiffness.overlap_ratio);
  row.value("mean_N_per_m", dimension::stiffness, "over a mesh period", curve.mean());
  row.value("min_N_per_m", dimension::stiffness, "over a mesh period", curve.least());
  row.value("max_N_per_m", dimension::stiffness, "over a mesh period", curve.largest());
  row.value("phase", dimension::ratio, "of the mesh period, behind the first mesh", mesh.phase);
  row.child("at_pitch_point", "one pair of teeth; parts of the first gear's", mesh, describe_pitch_point);
  row.child("iso6336", "by ISO 6336, method B", mesh, describe_standard);
  row.array("jumps", dimension::ratio, "fractions of the period where the stiffness jumps", {"jump"},
            curve.jumps());
  row.array("curve", {}, "fraction of the mesh period, stiffness", {"sample", "pair"}, sampled(curve));
  if (mesh.error) row.child("transmission_error", "under load", *mesh.error, describe_error);
  for (const auto& [name, pairs] : {std::pair("single", 1), std::pair("double", 2)}) {
    row.value(std::string(name) + "_min_N_per_m", dimension::stiffness, "least while so many pairs touch",
              while_pairs_touch(stiffness, pairs, false));
    row.value(std::string(name) + "_max_N_per_m", dimension::stiffness, "largest while so many pairs touch",
              while_pairs_touch(stiffness, pairs, true));
  }
}

void describe(Record& row, const GearCircles& gear) {
  row.value("name", "", gear.gear);
  row.value("tip_mm", dimension::length, "diameter of the tip circle", gear.tip);
  row.value("reference_mm", dimension::length, "diameter of the reference circle", gear.reference);
  row.value("pitch_mm", dimension::length,
            "diameter of the working pitch circle; of a planet, in the sun mesh", gear.pitch);
  row.value("ring_pitch_mm", dimension::length,
            "diameter of a planet's working pitch circle in the ring mesh",
            gear.at_ring.value_or(described::kAbsent));
  row.value("base_mm", dimension::length, "diameter of the base circle", gear.base);
  row.value("root_mm", dimension::length, "diameter of the root circle", gear.root);
}

void describe(Record& record, const MeshStudy& study) {
  record.table("meshes", "mesh", "stiffness over the mesh period", study.meshes);
  record.table("gears", "gear", "diameters of the gears", study.gears);
  if (study.axial) record.child("axial", "forces of helical teeth", *study.axial, describe_axial);
  if (study.planet_rim)
    record.child("planet_rim", "influence functions of the elastic rim", *study.planet_rim, describe_rim);
}

std::string mesh_charts(const MeshStudy& study, Glyphs glyphs) {
  std::string text, last;
  for (const NamedMesh& mesh : study.meshes) {  // meshes of a kind differ in their phase only
    if (mesh.first == last) continue;
    last = mesh.first;
    text += "\n" + mesh_chart(mesh.stiffness, mesh.first + " and " + mesh.second, glyphs);
  }
  return text;
}

}  // namespace orbearing::app
