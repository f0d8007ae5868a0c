#include "app/case/profile_case.hpp"

#include <stdexcept>

#include "bearing/profile/design.hpp"

namespace orbearing::app {

namespace {

namespace profile = bearing::profile;

// The roller on the inner race: the smaller radius of both contacts asks for the deeper profile.
profile::DesignLoad design_of(const ResolvedCase& in) {
  constexpr double stribeck = 4.08;  // [-]  largest roller load over F/Z, many rollers without clearance
  const double given = in.quantity("bearing.profile.design_load");
  const double diameter = in.quantity("bearing.roller_diameter");
  const double gamma = diameter / in.quantity("bearing.pitch_diameter");
  return {.load = given > 0.0 ? given : stribeck * in.quantity("load.radial") / in.integer("bearing.rollers"),
          .length = in.quantity("bearing.roller_length"),
          .equivalent_radius = 0.5 * diameter * (1.0 - gamma),
          .material = {.youngs_modulus = in.quantity("material.youngs_modulus"),
                       .poisson_ratio = in.number("material.poisson_ratio")}};
}

profile::Table table_of(const ResolvedCase& in) {
  if (!in.has("bearing.profile.places") || !in.has("bearing.profile.drops"))
    throw std::invalid_argument(
        "a table without its points; required: bearing.profile.places and bearing.profile.drops, lists of "
        "equal length");
  return {in.list("bearing.profile.places"), in.list("bearing.profile.drops"),
          in.number("bearing.profile.scale")};
}

profile::Profile shape_of(const ResolvedCase& in, const std::string& kind) {
  const double length = in.quantity("bearing.roller_length");
  const double drop = in.quantity("bearing.profile.drop");
  if (kind == "chamfer") return profile::Chamfer{length, in.quantity("bearing.profile.chamfer_length"), drop};
  if (kind == "circular") return profile::CircularCrown{length, drop};
  if (kind == "straight-circular")
    return profile::StraightCircular{length, in.number("bearing.profile.straight_share") * length, drop};
  if (kind == "lundberg") return profile::lundberg_for(design_of(in));
  if (kind == "johns-gohar") return profile::johns_gohar_for(design_of(in));
  if (kind == "fujiwara-kawase")
    return profile::fujiwara_kawase_for(design_of(in), in.number("bearing.profile.k1"),
                                        in.number("bearing.profile.k2"), drop);
  if (kind == "iso16281")
    return profile::Iso16281{length, in.quantity("bearing.roller_diameter"),
                             in.number("bearing.profile.scale")};
  if (kind == "table") return table_of(in);
  return profile::Straight{};
}

}  // namespace

profile::Profile profile_of(const ResolvedCase& resolved) {
  profile::Profile result = shape_of(resolved, resolved.choice("bearing.profile.kind"));
  profile::require_sound(result);
  return result;
}

}  // namespace orbearing::app
