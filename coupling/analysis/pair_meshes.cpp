#include "coupling/analysis/pair_meshes.hpp"

#include <array>
#include <string>

#include "gearset/checks.hpp"
#include "gearset/mesh/planetary_meshes.hpp"
#include "gearset/planet_body.hpp"

namespace orbearing::analysis {

namespace {

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
  const double outside = std::get<gearset::InternalPair>(pair.kind).ring_outside * g.ring.root_radius;
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

}  // namespace

MeshStudy meshes_of_pair(const ElasticPair& in) {
  const gearset::GearPair& pair = in.pair;
  const mechanics::Material material = in.material.material();
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
  warn_of_standard(study.meshes.front(), study.warnings);
  return study;
}

mechanics::Problems problems(const PairOfGears& machine) {
  return gearset::pair_problems(machine.pair);
}

PairQuantities quantities_of(const PairOfGears& machine) {
  const gearset::GearPair& pair = machine.pair;
  const ElasticPair elastic{pair, {machine.material.youngs_modulus, machine.material.poisson_ratio}};
  const MeshedPair meshed = meshed_pair(pair, machine.material);
  const MeshStudy mesh = meshes_of_pair(elastic);
  const double mass_per_area = machine.material.density * pair.face_width;
  return {.centre_distance = meshed.centre_distance,
          .working_pressure_angle = meshed.working_pressure_angle,
          .contact_ratio = meshed.contact_ratio,
          .overlap_ratio = gearset::overlap_ratio(pair.face_width, pair.module, pair.helix_angle),
          .mass = {mass_per_area * meshed.area[0], mass_per_area * meshed.area[1]},
          .mesh_stiffness = mesh.meshes.front().stiffness.curve.mean(),
          .gears = meshed.circles,
          .warnings = mesh.warnings};
}

namespace {

void describe_circles(described::Record& row, const GearCircles& gear) {
  const auto add = [&](const char* circle, double diameter, const char* meaning) {
    row.value(std::string(circle) + "_diameter_mm", described::dimension::length, meaning, diameter);
  };
  add("tip", gear.tip, "of the tip circle");
  add("reference", gear.reference, "of the reference circle");
  add("pitch", gear.pitch, "of the working pitch circle");
  add("base", gear.base, "of the base circle");
  add("root", gear.root, "of the root circle");
}

}  // namespace

void describe(described::Record& record, const PairQuantities& of) {
  using namespace described;
  record.value("centre_distance_mm", dimension::length, "working, without backlash", of.centre_distance);
  record.value("working_pressure_angle_deg", dimension::angle, "working", of.working_pressure_angle);
  record.value("contact_ratio", dimension::ratio, "where the involutes end; of helical teeth transverse",
               of.contact_ratio);
  record.value("overlap_ratio", dimension::ratio, "face width in axial pitches", of.overlap_ratio);
  record.child("mass", "of both gears", of.mass, [](Record& row, const std::array<double, 2>& mass) {
    row.value("first_kg", dimension::mass, "the driving gear", mass[0]);
    row.value("second_kg", dimension::mass, "the driven gear", mass[1]);
  });
  record.value("mesh_stiffness_N_per_m", dimension::stiffness,
               "mean over the mesh period, from tooth geometry", of.mesh_stiffness);
  record.child("first_gear", "circles", of.gears[0], describe_circles);
  record.child("second_gear", "circles", of.gears[1], describe_circles);
}

}  // namespace orbearing::analysis
