#include "coupling/analysis/meshes.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace orbearing::analysis {

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

void add_texts(const gearset::Warnings& warnings, std::vector<std::string>& texts) {
  for (const gearset::Warning& warning : warnings) texts.push_back(warning.key + ": " + warning.text);
}

void warn_of_standard(const NamedMesh& mesh, std::vector<std::string>& texts) {
  if (mesh.standard.in_range) return;
  texts.push_back(
      mesh.first + " and " + mesh.second +
      ": profile shifts or helix outside the range of ISO 6336-1, method B. Range: pinion shift not below "
      "wheel shift, sum -0.5 to 2, helix up to 30 deg. The values are shown nevertheless");
}

}  // namespace orbearing::analysis
