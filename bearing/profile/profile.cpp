#include "bearing/profile/profile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "mechanics/checks.hpp"
#include "mechanics/constants.hpp"

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

namespace {

// The leading parameter, in which the kinds differ; none of straight rollers.
double* parameter_of(Profile& profile) {
  return std::visit(
      [](auto& shape) -> double* {
        if constexpr (requires { shape.depth; })
          return &shape.depth;
        else if constexpr (requires { shape.end_drop; })
          return &shape.end_drop;
        else if constexpr (requires { shape.amplitude; })
          return &shape.amplitude;
        else if constexpr (requires { shape.scale; })
          return &shape.scale;
        else
          return nullptr;
      },
      profile);
}

[[noreturn]] void throw_no_relief(const Profile& profile) {
  throw std::invalid_argument("profile " + kind(profile) +
                              ": found no relief at the position of the required drop; required: a kind with "
                              "relief there. Choose another kind or a longer end");
}

}  // namespace

Relief relief(const Profile& profile, double x) {
  return std::visit([x](const auto& shape) { return relief_of(shape, x); }, profile);
}

double drop(const Profile& profile, double x) {
  return relief(profile, x).drop;
}

double leading_parameter(const Profile& profile) {
  Profile copy = profile;
  const double* parameter = parameter_of(copy);
  return parameter ? *parameter : 0.0;
}

Profile with_parameter(Profile profile, double value) {
  if (double* parameter = parameter_of(profile)) *parameter = value;
  return profile;
}

// All but the circular kinds are proportional to their parameter, and those nearly: a few steps of Newton's
// method from zero depth end at round-off.
Profile with_drop(const Profile& profile, double station, double depth) {
  constexpr int kSteps = 8;
  Profile deeper = with_parameter(profile, 0.0);
  if (depth == 0.0) return deeper;
  for (int i = 0; i < kSteps; ++i) {
    const Relief now = relief(deeper, station);
    if (now.per_parameter <= 0.0) throw_no_relief(profile);
    deeper = with_parameter(deeper, leading_parameter(deeper) + (depth - now.drop) / now.per_parameter);
  }
  return deeper;
}

std::string kind(const Profile& profile) {
  return std::string(described::text_of(static_cast<Kind>(profile.index())));
}

using constants::pi;

double amplitude(const DesignLoad& design) {
  return 2.0 * design.load / (pi * design.material.plane_strain_modulus() * design.length);
}

double width_ratio(const DesignLoad& design) {
  const double half_width = std::sqrt(8.0 * design.load * design.equivalent_radius /
                                      (pi * design.material.plane_strain_modulus() * design.length));
  return 2.0 * half_width / design.length;
}

Lundberg lundberg_for(const DesignLoad& design) {
  return {design.length, amplitude(design), width_ratio(design)};
}

JohnsGohar johns_gohar_for(const DesignLoad& design) {
  return {design.length, amplitude(design), width_ratio(design)};
}

FujiwaraKawase fujiwara_kawase_for(const DesignLoad& design, double k1, double k2, double end_drop) {
  return {design.length, end_drop, end_drop / (k1 * amplitude(design)), k2};
}

// The end's width changes the logarithm little, so that each step of the iteration loses most of the error.
double design_load_of_drop(DesignLoad design, double drop) {
  constexpr int kSteps = 60;
  const double station = kDropPosition * 0.5 * design.length;
  design.load = drop * design.material.plane_strain_modulus() * design.length;
  for (int i = 0; i < kSteps; ++i) {
    const double now = profile::drop(johns_gohar_for(design), station);
    if (!(now > 0.0)) break;
    design.load *= drop / now;
  }
  return design.load;
}

namespace {

using mechanics::require;
using mechanics::require_not_negative;

// Parameters of each kind besides its length, depth or amplitude, and leading parameter.
template <class Shape>
void check(const Shape&) {}

void check(const Chamfer& profile) {
  require(profile.chamfer_length > 0.0 && profile.chamfer_length <= 0.5 * profile.length,
          "chamfer length of a profile [m]", profile.chamfer_length, "above 0, at most half the length");
}

void check(const CircularCrown& profile) {
  require(profile.end_drop < 0.5 * profile.length, "end drop of a profile [m]", profile.end_drop,
          "less than half the length");
}

void check(const StraightCircular& profile) {
  require(profile.straight_length >= 0.0 && profile.straight_length < profile.length,
          "straight length of a profile [m]", profile.straight_length, "at least 0, less than the length");
  require(profile.end_drop < 0.5 * (profile.length - profile.straight_length), "end drop of a profile [m]",
          profile.end_drop, "less than the length of a curved end");
}

void check(const Iso16281& profile) {
  require(std::isfinite(profile.diameter) && profile.diameter > 0.0, "roller diameter of a profile [m]",
          profile.diameter, "a length above 0");
}

void check(const FujiwaraKawase& profile) {
  require(std::isfinite(profile.steepness) && profile.steepness > 0.0,
          "end drop over amplitude of a profile [-]", profile.steepness, "a ratio above 0");
  require(profile.crowned_fraction > 0.0 && profile.crowned_fraction <= 1.0,
          "crowned fraction of a profile [-]", profile.crowned_fraction, "above 0, at most 1");
}

void check(const Table& profile) {
  const std::size_t n = profile.x.size();
  require(n >= 2 && n == profile.drop.size(), "number of points of a profile", static_cast<double>(n),
          "at least 2, with as many drops");
  for (std::size_t i = 0; i < n; ++i) {
    require(std::isfinite(profile.x[i]) && (i == 0 || profile.x[i] > profile.x[i - 1]),
            "point of a profile [m]", profile.x[i], "finite positions in ascending order");
    require_not_negative(profile.drop[i], "drop of a profile [m]");
  }
}

}  // namespace

void require_sound(const Profile& profile) {
  std::visit(
      [](const auto& shape) {
        if constexpr (requires { shape.length; })
          mechanics::require_positive(shape.length, "length of a profile [m]");
        if constexpr (requires { shape.depth; }) require_not_negative(shape.depth, "depth of a profile [m]");
        if constexpr (requires { shape.end_drop; })
          require_not_negative(shape.end_drop, "end drop of a profile [m]");
        if constexpr (requires { shape.amplitude; })
          require_not_negative(shape.amplitude, "amplitude of a profile [m]");
        if constexpr (requires { shape.scale; }) require_not_negative(shape.scale, "scale of a profile [-]");
        if constexpr (requires { shape.width_ratio; })
          require(shape.width_ratio > 0.0 && shape.width_ratio < 1.0,
                  "width over length of a profile's contact [-]", shape.width_ratio,
                  "a ratio above 0 and below 1: the design load of the profile is zero or too high");
        check(shape);
      },
      profile);
}

}  // namespace orbearing::bearing::profile
