#include "gearset/tooth_form.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>

#include "gearset/involute.hpp"
#include "gearset/warning.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::gearset {

namespace {

using constants::pi;

RackFillet rack_fillet(double shift, double module, const BasicRack& rack, double cos_helix) {
  const double centre_below_datum = rack.addendum + rack.clearance - rack.root_fillet_radius;
  RackFillet fillet;
  fillet.radius = module * rack.root_fillet_radius;
  fillet.centre_depth = module * (centre_below_datum - shift);
  fillet.centre_offset = module *
                         (pi / 4.0 - centre_below_datum * std::tan(rack.pressure_angle) -
                          rack.root_fillet_radius / std::cos(rack.pressure_angle)) /
                         cos_helix;
  fillet.end_angle = pi / 2.0 - rack.pressure_angle;
  fillet.cos_helix = cos_helix;
  if (fillet.centre_offset < 0.0) {
    throw std::domain_error(
        "the root fillet radius does not fit on the tip of the rack; choose a smaller one");
  }
  return fillet;
}

// Angle of the tooth of an external gear with these data, or of the space in a ring.
template <typename Tooth>
double rack_cut_base_half_angle(const Tooth& tooth) {
  const double at_pitch_circle =
      (pi / 2.0 + 2.0 * tooth.shift * std::tan(tooth.normal_pressure_angle)) / tooth.teeth;
  return at_pitch_circle + involute(tooth.pressure_angle);
}

double involute_half_angle(const ExternalTooth& tooth, double radius) {
  return base_half_angle(tooth) - involute(pressure_angle_at(tooth.base_radius, radius));
}

double trochoid_half_angle(const ExternalTooth& tooth, double radius) {
  return trochoid_point(tooth, trochoid_normal_angle(tooth, radius)).half_angle;
}

// End of the straight flank of the rack on the line of action, from the tangent point on the base circle;
// negative when the rack reaches beyond that point and cuts the involute's foot away. Eq. (10).
double rack_flank_end(const ExternalTooth& tooth) {
  const double sine = std::sin(tooth.pressure_angle);
  const double depth =
      tooth.fillet.centre_depth + tooth.fillet.radius * std::sin(tooth.normal_pressure_angle);
  return tooth.pitch_radius * sine - depth / sine;
}

// Just below the limit of undercut the crossing lies so close above the base circle that the angles of both
// curves differ by round-off only; any radius between is then the form radius.
constexpr double undercut_resolution = 1e-8;  // relative

double undercut_form_radius(const ExternalTooth& tooth) {
  const auto overhang = [&tooth](double radius) {
    return trochoid_half_angle(tooth, radius) - involute_half_angle(tooth, radius);
  };
  const double low = std::max(tooth.base_radius, tooth.root_radius);
  const double high = trochoid_point(tooth, tooth.fillet.end_angle).radius;
  if (high - low <= undercut_resolution * low) return high;
  if (!(overhang(low) < 0.0 && overhang(high) > 0.0)) {
    throw std::domain_error("the undercut root does not meet the involute; change the profile shift");
  }
  return bracketed_root(overhang, low, high);
}

double find_form_radius(const ExternalTooth& tooth) {
  if (tooth.undercut) return undercut_form_radius(tooth);
  return std::hypot(tooth.base_radius, rack_flank_end(tooth));
}

// Eqs. (31) and (33). Common data of external gears and rings.
template <typename Tooth>
Tooth reference_tooth(int teeth, double shift, double module, const BasicRack& rack, double helix_angle) {
  assert(teeth > 0 && module > 0.0);
  Tooth tooth;
  tooth.teeth = teeth;
  tooth.module = module;
  tooth.normal_pressure_angle = rack.pressure_angle;
  tooth.helix_angle = std::abs(helix_angle);
  tooth.pressure_angle = transverse_pressure_angle(rack.pressure_angle, helix_angle);
  tooth.shift = shift;
  tooth.pitch_radius = 0.5 * module * teeth / std::cos(helix_angle);
  tooth.base_radius = tooth.pitch_radius * std::cos(tooth.pressure_angle);
  return tooth;
}

}  // namespace

double transverse_pressure_angle(double normal_pressure_angle, double helix_angle) {
  if (helix_angle == 0.0) return normal_pressure_angle;  // to the last bit
  return std::atan(std::tan(normal_pressure_angle) / std::cos(helix_angle));
}

double base_helix_angle(double normal_pressure_angle, double helix_angle) {
  return std::asin(std::sin(helix_angle) * std::cos(normal_pressure_angle));
}

double overlap_ratio(double face_width, double module, double helix_angle) {
  return face_width * std::abs(std::sin(helix_angle)) / (pi * module);
}

ExternalTooth make_external_tooth(int teeth, double shift, double module, const BasicRack& rack,
                                  double helix_angle) {
  auto tooth = reference_tooth<ExternalTooth>(teeth, shift, module, rack, helix_angle);
  tooth.tip_radius = tooth.pitch_radius + module * (rack.addendum + shift);
  tooth.root_radius = tooth.pitch_radius - module * (rack.addendum + rack.clearance - shift);
  if (tooth.root_radius <= 0.0) {
    throw std::domain_error("the root circle of a gear vanishes; raise its number of teeth or profile shift");
  }
  tooth.fillet = rack_fillet(shift, module, rack, std::cos(helix_angle));
  tooth.undercut = rack_flank_end(tooth) < 0.0;
  tooth.form_radius = find_form_radius(tooth);
  if (tooth.form_radius >= tooth.tip_radius) {
    throw std::domain_error(
        "no involute is left between the root fillet and the tip of a tooth; raise its profile shift");
  }
  return tooth;
}

RingTooth make_ring_tooth(int teeth, double shift, double module, const BasicRack& rack, double helix_angle) {
  auto tooth = reference_tooth<RingTooth>(teeth, shift, module, rack, helix_angle);
  tooth.tip_radius = tooth.pitch_radius - module * (rack.addendum - shift);
  tooth.root_radius = tooth.pitch_radius + module * (rack.addendum + rack.clearance + shift);
  return tooth;
}

double half_thickness_angle(const ExternalTooth& tooth, double radius) {
  return radius < tooth.form_radius ? trochoid_half_angle(tooth, radius) : involute_half_angle(tooth, radius);
}

double half_thickness_angle(const RingTooth& tooth, double radius) {
  const double working = pressure_angle_at(tooth.base_radius, std::max(radius, tooth.base_radius));
  return pi / tooth.teeth - (rack_cut_base_half_angle(tooth) - involute(working));
}

double base_half_angle(const ExternalTooth& tooth) {
  return rack_cut_base_half_angle(tooth);
}

double base_half_angle(const RingTooth& tooth) {
  return pi / tooth.teeth - rack_cut_base_half_angle(tooth);
}

double least_shift_without_undercut(const ExternalTooth& tooth) {
  return tooth.shift - rack_flank_end(tooth) * std::sin(tooth.pressure_angle) / tooth.module;
}

double half_thickness(const ExternalTooth& tooth, double radius) {
  return radius * std::sin(half_thickness_angle(tooth, radius));
}

TrochoidPoint trochoid_point(const ExternalTooth& tooth, double normal_angle) {
  const RackFillet& fillet = tooth.fillet;
  const double sine = std::sin(normal_angle);
  const double cosine = std::cos(normal_angle);
  // The normal in the transverse section is steeper than that of the circle by cos(helix): tan = tan chi cos.
  const double flat = fillet.cos_helix, stretch = 1.0 / flat - flat;
  const double roll = flat * (fillet.centre_depth * sine / cosine);  // [m]
  const double x = roll + flat * (fillet.radius * sine);
  const double y = tooth.pitch_radius - fillet.centre_depth - fillet.radius * cosine;
  const double middle =
      roll - fillet.centre_offset - stretch * fillet.radius * sine;  // [m] of the rack's tooth
  const double from_space = std::atan2(x, y) - middle / tooth.pitch_radius;
  TrochoidPoint point;
  point.radius = std::hypot(x, y);
  point.half_angle = pi / tooth.teeth - from_space;
  const double roll_slope = flat * (fillet.centre_depth / (cosine * cosine));  // [m/rad]
  const double x_slope = roll_slope + flat * (fillet.radius * cosine);         // [m/rad]
  const double y_slope = fillet.radius * sine;                                 // [m/rad]
  const double middle_slope = roll_slope - stretch * fillet.radius * cosine;   // [m/rad]
  point.radius_slope = (x * x_slope + y * y_slope) / point.radius;
  point.half_angle_slope =
      middle_slope / tooth.pitch_radius - (y * x_slope - x * y_slope) / (point.radius * point.radius);
  return point;
}

double trochoid_normal_angle(const ExternalTooth& tooth, double radius) {
  const double end = tooth.fillet.end_angle;
  if (radius <= tooth.root_radius) return 0.0;
  if (radius >= trochoid_point(tooth, end).radius) return end;
  return bracketed_root(
      [&tooth, radius](double angle) { return trochoid_point(tooth, angle).radius - radius; }, 0.0, end);
}

std::vector<Eigen::Vector2d> flank_points(const ExternalTooth& tooth, int points_per_part) {
  assert(points_per_part >= 2);
  const double trochoid_end = trochoid_normal_angle(tooth, tooth.form_radius);
  const double first_tangent = tangent_length(tooth.base_radius, tooth.form_radius);
  const double last_tangent = tangent_length(tooth.base_radius, tooth.tip_radius);
  std::vector<Eigen::Vector2d> points;
  const auto add = [&points](double radius, double angle) {
    points.emplace_back(radius * std::sin(angle), radius * std::cos(angle));
  };
  for (int i = 0; i < points_per_part; ++i) {
    const TrochoidPoint point = trochoid_point(tooth, trochoid_end * i / (points_per_part - 1));
    add(point.radius, point.half_angle);
  }
  // Equal steps of the tangent length are equal steps of roll, the flank's natural parameter; the first point
  // is the trochoid's last one.
  for (int i = 1; i < points_per_part; ++i) {
    const double tangent = std::lerp(first_tangent, last_tangent, double(i) / (points_per_part - 1));
    const double radius = std::hypot(tooth.base_radius, tangent);
    add(radius, involute_half_angle(tooth, radius));
  }
  return points;
}

namespace {

// Gears that just reach the end of an involute are sound; this keeps round-off from warning about them.
constexpr double reach_tolerance = 1e-9;  // [module]

}  // namespace

void ToothWarnings::undercut(const ExternalTooth& tooth, const std::string& gear) {
  if (!tooth.undercut) return;
  list.push_back({position, "the " + gear + " is undercut: its profile shift " + decimal(tooth.shift, 4) +
                                " lies below the limit " + decimal(least_shift_without_undercut(tooth), 4) +
                                ". Its involute begins at a radius of " + millimetres(tooth.form_radius) +
                                " (base circle " + millimetres(tooth.base_radius) +
                                ") and the path of contact ends there"});
}

void ToothWarnings::reach(double reached, const ExternalTooth& tooth, const std::string& other,
                          const std::string& gear) {
  const double foot = tangent_length(tooth.base_radius, tooth.form_radius);
  const double tolerance = reach_tolerance * tooth.module;
  if (reached >= foot - tolerance) return;
  const std::string limit =
      reached < -tolerance ? "base circle, where there is no involute" : "form circle, into the root fillet";
  list.push_back({position, "the tips of the " + other + " reach below the " + gear + "'s " + limit +
                                ". The path of contact ends at the " + gear + "'s form radius " +
                                millimetres(tooth.form_radius) +
                                ", and the tips require relief or a smaller addendum"});
}

void ToothWarnings::clearance(double clearance, double module, const std::string& tip,
                              const std::string& root) {
  if (clearance >= -reach_tolerance * module) return;
  list.push_back({position, "the tips of the " + tip + " interfere with the roots of the " + root + " by " +
                                millimetres(-clearance) + "; raise the clearance or change the shifts"});
}

void ToothWarnings::contact_ratio(double ratio, const std::string& mesh) {
  if (ratio >= 1.0) return;
  list.push_back({position, "the contact ratio of the " + mesh + " is " + decimal(ratio, 3) +
                                "; at least 1 is needed for continuous drive"});
}

}  // namespace orbearing::gearset
