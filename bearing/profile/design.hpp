// Logarithmic profiles for a load: the relief that gives an even line load on an elastic half-space.
#pragma once

#include "bearing/profile/profile.hpp"
#include "mechanics/material.hpp"

namespace orbearing::bearing::profile {

/// Where a profile's drop is stated, as a share of half the length: the middle of the outermost of 40
/// laminae. The ends themselves are no good place, for logarithmic profiles are steepest there.
inline constexpr double kDropPosition = 39.0 / 40.0;

/// What a logarithmic profile is laid out for.
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

/// Load [N] for which the profile of Johns and Gohar drops by `drop` [m] > 0 at kDropPlace; the load of
/// `design` does not count.
double design_load_of_drop(DesignLoad design, double drop);

}  // namespace orbearing::bearing::profile
