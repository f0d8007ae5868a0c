#include "coupling/study/crowning/profile_family.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bearing/geometry.hpp"
#include "bearing/profile/profile.hpp"

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

Profile with_share(Profile shape, double length, double share) {
  if (auto* chamfer = std::get_if<profile::Chamfer>(&shape))
    chamfer->chamfer_length = 0.5 * length * share;
  else if (auto* circular = std::get_if<profile::StraightCircular>(&shape))
    circular->straight_length = length * (1.0 - share);
  else if (auto* logarithmic = std::get_if<profile::FujiwaraKawase>(&shape))
    logarithmic->crowned_fraction = share;
  return shape;
}

double station_of(const ProfileFamily& family) {
  return profile::kDropPosition * 0.5 * family.length;
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

double default_share(const ProfileFamily& family) {
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

double reference_drop(const bearing::Bearing& bearing) {
  return profile::drop(profile::Iso16281{bearing.rollers().length, bearing.rollers().diameter, 1.0},
                       profile::kDropPosition * 0.5 * bearing.rollers().length);
}

}  // namespace orbearing::study::crowning
