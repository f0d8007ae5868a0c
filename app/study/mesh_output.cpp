#include "app/study/mesh_output.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

#include "app/units.hpp"

namespace orbearing::app {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kCurveSamples = 200;     // of the curve, a period
constexpr std::size_t kErrorStep = 4;  // of the samples of a transmission error, one is written

Json parts_json(const gearset::GearCompliance& gear) {
  return {{"bending_N_per_m", 1.0 / gear.tooth.bending},
          {"shear_N_per_m", 1.0 / gear.tooth.shear},
          {"axial_N_per_m", 1.0 / gear.tooth.axial},
          {"foundation_N_per_m", 1.0 / gear.foundation}};
}

Json pitch_point_json(const NamedMesh& mesh) {
  const gearset::PairCompliance& pair = mesh.stiffness.at_pitch_point;
  Json point = parts_json(pair.first);
  point["hertz_N_per_m"] = 1.0 / pair.hertz;
  point["pair_N_per_m"] = 1.0 / pair.sum();
  point["gears"] = Json::array({parts_json(pair.first), parts_json(pair.second)});
  point["gears"][0]["gear"] = mesh.first;
  point["gears"][1]["gear"] = mesh.second;
  return point;
}

Json standard_json(const NamedMesh& mesh) {
  constexpr double unit = 1e9;  // [Pa] of 1 N/(mm um)
  return {{"c_th_N_per_mm_um", mesh.standard.theoretical_single / unit},
          {"c_prime_N_per_mm_um", mesh.standard.single / unit},
          {"c_gamma_N_per_mm_um", mesh.standard.mesh / unit},
          {"mean_N_per_m", mesh.standard.mesh * mesh.face_width},
          {"in_range", mesh.standard.in_range}};
}

Json curve_json(const gearset::PeriodicCurve& curve) {
  Json points = Json::array();
  for (int i = 0; i < kCurveSamples; ++i) {
    const double fraction = double(i) / kCurveSamples;
    points.push_back({fraction, curve.value(fraction)});
  }
  return points;
}

Json error_json(const gearset::TransmissionError& error) {
  Json harmonics = Json::array(), curve = Json::array();
  for (const double amplitude : error.harmonics) harmonics.push_back(1e6 * amplitude);
  const double samples = static_cast<double>(error.curve.size());
  for (std::size_t i = 0; i < error.curve.size(); i += kErrorStep)
    curve.push_back({(static_cast<double>(i) + 0.5) / samples, 1e6 * error.curve[i]});
  return {{"force_N", error.force},
          {"mean_um", 1e6 * error.mean},
          {"peak_to_peak_um", 1e6 * error.peak_to_peak},
          {"harmonics_um", harmonics},
          {"curve_um", curve}};
}

Json mesh_json(const NamedMesh& mesh) {
  const gearset::PeriodicCurve& curve = mesh.stiffness.curve;
  Json json{{"name", mesh.name},
            {"contact_ratio", mesh.stiffness.contact_ratio},
            {"overlap_ratio", mesh.stiffness.overlap_ratio},
            {"total_contact_ratio", mesh.stiffness.contact_ratio + mesh.stiffness.overlap_ratio},
            {"mean_N_per_m", curve.mean()},
            {"min_N_per_m", curve.least()},
            {"max_N_per_m", curve.largest()},
            {"phase", mesh.phase},
            {"at_pitch_point", pitch_point_json(mesh)},
            {"iso6336", standard_json(mesh)},
            {"jumps", curve.jumps()},
            {"curve", curve_json(curve)}};
  if (mesh.error) json["transmission_error"] = error_json(*mesh.error);
  return json;
}

std::string error_text(const NamedMesh& mesh) {
  if (!mesh.error) return "";
  const gearset::TransmissionError& error = *mesh.error;
  return fmt::format(
      "transmission error under {:.5g} N: mean {:.4g} um, peak to peak {:.4g} um, harmonics {:.3g}, {:.3g}, "
      "{:.3g} um\n",
      error.force, 1e6 * error.mean, 1e6 * error.peak_to_peak, 1e6 * error.harmonics[0],
      1e6 * error.harmonics[1], 1e6 * error.harmonics[2]);
}

std::string row(const NamedMesh& mesh) {
  const gearset::PeriodicCurve& curve = mesh.stiffness.curve;
  return fmt::format("{:<16} {:>8.4f} {:>10.4g} {:>10.4g} {:>10.4g} {:>8.4f} {:>12.4g}\n", mesh.name,
                     mesh.stiffness.contact_ratio, 1e-6 * curve.mean(), 1e-6 * curve.least(),
                     1e-6 * curve.largest(), mesh.phase, 1e-6 * mesh.standard.mesh * mesh.face_width);
}

std::string parts_row(const std::string& name, const gearset::GearCompliance& gear) {
  return fmt::format("  {:<14} {:>10.5g} {:>10.5g} {:>10.5g} {:>10.5g}\n", name, 1e-6 / gear.tooth.bending,
                     1e-6 / gear.tooth.shear, 1e-6 / gear.tooth.axial, 1e-6 / gear.foundation);
}

std::string parts_text(const NamedMesh& mesh) {
  const gearset::PairCompliance& pair = mesh.stiffness.at_pitch_point;
  return fmt::format("\n{}: one pair of teeth at the pitch point, {:.5g} N/um; contact alone {:.5g} N/um\n",
                     mesh.first + " and " + mesh.second, 1e-6 / pair.sum(), 1e-6 / pair.hertz) +
         fmt::format("  {:<14} {:>10} {:>10} {:>10} {:>10}  [N/um]\n", "", "bending", "shear", "axial",
                     "foundation") +
         parts_row(mesh.first, pair.first) + parts_row(mesh.second, pair.second);
}

Json waves_json(const Eigen::ArrayXd& waves) {
  return std::vector<double>(waves.begin(), waves.end());
}

Json form_json(const gearset::rim::RaceForm& form) {
  return {{"cosine_m_per_N", waves_json(form.cosine)}, {"sine_m_per_N", waves_json(form.sine)}};
}

std::string axial_text(const AxialForces& axial) {
  return fmt::format(
      "\nhelical teeth: on each planet {:.4g} N from the sun along the axis and as much against it from the "
      "ring, which overturn it by {:.4g} N m\nthrust of the sun {:.4g} N, held by the {}; of the ring {:.4g} "
      "N\n",
      axial.loads.axial_force, axial.loads.overturning_moment, axial.loads.sun_thrust,
      described::text_of(axial.held_by), 0.0 - axial.loads.sun_thrust);
}

std::string rim_text(const gearset::rim::RimInfluence& rim) {
  return fmt::format(
      "\nrim of the planet, beyond a race that is held: the tooth of the sun mesh gives way by {:.4g} um/kN, "
      "that of the ring mesh by {:.4g}, each by {:.4g} under the other's force\n",
      1e9 * rim.meshes(0, 0), 1e9 * rim.meshes(1, 1), 1e9 * rim.meshes(0, 1));
}

}  // namespace

Json planet_rim_json(const MeshStudy& study) {
  if (!study.planet_rim) return nullptr;
  const gearset::rim::RimInfluence& rim = *study.planet_rim;
  return {{"race_by_rollers_m_per_N", waves_json(rim.race)},
          {"race_by_sun", form_json(rim.by_sun)},
          {"race_by_ring", form_json(rim.by_ring)},
          {"teeth_m_per_N",
           {{"sun_by_sun", rim.meshes(0, 0)},
            {"sun_by_ring", rim.meshes(0, 1)},
            {"ring_by_ring", rim.meshes(1, 1)}}}};
}

Json axial_json(const MeshStudy& study) {
  if (!study.axial) return nullptr;
  const gearset::MeanLoads& loads = study.axial->loads;
  const gearset::AxialReactions& held = study.axial->reactions;
  return {{"base_helix_angle_deg", kDegree * study.axial->base_helix_angle},
          {"tooth_normal_force_N", loads.tooth_force},
          {"sun_on_planet_N", loads.axial_force},
          {"ring_on_planet_N", 0.0 - loads.axial_force},
          {"planet_overturning_moment_N_m", loads.overturning_moment},
          {"thrust_on_sun_N", loads.sun_thrust},
          {"thrust_on_ring_N", 0.0 - loads.sun_thrust},
          {"sun_thrust_held_by", described::text_of(study.axial->held_by)},
          {"held_by_housing", {{"sun_N", held.sun}, {"carrier_N", held.carrier}, {"ring_N", held.ring}}}};
}

Json meshes_json(const MeshStudy& study) {
  Json list = Json::array();
  for (const NamedMesh& mesh : study.meshes) list.push_back(mesh_json(mesh));
  return list;
}

std::string mesh_text(const MeshStudy& study, Glyphs glyphs) {
  std::string text = fmt::format("{:<16} {:>8} {:>10} {:>10} {:>10} {:>8} {:>12}\n", "mesh", "contact",
                                 "mean", "least", "largest", "phase", "ISO 6336 B");
  text += fmt::format("{:<16} {:>8} {:>10} {:>10} {:>10} {:>8} {:>12}\n", "", "ratio", "[N/um]", "[N/um]",
                      "[N/um]", "[1]", "mean [N/um]");
  for (const NamedMesh& mesh : study.meshes) text += row(mesh);
  std::string last;
  for (const NamedMesh& mesh : study.meshes) {  // meshes of a kind differ in their phase only
    if (mesh.first == last) continue;
    last = mesh.first;
    text += parts_text(mesh) + error_text(mesh) +
            mesh_chart(mesh.stiffness, mesh.first + " and " + mesh.second, glyphs);
  }
  if (study.axial) text += axial_text(*study.axial);
  if (study.planet_rim) text += rim_text(*study.planet_rim);
  return text;
}

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

}  // namespace orbearing::app
