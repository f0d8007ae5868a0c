#include <cmath>

#include "bearing/profile/profile.hpp"
#include "mechanics/checks.hpp"

namespace orbearing::bearing::profile {

namespace {

using mechanics::require;

void require_length(double length) {
  mechanics::require_positive(length, "length of a profile [m]");
}

void require_depth(const char* what, double depth) {
  mechanics::require_not_negative(depth, what);
}

void require_width(double ratio) {
  require(ratio > 0.0 && ratio < 1.0, "width over length of a profile's contact [-]", ratio,
          "a ratio above 0 and below 1: the load a profile is laid out for is zero or too high");
}

void check(const Straight&) {}

void check(const Chamfer& profile) {
  require_length(profile.length);
  require(profile.chamfer_length > 0.0 && profile.chamfer_length <= 0.5 * profile.length,
          "chamfer length of a profile [m]", profile.chamfer_length, "above 0, at most half the length");
  require_depth("depth of a profile [m]", profile.depth);
}

void check(const CircularCrown& profile) {
  require_length(profile.length);
  require_depth("end drop of a profile [m]", profile.end_drop);
  require(profile.end_drop < 0.5 * profile.length, "end drop of a profile [m]", profile.end_drop,
          "less than half the length");
}

void check(const StraightCircular& profile) {
  require_length(profile.length);
  require(profile.straight_length >= 0.0 && profile.straight_length < profile.length,
          "straight length of a profile [m]", profile.straight_length, "at least 0, less than the length");
  require_depth("end drop of a profile [m]", profile.end_drop);
  require(profile.end_drop < 0.5 * (profile.length - profile.straight_length), "end drop of a profile [m]",
          profile.end_drop, "less than the length of a curved end");
}

void check(const Lundberg& profile) {
  require_length(profile.length);
  require_depth("amplitude of a profile [m]", profile.amplitude);
  require_width(profile.width_ratio);
}

void check(const JohnsGohar& profile) {
  require_length(profile.length);
  require_depth("amplitude of a profile [m]", profile.amplitude);
  require_width(profile.width_ratio);
}

void check(const Iso16281& profile) {
  require_length(profile.length);
  require(std::isfinite(profile.diameter) && profile.diameter > 0.0, "roller diameter of a profile [m]",
          profile.diameter, "a length above 0");
  require_depth("scale of a profile [-]", profile.scale);
}

void check(const FujiwaraKawase& profile) {
  require_length(profile.length);
  require_depth("end drop of a profile [m]", profile.end_drop);
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
            "point of a profile [m]", profile.x[i], "finite places in rising order");
    require_depth("drop of a profile [m]", profile.drop[i]);
  }
  require_depth("scale of a profile [-]", profile.scale);
}

}  // namespace

void require_sound(const Profile& profile) {
  std::visit([](const auto& shape) { check(shape); }, profile);
}

}  // namespace orbearing::bearing::profile
