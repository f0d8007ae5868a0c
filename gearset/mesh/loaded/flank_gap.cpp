#include "gearset/mesh/loaded/flank_gap.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "gearset/involute.hpp"
#include "gearset/root.hpp"

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

}  // namespace orbearing::gearset
