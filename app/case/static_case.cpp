#include "app/case/static_case.hpp"

#include "app/case/profile_case.hpp"

namespace orbearing::app {

namespace {

bearing::Material material_of(const ResolvedCase& in) {
  return {.youngs_modulus = in.quantity("material.youngs_modulus"),
          .poisson_ratio = in.number("material.poisson_ratio"),
          .density = in.quantity("material.density")};
}

bearing::CylindricalRollerBearing whole_bearing_of(const ResolvedCase& in) {
  return {.rollers = in.integer("bearing.rollers"),
          .roller_diameter = in.quantity("bearing.roller_diameter"),
          .roller_length = in.quantity("bearing.roller_length"),
          .pitch_diameter = in.quantity("bearing.pitch_diameter"),
          .radial_clearance = in.quantity("bearing.radial_clearance"),
          .material = material_of(in),
          .contact_law = in.choice("contact.law") == "iso16281" ? bearing::ContactLaw::iso16281
                                                                : bearing::ContactLaw::palmgren};
}

std::optional<double> tilt_of(const ResolvedCase& in) {
  if (!in.has("load.tilt")) return {};
  return in.quantity("load.tilt");
}

}  // namespace

bearing::CylindricalRollerBearing lamina_bearing_of(const ResolvedCase& in) {
  bearing::CylindricalRollerBearing bearing = whole_bearing_of(in);
  bearing.laminae = in.has("bearing.laminae") ? in.integer("bearing.laminae") : default_laminae;
  bearing.roller_profile = roller_profile_of(in);
  return bearing;
}

bearing::BallBearing ball_bearing_of(const ResolvedCase& in) {
  return {.balls = in.integer("bearing.balls"),
          .ball_diameter = in.quantity("bearing.ball_diameter"),
          .pitch_diameter = in.quantity("bearing.pitch_diameter"),
          .inner_osculation = in.number("bearing.inner_osculation"),
          .outer_osculation = in.number("bearing.outer_osculation"),
          .contact_angle = in.quantity("bearing.contact_angle"),
          .radial_clearance = in.quantity("bearing.radial_clearance"),
          .material = material_of(in)};
}

bearing::equilibrium::RingLoad ring_load_of(const ResolvedCase& in) {
  return {.radial = in.quantity("load.radial"),
          .axial = in.model() == ball_bearing ? in.quantity("load.axial") : 0.0,
          .moment = in.quantity("load.moment"),
          .tilt = tilt_of(in)};
}

bearing::rating::RollerSet roller_set_of(const ResolvedCase& in) {
  bearing::rating::RollerSet set = bearing::rating::roller_set(whole_bearing_of(in));
  set.lambda = in.number("life.lambda");
  return set;
}

bearing::rating::RaceMotions race_motions_of(const ResolvedCase& in) {
  return bearing::rating::turning(in.choice("operation.turning_race") == "outer" ? bearing::Race::outer
                                                                                 : bearing::Race::inner);
}

}  // namespace orbearing::app
