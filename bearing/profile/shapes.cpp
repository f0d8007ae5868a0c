#include "bearing/profile/shapes.hpp"

#include <algorithm>
#include <numbers>
#include <cmath>

namespace orbearing::bearing::profile {

namespace {

// From the middle [m], at most half the length.
double distance_of(double x, double length) {
  return std::min(std::abs(x), 0.5 * length);
}

// Circular arc of curvature 2 P/(a^2 + P^2) that drops by P over the length a, at distance s from its top.
Relief arc(double s, double a, double end_drop) {
  const double square_sum = a * a + end_drop * end_drop;
  const double curvature = 2.0 * end_drop / square_sum;
  const double by_end_drop = 2.0 * (a * a - end_drop * end_drop) / (square_sum * square_sum);
  const double cosine = std::sqrt(1.0 - curvature * curvature * s * s);
  return {curvature * s * s / (1.0 + cosine), s * s / (cosine * (1.0 + cosine)) * by_end_drop};
}

// -A ln(1 - f u^2) and its derivative by A.
Relief logarithm(double amplitude, double factor, double u) {
  const double left = -std::log1p(-factor * u * u);
  return {amplitude * left, left};
}

}  // namespace

double end_drop_factor(double width_ratio) {
  return 0.5 + std::numbers::ln2 - std::log(width_ratio);
}

Relief relief_of(const Straight&, double) {
  return {};
}

Relief relief_of(const Chamfer& profile, double x) {
  const double beyond = distance_of(x, profile.length) - (0.5 * profile.length - profile.chamfer_length);
  if (beyond <= 0.0) return {};
  const double share = beyond / profile.chamfer_length;
  return {profile.depth * share, share};
}

Relief relief_of(const CircularCrown& profile, double x) {
  return arc(distance_of(x, profile.length), 0.5 * profile.length, profile.end_drop);
}

Relief relief_of(const StraightCircular& profile, double x) {
  const double beyond = distance_of(x, profile.length) - 0.5 * profile.straight_length;
  if (beyond <= 0.0) return {};
  return arc(beyond, 0.5 * (profile.length - profile.straight_length), profile.end_drop);
}

Relief relief_of(const Lundberg& profile, double x) {
  const double end = end_drop_factor(profile.width_ratio);
  const double u = distance_of(x, profile.length) * (2.0 / profile.length);
  if (1.0 - u * u <= std::exp(-end)) return {profile.amplitude * end, end};
  return logarithm(profile.amplitude, 1.0, u);
}

Relief relief_of(const JohnsGohar& profile, double x) {
  constexpr double kEnd = 0.3033;  // exp(-1/2)/2 = 0.30327, rounded as in the source
  return logarithm(profile.amplitude, 1.0 - kEnd * profile.width_ratio,
                   distance_of(x, profile.length) * (2.0 / profile.length));
}

Relief relief_of(const Iso16281& profile, double x) {
  constexpr double kLast = 1.0 - 1e-6;
  const double distance = distance_of(x, profile.length);
  const bool is_long = profile.length > 2.5 * profile.diameter;
  const double straight = is_long ? 0.5 * profile.length - 1.25 * profile.diameter : 0.0;
  const double crowned = 0.5 * profile.length - straight;
  if (distance <= straight) return {};
  const double factor = (is_long ? 0.0005 : 0.00035) * profile.diameter;
  const double u = (distance - straight) / crowned;
  Relief result = logarithm(profile.scale * factor, 1.0, std::min(u, kLast));
  result.per_parameter *= factor;
  return result;
}

Relief relief_of(const FujiwaraKawase& profile, double x) {
  const double crowned = 0.5 * profile.length * profile.crowned_fraction;
  const double beyond = distance_of(x, profile.length) - (0.5 * profile.length - crowned);
  if (beyond <= 0.0) return {};
  Relief result = logarithm(profile.end_drop / profile.steepness, -std::expm1(-profile.steepness),
                            std::min(beyond / crowned, 1.0));
  result.per_parameter /= profile.steepness;
  return result;
}

Relief relief_of(const Table& profile, double x) {
  if (x <= profile.x.front()) return {profile.scale * profile.drop.front(), profile.drop.front()};
  if (x >= profile.x.back()) return {profile.scale * profile.drop.back(), profile.drop.back()};
  const auto above = std::upper_bound(profile.x.begin(), profile.x.end(), x);
  const auto i = static_cast<std::size_t>(above - profile.x.begin());
  const double share = (x - profile.x[i - 1]) / (profile.x[i] - profile.x[i - 1]);
  const double value = profile.drop[i - 1] + share * (profile.drop[i] - profile.drop[i - 1]);
  return {profile.scale * value, value};
}

}  // namespace orbearing::bearing::profile
