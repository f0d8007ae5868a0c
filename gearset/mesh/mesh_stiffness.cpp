#include "gearset/mesh/mesh_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gearset/involute.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::gearset {

namespace {

using constants::pi;

bool internal(const MeshingGears& gears) {
  return std::holds_alternative<RingTooth>(gears.first.tooth);
}

// Tangent length on the first gear of the point at `position` on the second: along the common line of action
// the lengths of external gears add up, those of a ring and its planet differ by a constant.
double position_on_first(const MeshingGears& gears, double position) {
  return internal(gears) ? gears.line_length + position : gears.line_length - position;
}

double contact_ratio_of(const MeshingGears& gears) {
  return gears.path.length() / gears.base_pitch;
}

// A pair that leaves as the next one comes makes one change, not two a hair's breadth apart.
double lasting_periods(const MeshingGears& gears) {
  constexpr double at_once = 1e-6;  // [period]
  const double ratio = contact_ratio_of(gears);
  return std::abs(ratio - std::round(ratio)) < at_once ? std::round(ratio) : ratio;
}

}  // namespace

MeshingGears meshing_gears(const MeshGear& first, const MeshGear& second, double centre_distance,
                           bool first_drives) {
  const ExternalTooth& planet = std::get<ExternalTooth>(second.tooth);
  MeshingGears gears{.first = first, .second = second, .first_drives = first_drives};
  const double sign = internal(gears) ? -1.0 : 1.0;
  const double base = std::abs(base_radius(first) + sign * planet.base_radius);
  if (!(centre_distance >= base))
    throw std::domain_error("the base circles of a pair leave no line of action; widen the centre distance");
  gears.line_length = tangent_length(base, centre_distance);
  gears.base_pitch = 2.0 * pi * planet.base_radius / planet.teeth;
  gears.face_width = std::min(first.face_width, second.face_width);
  gears.base_helix_angle = base_helix_angle(planet.normal_pressure_angle, planet.helix_angle);
  gears.overlap_ratio = overlap_ratio(gears.face_width, planet.module, planet.helix_angle);
  gears.path = internal(gears)
                   ? internal_contact_path(std::get<RingTooth>(first.tooth), planet, centre_distance)
                   : external_contact_path(std::get<ExternalTooth>(first.tooth), planet, centre_distance);
  if (!(gears.path.length() > 0.0)) throw std::domain_error("the teeth of a pair do not reach each other");
  return gears;
}

double hertz_compliance(double face_width, const mechanics::Material& material) {
  const double nu = material.poisson_ratio;
  return 4.0 * (1.0 - nu * nu) / (pi * material.youngs_modulus * face_width);
}

PairCompliance pair_compliance(const MeshingGears& gears, double position) {
  // Eq. (16): a longer line, and a force in the transverse section that is less than the normal one.
  const double hertz = hertz_compliance(gears.face_width, gears.second.material);
  return {.hertz = hertz / std::cos(gears.base_helix_angle),
          .first = gear_compliance(gears.first, position_on_first(gears, position)),
          .second = gear_compliance(gears.second, position)};
}

double contact_direction(const MeshingGears& gears) {
  // The contact moves in the sense in which the driving gear pushes: from the driven gear's tip to its root.
  return gears.first_drives ? -1.0 : 1.0;
}

double contact_begin(const MeshingGears& gears) {
  return gears.first_drives ? gears.path.end : gears.path.begin;
}

double pitch_point(const MeshingGears& gears) {
  const double second = base_radius(gears.second);
  const double first = base_radius(gears.first);
  const double position = gears.line_length * second / (internal(gears) ? first - second : first + second);
  return std::clamp(position, gears.path.begin, gears.path.end);
}

double mesh_stiffness_at(const MeshingGears& gears, double fraction) {
  double stiffness = 0.0;
  const double lasts = lasting_periods(gears);
  for (double progress = fraction; progress < lasts; progress += 1.0) {
    const double position = contact_begin(gears) + contact_direction(gears) * gears.base_pitch * progress;
    stiffness += 1.0 / pair_compliance(gears, position).sum();
  }
  return stiffness;
}

std::vector<double> contact_changes(const MeshingGears& gears) {
  const double lasts = lasting_periods(gears);
  const double leaves = lasts - std::floor(lasts);
  if (leaves == 0.0) return {0.0};
  return {0.0, leaves};
}

namespace {

// Ends of the windows in which the moving mean contains a jump of the curve, ascending.
std::vector<double> ends_of_windows(const std::vector<double>& jumps, double window) {
  constexpr double as_one = 1e-9;  // [period]
  std::vector<double> ends;
  for (const double jump : jumps)
    for (const double end : {jump - 0.5 * window, jump + 0.5 * window}) ends.push_back(end - std::floor(end));
  std::sort(ends.begin(), ends.end());
  const auto near = [](double a, double b) { return b - a < as_one; };
  ends.erase(std::unique(ends.begin(), ends.end(), near), ends.end());
  if (ends.size() > 1 && near(ends.back() - 1.0, ends.front())) ends.pop_back();
  return ends;
}

}  // namespace

PeriodicCurve across_face(const PeriodicCurve& section, double overlap_ratio, int samples) {
  constexpr double none = 1e-9;  // [period]  steeper ramps than that are jumps
  if (overlap_ratio < none) return section;
  if (std::abs(overlap_ratio - std::round(overlap_ratio)) < none)
    return PeriodicCurve::constant(section.mean());
  const auto mean = [&](double fraction) {
    return section.integral(fraction - 0.5 * overlap_ratio, fraction + 0.5 * overlap_ratio) / overlap_ratio;
  };
  return PeriodicCurve(mean, ends_of_windows(section.jumps(), overlap_ratio), samples);
}

MeshStiffness mesh_stiffness(const MeshingGears& gears, int samples) {
  const auto direct = [&gears](double fraction) { return mesh_stiffness_at(gears, fraction); };
  return {.contact_ratio = contact_ratio_of(gears),
          .curve = across_face(PeriodicCurve(direct, contact_changes(gears), samples), gears.overlap_ratio,
                               samples),
          .at_pitch_point = pair_compliance(gears, pitch_point(gears)),
          .overlap_ratio = gears.overlap_ratio};
}

}  // namespace orbearing::gearset
