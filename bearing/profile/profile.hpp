// What is asked of a profile, whatever its kind (bearing/profile/shapes.hpp).
#pragma once

#include <string>

#include "bearing/profile/shapes.hpp"

namespace orbearing::bearing::profile {

/// Relief at `x` [m] from the middle.
Relief relief(const Profile& profile, double x);

/// Drop [m] of one body's surface at `x` [m] from the middle, >= 0.
double drop(const Profile& profile, double x);

/// The leading parameter, in its own unit; zero if straight.
double leading_parameter(const Profile& profile);

/// The same profile with another leading parameter; a straight one stays straight.
Profile with_parameter(Profile profile, double value);

/// The same kind of profile, deep enough to have `depth` [m] at `station` [m]. Throws std::invalid_argument
/// where that place has no relief at any depth.
Profile with_drop(const Profile& profile, double station, double depth);

/// Name as in case files: straight, chamfer, circular, straight-circular, lundberg, johns-gohar, iso16281,
/// fujiwara-kawase, table.
std::string kind(const Profile& profile);

/// Throws std::invalid_argument, with what was found and what is required, where a profile has no meaning.
void require_sound(const Profile& profile);

}  // namespace orbearing::bearing::profile
