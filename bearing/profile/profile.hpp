// Functions of a profile of any kind (bearing/profile/shapes.hpp).
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "mechanics/described.hpp"
#include "mechanics/material.hpp"

namespace orbearing::bearing::profile {

// Relief of a roller or a race along its length: how far its surface lies below a straight cylinder.
//
//      drop ^   .                             .      x: along the axis from the middle, -l/2 to l/2
//           |    '.                         .'       l: effective length
//           |      ''--..___________..--''           drop >= 0, radial, of one body
//           +------------------|-----------------> x
//
// Beyond +-l/2 every kind keeps its value at the end.

/// A cylinder.
struct Straight {
  bool operator==(const Straight&) const = default;
};

/// Straight up to a plane (conical) chamfer at each end.
struct Chamfer {
  double length = 0.0;          // [m]  l
  double chamfer_length = 0.0;  // [m]  of one end, along the axis
  double depth = 0.0;           // [m]  drop at the end; leading parameter

  bool operator==(const Chamfer&) const = default;
};

/// Full crown: one circular arc over the whole length.
struct CircularCrown {
  double length = 0.0;    // [m]
  double end_drop = 0.0;  // [m]  at l/2, below l/2; leading parameter

  bool operator==(const CircularCrown&) const = default;
};

/// Straight in the middle, then a circular arc that leaves it without a kink.
struct StraightCircular {
  double length = 0.0;           // [m]
  double straight_length = 0.0;  // [m]  of the whole middle part, below l
  double end_drop = 0.0;         // [m]  leading parameter

  bool operator==(const StraightCircular&) const = default;
};

/// Logarithmic profile of [Lundberg1939]: -A ln(1 - (2x/l)^2), which is infinite at the end. As there, the
/// end has the finite drop A (1/2 + ln 2 + ln(l/2b)) of the half-space under an even line load; b is half the
/// width of the Hertzian contact. The profile is held at that drop from where it reaches it.
struct Lundberg {
  double length = 0.0;       // [m]
  double amplitude = 0.0;    // [m]  A = 2 Q / (pi E' l); leading parameter
  double width_ratio = 0.0;  // [-]  2b/l, above 0 and below 1

  bool operator==(const Lundberg&) const = default;
};

/// The same with a smooth end, [JohnsGohar1981]: -A ln(1 - (1 - 0.3033 * 2b/l) (2x/l)^2).
struct JohnsGohar {
  double length = 0.0;       // [m]
  double amplitude = 0.0;    // [m]  A; leading parameter
  double width_ratio = 0.0;  // [-]  2b/l

  bool operator==(const JohnsGohar&) const = default;
};

/// Reference profile of [ISO16281]: -0.00035 D ln(1 - (2x/l)^2) for l <= 2.5 D; a longer roller is straight
/// but for 1.25 D at each end, -0.0005 D ln(1 - u^2) with u = (2|x| - (l - 2.5 D))/(2.5 D). Infinite at the
/// end; the standard uses it at the middles of laminae only and has no cap. Here it is held beyond u = 1
/// - 1e-6, where it is about 13 times its factor.
struct Iso16281 {
  double length = 0.0;    // [m]
  double diameter = 0.0;  // [m]  D of the roller
  double scale = 1.0;     // [-]  1: the standard's; leading parameter

  bool operator==(const Iso16281&) const = default;
};

/// Three-parameter logarithmic profile of [FujiwaraKawase2007]: with u from 0 where the crown begins to 1 at
/// the end, -A ln(1 - (1 - exp(-z_m/A)) u^2), A = K1 2 Q/(pi E' l), crown of length K2 l/2 at each end, z_m
/// the drop at the end. Finite. K1 = K2 = 1 with the end drop of Johns and Gohar is their profile.
struct FujiwaraKawase {
  double length = 0.0;            // [m]
  double end_drop = 0.0;          // [m]  z_m; leading parameter, at the same z_m/A
  double steepness = 0.0;         // [-]  z_m/A
  double crowned_fraction = 1.0;  // [-]  K2, above 0 and at most 1

  bool operator==(const FujiwaraKawase&) const = default;
};

/// Measured or designed points, joined by straight lines; held beyond the first and the last.
struct Table {
  std::vector<double> x;     // [m]  rising, from -l/2 to l/2
  std::vector<double> drop;  // [m]  at x
  double scale = 1.0;        // [-]  of all drops; leading parameter

  bool operator==(const Table&) const = default;
};

using Profile = std::variant<Straight, Chamfer, CircularCrown, StraightCircular, Lundberg, JohnsGohar,
                             Iso16281, FujiwaraKawase, Table>;

/// The same kinds, in the same order.
enum class Kind {
  straight,
  chamfer,
  circular,
  straight_circular,
  lundberg,
  johns_gohar,
  iso16281,
  fujiwara_kawase,
  table
};

constexpr described::Names<Kind, std::variant_size_v<Profile>> names_of(Kind) {
  return {{{Kind::straight, "straight"},
           {Kind::chamfer, "chamfer"},
           {Kind::circular, "circular"},
           {Kind::straight_circular, "straight-circular"},
           {Kind::lundberg, "lundberg"},
           {Kind::johns_gohar, "johns-gohar"},
           {Kind::iso16281, "iso16281"},
           {Kind::fujiwara_kawase, "fujiwara-kawase"},
           {Kind::table, "table"}}};
}

/// Relief at one position.
struct Relief {
  double drop = 0.0;           // [m]
  double per_parameter = 0.0;  // [m/unit of the leading parameter]  d(drop)/d(leading parameter)
};

/// Drop at the end over A [-]: 1/2 + ln 2 - ln(2b/l), [Lundberg1939].
double end_drop_factor(double width_ratio);

/// The formula of each kind; for any of them relief() in bearing/profile/profile.hpp.
Relief relief_of(const Straight& profile, double x);
Relief relief_of(const Chamfer& profile, double x);
Relief relief_of(const CircularCrown& profile, double x);
Relief relief_of(const StraightCircular& profile, double x);
Relief relief_of(const Lundberg& profile, double x);
Relief relief_of(const JohnsGohar& profile, double x);
Relief relief_of(const Iso16281& profile, double x);
Relief relief_of(const FujiwaraKawase& profile, double x);
Relief relief_of(const Table& profile, double x);

/// Relief at `x` [m] from the middle.
Relief relief(const Profile& profile, double x);

/// Drop [m] of one body's surface at `x` [m] from the middle, >= 0.
double drop(const Profile& profile, double x);

/// The leading parameter, in its own unit; zero if straight.
double leading_parameter(const Profile& profile);

/// The same profile with another leading parameter; a straight one stays straight.
Profile with_parameter(Profile profile, double value);

/// The same kind of profile, deep enough to have `depth` [m] at `station` [m]. Throws std::invalid_argument
/// where that position has no relief at any depth.
Profile with_drop(const Profile& profile, double station, double depth);

/// Name of its kind as in case files.
std::string kind(const Profile& profile);

/// Throws std::invalid_argument, with what was found and what is required, where a profile has no meaning.
void require_sound(const Profile& profile);

// Logarithmic profiles for a load: the relief that gives an even line load on an elastic half-space.

/// Position at which a profile's drop is stated, as a share of half the length: the middle of the outermost
/// of 40 laminae. The ends themselves are not suitable, since logarithmic profiles are steepest there.
inline constexpr double kDropPosition = 39.0 / 40.0;

/// Design load of a logarithmic profile.
struct DesignLoad {
  double load = 0.0;               // [N]  Q of one roller on one race
  double length = 0.0;             // [m]  l
  double equivalent_radius = 0.0;  // [m]  R of the roller on that race
  mechanics::Material material;    // of roller and race
};

/// A = 2 Q / (pi E' l) [m] with E' = E / (1 - nu^2): factor of the logarithm.
double amplitude(const DesignLoad& design);

/// 2b/l [-]: width of the Hertzian contact, b = sqrt(8 Q R / (pi E' l)), over its length.
double width_ratio(const DesignLoad& design);

Lundberg lundberg_for(const DesignLoad& design);
JohnsGohar johns_gohar_for(const DesignLoad& design);

/// K1 scales the amplitude, K2 is the crowned fraction of each half, `end_drop` [m] is z_m.
FujiwaraKawase fujiwara_kawase_for(const DesignLoad& design, double k1, double k2, double end_drop);

/// Load [N] for which the profile of Johns and Gohar drops by `drop` [m] > 0 at kDropPosition; the load of
/// `design` does not count.
double design_load_of_drop(DesignLoad design, double drop);

}  // namespace orbearing::bearing::profile
