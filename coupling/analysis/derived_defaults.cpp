#include "coupling/analysis/derived_defaults.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "bearing/default_design.hpp"
#include "gearset/dynamics/bodies.hpp"
#include "mechanics/member_keys.hpp"
#include "mechanics/number_text.hpp"

namespace orbearing::analysis::defaults {

using bearing::BearingDesign;
using mechanics::significant;

namespace {

// Of a member of the set, or of the cage in motion.
template <class Member>
std::string key_in_set(const Member& member) {
  return mechanics::key_of<StatedSet>(member);
}
template <class Member>
std::string key_in_cage(const Member& member) {
  return mechanics::key_of<bearing::motion::CageParameters>(member);
}

/// Rollers or balls, for the words of a reason.
struct Elements {
  int count = 0;
  double diameter = 0.0, length = 0.0;  // [m]
  std::string name;
};
Elements elements_of(const BearingDesign& bearing) {
  if (bearing.balls > 0) return {bearing.balls, bearing.ball_diameter, bearing.ball_diameter, "ball"};
  const bearing::CylindricalRollers& rollers = bearing.rollers;
  return {rollers.count, rollers.diameter, rollers.length, "roller"};
}

std::string of_material(const bearing::CageMaterial& material) {
  return std::string(material.name) + ", the common cage material nearest in density";
}
std::string millimetres(double length, int digits) {
  return significant(1e3 * length, digits) + " mm";
}

}  // namespace

std::string PocketClearance::key() {
  return key_in_cage([](const auto& cage) -> const auto& { return cage.pocket_clearance; });
}
MaybeDefault PocketClearance::derive(const BearingDesign& bearing) {
  const Elements elements = elements_of(bearing);
  if (elements.count == 0 || elements.diameter == 0.0 || bearing.pitch_diameter == 0.0) return std::nullopt;
  const double clearance =
      bearing::default_pocket_clearance(elements.diameter, bearing.pitch_diameter, elements.count);
  if (!(clearance > 0.0)) return std::nullopt;
  return DerivedDefault{clearance, "a fiftieth of the " + elements.name +
                                       "'s diameter, at most half of the gap between " + elements.name + "s"};
}

std::string PocketStiffness::key() {
  return key_in_cage([](const auto& cage) -> const auto& { return cage.pocket_stiffness; });
}
MaybeDefault PocketStiffness::derive(const BearingDesign& in) {
  const bearing::CylindricalRollers& rollers = in.rollers;
  const bearing::Cage& cage = in.cage;
  if (rollers.count == 0 || rollers.diameter == 0.0 || rollers.length == 0.0 || in.pitch_diameter == 0.0 ||
      cage.inner_diameter == 0.0 || cage.outer_diameter == 0.0 || cage.density == 0.0 || !in.pocket_clearance)
    return std::nullopt;
  const bearing::CageMaterial& material = bearing::default_cage_material(cage.density);
  const bearing::CageBar bar{.length = rollers.length,
                             .height = 0.5 * (cage.outer_diameter - cage.inner_diameter),
                             .thickness = bearing::cage_bar_thickness(rollers.diameter, *in.pocket_clearance,
                                                                      in.pitch_diameter, rollers.count),
                             .youngs_modulus = material.youngs_modulus};
  if (!(bar.height > 0.0) || !(bar.thickness > 0.0)) return std::nullopt;
  return DerivedDefault{bearing::cage_bar_stiffness(bar),
                        "a bar " + millimetres(bar.length, 3) + " long, " + millimetres(bar.height, 3) +
                            " high and " + millimetres(bar.thickness, 3) +
                            " thick, clamped at both ends, of " + std::string(material.name) + " (" +
                            significant(1e-9 * bar.youngs_modulus, 3) +
                            " GPa), the common cage material nearest in density"};
}

std::string TouchDownStiffness::key() {
  return key_in_cage([](const auto& cage) -> const auto& { return cage.touch_down_stiffness; });
}
MaybeDefault TouchDownStiffness::derive(const BearingDesign& in) {
  if (in.cage.width == 0.0 || in.cage.density == 0.0) return std::nullopt;
  const bearing::CageMaterial& material = bearing::default_cage_material(in.cage.density);
  return DerivedDefault{bearing::default_touch_down_stiffness(material.youngs_modulus, in.cage.width),
                        "a line contact of the cage's width, a fifth of the modulus of " +
                            std::string(material.name) + " times the width"};
}

std::string GuideLand::key() {
  return key_in_cage([](const auto& cage) -> const auto& { return cage.guide_diameter; });
}
MaybeDefault GuideLand::derive(const BearingDesign& in) {
  const Elements elements = elements_of(in);
  const bearing::Cage& cage = in.cage;
  if (elements.diameter == 0.0 || elements.length == 0.0 || in.pitch_diameter == 0.0 ||
      cage.inner_diameter == 0.0 || cage.outer_diameter == 0.0 || cage.width <= elements.length)
    return std::nullopt;
  const bool outside = cage.guidance == bearing::Race::outer;
  const double side = outside ? 1.0 : -1.0;
  const double guided = outside ? cage.outer_diameter : cage.inner_diameter;
  const double raceway = in.pitch_diameter + side * elements.diameter;
  const double play =
      std::min(bearing::default_land_play(elements.diameter), 0.5 * side * (raceway - guided));
  if (!(play > 0.0)) return std::nullopt;
  return DerivedDefault{guided + side * play,
                        "a clearance of " + millimetres(play, 3) + ", 6 % of the " + elements.name +
                            "'s diameter, at most half of that to the " + (outside ? "outer" : "inner") +
                            " raceway",
                        9};
}

std::string PocketDamping::key() {
  return key_in_cage([](const auto& cage) -> const auto& { return cage.pocket_damping; });
}
MaybeDefault PocketDamping::derive(const BearingDesign& in) {
  if (in.cage.density == 0.0) return std::nullopt;
  const bearing::CageMaterial& material = bearing::default_cage_material(in.cage.density);
  return DerivedDefault{material.damping, of_material(material)};
}

namespace {

// None where the case states masses and springs instead of teeth.
bool has_teeth(const gearset::PlanetarySet& set) {
  return set.sun_teeth > 0 && set.planet_teeth > 0 && set.ring_teeth > 0 && set.module > 0.0;
}

MaybeDefault support(const StatedSet& set, gearset::Member member, std::string_view rule) {
  if (!has_teeth(set.teeth)) return std::nullopt;
  return DerivedDefault{
      gearset::dynamics::default_support_stiffness(set.teeth, member, set.gears.material.youngs_modulus),
      std::string(rule)};
}

}  // namespace

std::string SunSupport::key() {
  return key_in_set([](const auto& set) -> const auto& { return set.gears.choice.sun.support_stiffness; });
}
MaybeDefault SunSupport::derive(const StatedSet& set) {
  return support(set, gearset::Member::sun, rule);
}

std::string RingSupport::key() {
  return key_in_set([](const auto& set) -> const auto& { return set.gears.choice.ring.support_stiffness; });
}
MaybeDefault RingSupport::derive(const StatedSet& set) {
  return support(set, gearset::Member::ring, rule);
}

std::string CarrierSupport::key() {
  return key_in_set(
      [](const auto& set) -> const auto& { return set.gears.choice.carrier.support_stiffness; });
}
MaybeDefault CarrierSupport::derive(const StatedSet& set) {
  return support(set, gearset::Member::carrier, rule);
}

std::string Backlash::key() {
  return key_in_set([](const auto& set) -> const auto& { return set.gears.choice.backlash; });
}
MaybeDefault Backlash::derive(const StatedSet& set) {
  if (!has_teeth(set.teeth)) return std::nullopt;
  return DerivedDefault{gearset::dynamics::default_backlash(set.teeth),
                        std::string(rule) + ": a " +
                            millimetres(gearset::dynamics::reference_centre_distance(set.teeth), 4) +
                            ", m_n " + millimetres(set.teeth.module, 4)};
}

std::string SunTilt::key() {
  return key_in_set([](const auto& set) -> const auto& { return set.carrier.sun_tilt_stiffness; });
}
MaybeDefault SunTilt::derive(const StatedSet& set) {
  if (!has_teeth(set.teeth) || set.carrier.positions.empty()) return std::nullopt;
  return DerivedDefault{
      gearset::dynamics::default_sun_tilt_stiffness(set.teeth, set.gears.choice.sun.support_stiffness,
                                                    set.gears.material.youngs_modulus),
      std::string(rule)};
}

std::string SunAxial::key() {
  return key_in_set([](const auto& set) -> const auto& { return set.carrier.sun_axial_stiffness; });
}
MaybeDefault SunAxial::derive(const StatedSet& set) {
  if (set.teeth.helix_angle == 0.0 || set.carrier.positions.empty()) return std::nullopt;
  return support(set, gearset::Member::sun, rule);
}

namespace {

// As pins are where tilts are computed; else walls hold both ends.
bearing::PinEnds ends_of(const StatedSet& set) {
  const bool computed = set.planets.seats.tilt == TiltState::computed;
  return computed ? set.planets.seats.ends : bearing::PinEnds::both;
}

constexpr std::array held{"between the middles of the carrier's walls",
                          "clamped in one wall: twice the distance from there to the middle of the face",
                          "from the wall to where it carries its sleeve: a flexpin"};

}  // namespace

std::string FlexpinDiameter::key() {
  return key_in_set([](const auto& set) -> const auto& { return set.planets.seats.diameter; });
}
MaybeDefault FlexpinDiameter::derive(const StatedSet& set) {
  const double bore = set.planets.bearing.inner.seat_diameter;
  if (ends_of(set) != bearing::PinEnds::flexpin || bore == 0.0) return std::nullopt;
  return DerivedDefault{0.625 * bore, std::string(rule)};
}

std::string PinStiffness::key() {
  return key_in_set([](const auto& set) -> const auto& { return set.planets.dynamics.support.stiffness; });
}
// Walls of the carrier as its mass has them: both together the plate ratio times the face width.
MaybeDefault PinStiffness::derive(const StatedSet& set) {
  const PlanetaryDrivetrain& planets = set.planets;
  const double bore = planets.bearing.inner.seat_diameter, face = set.teeth.face_width;
  if (bore == 0.0 || face == 0.0) return std::nullopt;
  bearing::PlanetPin pin{.diameter = bore,
                         .loaded_length = face,
                         .span = face * (1.0 + 0.5 * set.gears.choice.carrier_plate_ratio),
                         .youngs_modulus = planets.bearing.material.youngs_modulus,
                         .poisson_ratio = planets.bearing.material.poisson_ratio,
                         .ends = ends_of(set)};
  if (pin.ends != bearing::PinEnds::both) {
    pin.span = planets.seats.span.value_or(face);
    pin.loaded_length = std::min(face, pin.span);
  }
  if (pin.ends == bearing::PinEnds::flexpin) pin.diameter = planets.seats.diameter.value();
  return DerivedDefault{bearing::pin_stiffness(pin) / planets.bearings_per_planet,
                        "a solid pin of " + millimetres(pin.diameter, 4) + ", " + millimetres(pin.span, 4) +
                            " " + held[static_cast<std::size_t>(pin.ends)] +
                            ", shared by the bearings of a planet; the walls are rigid"};
}

}  // namespace orbearing::analysis::defaults
