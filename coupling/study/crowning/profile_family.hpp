// Profiles of one kind with two free numbers: how deep, and over how much of the length.
#pragma once

#include <string>
#include <vector>

#include "bearing/parameters.hpp"
#include "bearing/profile/profile.hpp"

namespace orbearing::study::crowning {

/// What is free about a profile.
struct Crown {
  double drop = 0.0;   // [m]  of one roller at profile::kDropPlace
  double share = 1.0;  // [-]  of each half that is relieved; of kinds that have a straight middle only
};

/// Profiles of one kind for one roller.
struct ProfileFamily {
  bearing::profile::Profile shape;  // of any depth
  double length = 0.0;              // [m]
};

/// Kinds that can be given any drop: all but straight and table.
std::vector<std::string> family_names();

/// The family `kind` for rollers of `bearing`. `load` [N] of one roller sets the width of the contact, which
/// rounds the ends of johns-gohar, lundberg and fujiwara-kawase. Throws std::invalid_argument for other
/// kinds.
ProfileFamily family_of(const std::string& kind, const bearing::Bearing& bearing, double load);

/// The family that `made` belongs to, with its own proportions. Throws as above.
ProfileFamily family_like(const bearing::profile::Profile& made, const bearing::Bearing& bearing);

/// Whether the kind has a straight middle whose length is free: chamfer, straight-circular, fujiwara-kawase.
bool has_share(const ProfileFamily& family);

/// Crowned share of the family as it is made; 1 for kinds crowned all along.
double default_share(const ProfileFamily& family);

/// Least and greatest share of any use: the station stays within the crown.
inline constexpr double kLeastShare = 0.1;
inline constexpr double kGreatestShare = 0.95;

/// The profile with this crown.
bearing::profile::Profile profile_of(const ProfileFamily& family, const Crown& crown);

/// Drop [m] at profile::kDropPlace of the reference profile of [ISO16281] on rollers of `bearing`.
double reference_drop(const bearing::Bearing& bearing);

}  // namespace orbearing::study::crowning
