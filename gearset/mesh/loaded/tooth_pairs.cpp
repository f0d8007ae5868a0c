#include "gearset/mesh/loaded/tooth_pairs.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "gearset/involute.hpp"
#include "gearset/mesh/iso6336.hpp"
#include "gearset/mesh/loaded/transmission_error.hpp"
#include "gearset/warning.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::gearset {

namespace {

bool is_internal(const MeshingGears& gears) {
  return std::holds_alternative<RingTooth>(gears.first.tooth);
}

// Polar angle that an involute falls behind that of its foot, by the tangent length.
double behind_foot(double tangent, double base) {
  return tangent / base - std::atan(tangent / base);
}

struct TangentRange {
  double foot = 0.0;  // [m]  where the involute begins
  double tip = 0.0;   // [m]
};

TangentRange range_of(const MeshGear& gear) {
  if (const auto* ring = std::get_if<RingTooth>(&gear.tooth))
    return {tangent_length(ring->base_radius, ring->root_radius),
            tangent_length(ring->base_radius, std::max(ring->tip_radius, ring->base_radius))};
  const auto& tooth = std::get<ExternalTooth>(gear.tooth);
  return {tangent_length(tooth.base_radius, tooth.form_radius),
          tangent_length(tooth.base_radius, tooth.tip_radius)};
}

double on_first(const MeshingGears& gears, double position) {
  return is_internal(gears) ? gears.line_length + position : gears.line_length - position;
}

// Axes with the line of action along y and the tangent point of each gear on x at its base radius; those of
// the first gear look the other way in an external mesh.
Eigen::Vector2d from_first_to_second(const MeshingGears& gears, const Eigen::Vector2d& point) {
  const double r1 = base_radius(gears.first), r2 = base_radius(gears.second), line = gears.line_length;
  if (is_internal(gears)) return point + Eigen::Vector2d(r2 - r1, -line);
  return Eigen::Vector2d(r1 + r2, line) - point;
}

Eigen::Vector2d from_second_to_first(const MeshingGears& gears, const Eigen::Vector2d& point) {
  const double r1 = base_radius(gears.first), r2 = base_radius(gears.second), line = gears.line_length;
  if (is_internal(gears)) return point - Eigen::Vector2d(r2 - r1, -line);
  return Eigen::Vector2d(r1 + r2, line) - point;
}

// Eq. (1): the edge, in the axes of the other gear; its own gear turned on by `turned` [m] at the base
// circle.
Eigen::Vector2d edge_point(const MeshingGears& gears, const EdgeAtEnd& edge, double position, double turned) {
  const double base = base_radius(edge.of_first ? gears.first : gears.second);
  const double own = (edge.of_first ? on_first(gears, position) : position) + turned;
  const double angle = own / base - behind_foot(edge.tangent, base);
  const Eigen::Vector2d point =
      std::hypot(base, edge.tangent) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  return edge.of_first ? from_first_to_second(gears, point) : from_second_to_first(gears, point);
}

// Polar angle of a flank behind the direction of its tangent point, where it touches at `own`: involute, and
// below the form circle of an external gear the trochoid.
double flank_angle(const MeshGear& gear, double own, double radius) {
  const double base = base_radius(gear);
  if (const auto* tooth = std::get_if<ExternalTooth>(&gear.tooth))
    return own / base - base_half_angle(*tooth) +
           half_thickness_angle(*tooth, std::max(radius, tooth->root_radius));
  return own / base - behind_foot(std::sqrt(std::max(0.0, radius * radius - base * base)), base);
}

struct GapOnMate {
  double gap = 0.0;     // [m]
  double radius = 0.0;  // [m]  where the edge meets the other gear
};

// Eqs. (2) and (3).
GapOnMate gap_on_mate(const MeshingGears& gears, const EdgeAtEnd& edge, double position,
                      double turned = 0.0) {
  const MeshGear& mate = edge.of_first ? gears.second : gears.first;
  const double own = edge.of_first ? position : on_first(gears, position);
  const Eigen::Vector2d point = edge_point(gears, edge, position, turned);
  const double radius = point.norm();
  const double turn = std::atan2(point.y(), point.x()) - flank_angle(mate, own, radius);
  const bool concave = !edge.of_first && is_internal(gears);
  return {(concave ? -turn : turn) * base_radius(mate), radius};
}

// The gap of a foot by which its own gear turns: where the tip of the other takes over, that gear has turned
// as far in both counts.
GapOnMate gap_of_foot(const MeshingGears& gears, const EdgeAtEnd& foot, double position) {
  constexpr int steps = 4;  // of the secant rule, on what is a straight line but for a part in thirty
  const double sense = foot.of_first && is_internal(gears) ? -1.0 : 1.0;
  double before = 0.0, left_before = gap_on_mate(gears, foot, position).gap;
  double turned = left_before;
  GapOnMate now = gap_on_mate(gears, foot, position, sense * turned);
  for (int i = 0; i < steps && now.gap != left_before; ++i) {
    const double next = turned - now.gap * (turned - before) / (now.gap - left_before);
    before = turned;
    left_before = now.gap;
    turned = next;
    now = gap_on_mate(gears, foot, position, sense * turned);
  }
  return {turned, now.radius};
}

double radius_of_point(const MeshGear& gear, double tangent) {
  return std::hypot(base_radius(gear), tangent);
}

// Tangent length at a radius on the involute; that of its foot below.
double tangent_at(const MeshGear& gear, double radius) {
  const TangentRange range = range_of(gear);
  const double base = base_radius(gear);
  const double tangent = std::sqrt(std::max(0.0, radius * radius - base * base));
  return std::clamp(tangent, std::min(range.foot, range.tip), std::max(range.foot, range.tip));
}

FlankGap touching(const MeshingGears& gears, const EdgeAtEnd& edge, const GapOnMate& found) {
  const MeshGear& mate = edge.of_first ? gears.second : gears.first;
  const double on_mate = tangent_at(mate, found.radius);
  const bool external = std::holds_alternative<ExternalTooth>(mate.tooth);
  return {std::max(0.0, found.gap), edge.of_first ? edge.tangent : on_mate,
          edge.of_first ? on_mate : edge.tangent,
          !external || found.radius >= radius_of_point(mate, range_of(mate).foot)};
}

// Tips reach the beginning of an external mesh with the first gear's, its end with the second's; in an
// internal one the ring's tip is at the beginning.
EdgeAtEnd tip_at(const MeshingGears& gears, PathEnd end) {
  const bool of_first = end == PathEnd::begin;
  return {of_first, range_of(of_first ? gears.first : gears.second).tip};
}

EdgeAtEnd foot_at(const MeshingGears& gears, PathEnd end) {
  const bool of_first = end == PathEnd::end;
  return {of_first, range_of(of_first ? gears.first : gears.second).foot};
}

double position_of_edge(const MeshingGears& gears, const EdgeAtEnd& edge) {
  if (!edge.of_first) return edge.tangent;
  return is_internal(gears) ? edge.tangent - gears.line_length : gears.line_length - edge.tangent;
}

}  // namespace

EdgeAtEnd edge_at(const MeshingGears& gears, PathEnd end) {
  const EdgeAtEnd tip = tip_at(gears, end), foot = foot_at(gears, end);
  const double sense = end == PathEnd::begin ? -1.0 : 1.0;
  return sense * (position_of_edge(gears, foot) - position_of_edge(gears, tip)) < 0.0 ? foot : tip;
}

double tip_takes_over(const MeshingGears& gears, PathEnd end) {
  const double from = end == PathEnd::begin ? gears.path.begin : gears.path.end;
  const double sense = end == PathEnd::begin ? -1.0 : 1.0;
  const EdgeAtEnd tip = tip_at(gears, end), foot = edge_at(gears, end);
  if (foot.of_first == tip.of_first) return from;
  const MeshGear& mate = foot.of_first ? gears.second : gears.first;
  const double outward = std::holds_alternative<RingTooth>(mate.tooth) ? -1.0 : 1.0;
  // By how much the flank of the gear with the tip goes on beyond the foot of the other.
  const auto beyond = [&](double distance) {
    const double at = gap_of_foot(gears, foot, from + sense * distance).radius;
    return outward * (radius_of_point(mate, tip.tangent) - at);
  };
  const double most = gears.base_pitch;
  return from + sense * (beyond(most) < 0.0 ? bracketed_root(beyond, 0.0, most) : most);
}

FlankGap flank_gap(const MeshingGears& gears, double position) {
  if (position >= gears.path.begin && position <= gears.path.end)
    return {0.0, on_first(gears, position), position};
  const PathEnd end = position < gears.path.begin ? PathEnd::begin : PathEnd::end;
  const double tip_from = tip_takes_over(gears, end);
  const bool by_tip = end == PathEnd::begin ? position <= tip_from : position >= tip_from;
  const EdgeAtEnd edge = by_tip ? tip_at(gears, end) : edge_at(gears, end);
  return touching(gears, edge,
                  by_tip ? gap_on_mate(gears, edge, position) : gap_of_foot(gears, edge, position));
}

namespace {

using constants::pi;

constexpr double kReach = 0.1;          // [module]  gap up to which a pair is looked at: tenfold usual loads
constexpr int kSamplesPerPeriod = 128;  // error of the tables below 1e-6 of their values

struct Window {
  double begin = 0.0;  // [mesh period]
  double end = 0.0;
};

double position_of(const MeshingGears& gears, double progress) {
  return contact_begin(gears) + contact_direction(gears) * gears.base_pitch * progress;
}

double pair_stiffness(const MeshingGears& gears, double progress, double shared) {
  const FlankGap touch = flank_gap(gears, position_of(gears, progress));
  const double hertz =
      hertz_compliance(gears.face_width, gears.second.material) / std::cos(gears.base_helix_angle);
  const double all = hertz + gear_compliance(gears.first, touch.first).sum() +
                     gear_compliance(gears.second, touch.second).sum();
  if (!(all > shared))
    throw std::domain_error(
        "the bodies of a pair of gears turn by more than their teeth deflect in all; widen a bore that is "
        "narrow, or take gearset.tooth_contact: stepped");
  return 1.0 / (all - shared);
}

// Progress beyond an end of the path at which the gap grows to `reach`, at most one base pitch.
double beyond(const MeshingGears& gears, double end, double sense, double reach) {
  const auto excess = [&](double distance) {
    return flank_gap(gears, position_of(gears, end + sense * distance)).gap - reach;
  };
  return excess(1.0) > 0.0 ? bracketed_root(excess, 0.0, 1.0) : 1.0;
}

double gap_with_relief(const MeshingGears& gears, const MeshModifications& by, double progress) {
  const FlankGap touch = flank_gap(gears, position_of(gears, progress));
  return touch.gap + relief_at(gears.first, by.first, touch.first) +
         relief_at(gears.second, by.second, touch.second);
}

double tip_tangent(const MeshGear& gear) {
  return std::visit(
      [](const auto& tooth) {
        return tangent_length(tooth.base_radius, std::max(tooth.tip_radius, tooth.base_radius));
      },
      gear.tooth);
}

// Corners of the curves, as shares of the window, ascending from 0 on.
std::vector<double> corners(const MeshingGears& gears, const MeshModifications& by, const Window& window) {
  std::vector<double> positions{window.begin};
  const auto add_position = [&](double position) {
    positions.push_back((position - contact_begin(gears)) * contact_direction(gears) / gears.base_pitch);
  };
  for (const double position : {gears.path.begin, gears.path.end, tip_takes_over(gears, PathEnd::begin),
                                tip_takes_over(gears, PathEnd::end)})
    add_position(position);
  const auto add = [&](const MeshGear& gear, const TipRelief& relief, bool first) {
    if (relief.amount == 0.0) return;
    const bool ring = std::holds_alternative<RingTooth>(gear.tooth);
    const double own = tip_tangent(gear) + (ring ? relief.length : -relief.length);
    const double position = !first ? own : ring ? own - gears.line_length : gears.line_length - own;
    add_position(position);
  };
  add(gears.first, by.first, true);
  add(gears.second, by.second, false);
  std::vector<double> shares;
  for (const double position : positions)
    shares.push_back((position - window.begin) / (window.end - window.begin));
  std::sort(shares.begin(), shares.end());
  std::vector<double> apart;
  for (const double share : shares)
    if (share >= 0.0 && share < 1.0 - 1e-6 && (apart.empty() || share > apart.back() + 1e-6))
      apart.push_back(share);
  return apart;
}

std::vector<FaceSlice> slices_of(const MeshingGears& gears, const MeshModifications& by, int slices) {
  if (gears.overlap_ratio == 0.0 && by.crown == 0.0 && by.slope == 0.0) return {FaceSlice{}};
  std::vector<FaceSlice> all;
  for (int i = 0; i < slices; ++i) {
    const double z = (i + 0.5) / slices - 0.5;  // [face width]
    all.push_back(
        {z * gears.overlap_ratio, 4.0 * by.crown * z * z + by.slope * z + 0.5 * std::abs(by.slope)});
  }
  return all;
}

double sound_deflection(const MeshingGears& gears, const MeshModifications& by, const Window& window) {
  constexpr int samples = 200;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= samples; ++i) {
    const double progress = std::lerp(window.begin, window.end, double(i) / samples);
    if (!flank_gap(gears, position_of(gears, progress)).on_involute)
      least = std::min(least, gap_with_relief(gears, by, progress));
  }
  return least;
}

// Modifications of a planet and its mate.
MeshModifications with_planet(const FlankModifications& set, double module, double relief, double crown,
                              double slope) {
  const double length = set.relief_length * module;
  return {{relief, length, set.relief_form},
          {set.planet_relief, length, set.relief_form},
          crown + set.planet_crown,
          slope};
}

}  // namespace

MeshModifications sun_mesh_modifications(const FlankModifications& set, double module) {
  return with_planet(set, module, set.sun_relief, set.sun_crown, set.sun_slope);
}

MeshModifications ring_mesh_modifications(const FlankModifications& set, double module) {
  return with_planet(set, module, set.ring_relief, set.ring_crown, set.ring_slope);
}

double body_torsion(const MeshGear& gear) {
  const double base = base_radius(gear), root = gear.body.root_radius, held = gear.body.body_radius;
  const double between = std::abs(1.0 / (held * held) - 1.0 / (root * root));
  return base * base * between / (4.0 * pi * gear.material.shear_modulus() * gear.face_width);
}

double relief_at(const MeshGear& gear, const TipRelief& relief, double tangent) {
  if (relief.amount == 0.0) return 0.0;
  const double inward = std::holds_alternative<RingTooth>(gear.tooth) ? -1.0 : 1.0;
  const double from_tip = inward * (tip_tangent(gear) - tangent);
  const double share = std::clamp(1.0 - from_tip / relief.length, 0.0, 1.0);
  return relief.amount * (relief.form == ReliefForm::linear ? share : share * share);
}

ToothPairs tooth_pairs(const MeshingGears& gears, const MeshModifications& by, int slices) {
  const double shared = body_torsion(gears.first) + body_torsion(gears.second);
  const double ratio = gears.path.length() / gears.base_pitch;
  const double reach = kReach * std::get<ExternalTooth>(gears.second.tooth).module;
  const Window window{-beyond(gears, 0.0, -1.0, reach), ratio + beyond(gears, ratio, 1.0, reach)};
  const std::vector<double> jumps = corners(gears, by, window);
  const double width = window.end - window.begin;
  const int samples = static_cast<int>(std::ceil(kSamplesPerPeriod * width));
  // Both curves are continuous at their corners, next to which the table takes its samples.
  const auto at_corner = [&](double share) {
    constexpr double beside = 2e-9;  // [window]
    for (const double corner : jumps)
      if (std::abs(share - corner) < beside) return corner;
    return share > 1.0 - beside ? 1.0 : share;
  };
  const auto over_window = [&](const auto& function) {
    return PeriodicCurve([&](double share) { return function(window.begin + width * at_corner(share)); },
                         jumps, samples);
  };
  return {LoadedTeeth(over_window([&](double progress) { return pair_stiffness(gears, progress, shared); }),
                      over_window([&](double progress) { return gap_with_relief(gears, by, progress); }),
                      window.begin, window.end, shared, slices_of(gears, by, slices)),
          sound_deflection(gears, by, window)};
}

SetTeeth set_teeth(const PlanetarySet& set, const PlanetaryMeshes& meshes) {
  SetTeeth teeth{tooth_pairs(meshes.sun_gears, sun_mesh_modifications(set.flanks, set.module)),
                 tooth_pairs(meshes.ring_gears, ring_mesh_modifications(set.flanks, set.module))};
  if (set.web.thickness)
    for (ToothPairs* pairs : {&teeth.sun, &teeth.ring})
      pairs->teeth = pairs->teeth.times(web_factor(set.web));
  return teeth;
}

Warnings edge_warnings(const SetTeeth& teeth, double force) {
  Warnings warnings;
  const auto consider = [&](const ToothPairs& pairs, const std::string& name) {
    const std::vector<double> curve = transmission_error(pairs.teeth, force).curve;
    const double own = *std::max_element(curve.begin(), curve.end()) - pairs.teeth.shared() * force;
    if (own <= pairs.sound) return;
    warnings.push_back(
        {"gearset.tooth_contact",
         "teeth of " + name + " and planet deflect by up to " + decimal(1e6 * own, 1) + " um; from " +
             decimal(1e6 * pairs.sound, 1) +
             " um on a tip touches the fillet of the other gear's root, where the direction of the force is "
             "not that of the line of action; it is taken as if it were"});
  };
  consider(teeth.sun, "sun");
  consider(teeth.ring, "ring");
  return warnings;
}

}  // namespace orbearing::gearset
