#include "coupling/study/crowning/profile_family.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bearing/geometry.hpp"
#include "bearing/profile/design.hpp"

namespace orbearing::study::crowning {

namespace {

namespace profile = bearing::profile;
using profile::Profile;

[[noreturn]] void throw_no_drop(const std::string& kind) {
  throw std::invalid_argument("profile: found " + kind + "; required: a kind that can be given any drop");
}

Profile shape_of(const std::string& kind, const bearing::Bearing& bearing, double load) {
  const double l = bearing.rollers().length;
  const profile::DesignLoad design = bearing::design_under(bearing, load);
  if (kind == "chamfer") return profile::Chamfer{l, 0.1 * l, 1e-6};
  if (kind == "circular") return profile::CircularCrown{l, 1e-6};
  if (kind == "straight-circular") return profile::StraightCircular{l, 0.6 * l, 1e-6};
  if (kind == "lundberg") return profile::lundberg_for(design);
  if (kind == "johns-gohar") return profile::johns_gohar_for(design);
  if (kind == "iso16281") return profile::Iso16281{l, bearing.rollers().diameter, 1.0};
  if (kind == "fujiwara-kawase") {
    const double end = profile::drop(profile::johns_gohar_for(design), 0.5 * l);
    return profile::fujiwara_kawase_for(design, 1.0, 0.6, end);
  }
  throw_no_drop(kind);
}

// Relieved length of one half.
double crowned_length(const ProfileFamily& family, double share) {
  return 0.5 * family.length * share;
}

Profile with_share(Profile shape, double length, double share) {
  if (auto* chamfer = std::get_if<profile::Chamfer>(&shape))
    chamfer->chamfer_length = 0.5 * length * share;
  else if (auto* circular = std::get_if<profile::StraightCircular>(&shape))
    circular->straight_length = length * (1.0 - share);
  else if (auto* logarithmic = std::get_if<profile::FujiwaraKawase>(&shape))
    logarithmic->crowned_fraction = share;
  return shape;
}

// d(drop)/d(crowned length) [-] at `x` while the leading parameter is held: s = distance to where the crown
// begins grows as fast as the crowned length c.
double by_crowned_length(const profile::Chamfer& shape, double s, double c) {
  return shape.depth * (1.0 - s / c) / c;
}

// Arc of curvature k = 2 P/(c^2 + P^2): drop = k s^2/(1 + r), r = sqrt(1 - k^2 s^2).
double by_crowned_length(const profile::StraightCircular& shape, double s, double c) {
  const double square_sum = c * c + shape.end_drop * shape.end_drop;
  const double curvature = 2.0 * shape.end_drop / square_sum;
  const double root = std::sqrt(1.0 - curvature * curvature * s * s);
  return curvature * s / root - s * s / (root * (1.0 + root)) * 2.0 * c * curvature / square_sum;
}

// -A ln(1 - f u^2), u = s/c.
double by_crowned_length(const profile::FujiwaraKawase& shape, double s, double c) {
  const double f = -std::expm1(-shape.steepness), u = s / c;
  return shape.end_drop / shape.steepness * 2.0 * f * u / (1.0 - f * u * u) * (1.0 - u) / c;
}

template <class Other>
double by_crowned_length(const Other&, double, double) {
  return 0.0;
}

double by_share_alone(const ProfileFamily& family, const Profile& made, double share, double x) {
  const double crowned = crowned_length(family, share);
  const double within = std::min(std::abs(x), 0.5 * family.length) - (0.5 * family.length - crowned);
  if (!has_share(family) || within <= 0.0) return 0.0;
  const double by_length =
      std::visit([&](const auto& shape) { return by_crowned_length(shape, within, crowned); }, made);
  return 0.5 * family.length * by_length;
}

double station_of(const ProfileFamily& family) {
  return profile::kDropPlace * 0.5 * family.length;
}

}  // namespace

std::vector<std::string> family_names() {
  return {"chamfer",     "circular", "straight-circular", "lundberg",
          "johns-gohar", "iso16281", "fujiwara-kawase"};
}

ProfileFamily family_of(const std::string& kind, const bearing::Bearing& bearing, double load) {
  return {shape_of(kind, bearing, load), bearing.rollers().length};
}

ProfileFamily family_like(const Profile& made, const bearing::Bearing& bearing) {
  const std::string kind = profile::kind(made);
  const std::vector<std::string> names = family_names();
  if (std::find(names.begin(), names.end(), kind) == names.end()) throw_no_drop(kind);
  return {made, bearing.rollers().length};
}

bool has_share(const ProfileFamily& family) {
  return std::holds_alternative<profile::Chamfer>(family.shape) ||
         std::holds_alternative<profile::StraightCircular>(family.shape) ||
         std::holds_alternative<profile::FujiwaraKawase>(family.shape);
}

double usual_share(const ProfileFamily& family) {
  if (const auto* chamfer = std::get_if<profile::Chamfer>(&family.shape))
    return chamfer->chamfer_length / (0.5 * family.length);
  if (const auto* circular = std::get_if<profile::StraightCircular>(&family.shape))
    return 1.0 - circular->straight_length / family.length;
  if (const auto* logarithmic = std::get_if<profile::FujiwaraKawase>(&family.shape))
    return logarithmic->crowned_fraction;
  return 1.0;
}

Profile profile_of(const ProfileFamily& family, const Crown& crown) {
  return profile::with_drop(with_share(family.shape, family.length, crown.share), station_of(family),
                            crown.drop);
}

// The depth follows the share so that the drop at the station stays.
DropSlope drop_slope(const ProfileFamily& family, const Crown& crown, double x) {
  const Profile made = profile_of(family, crown);
  const double by_drop = profile::drop_per_drop(made, x, station_of(family));
  return {by_drop, by_share_alone(family, made, crown.share, x) -
                       by_drop * by_share_alone(family, made, crown.share, station_of(family))};
}

double reference_drop(const bearing::Bearing& bearing) {
  return profile::drop(profile::Iso16281{bearing.rollers().length, bearing.rollers().diameter, 1.0},
                       profile::kDropPlace * 0.5 * bearing.rollers().length);
}

}  // namespace orbearing::study::crowning
