#include "app/case/consistency.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/case/catalogue_case.hpp"
#include "app/case/mistake.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::app {

namespace {

// Two ways to state the same thing exclude each other.
void check_either(const ResolvedCase& in, const char* one, const char* other,
                  std::vector<Mistake>& mistakes) {
  if (in.has(one) && in.has(other))
    add_error_at(in, other, fmt::format("a value together with {}", one), "one of the two is required",
                 mistakes);
}

void check_load(const ResolvedCase& in, std::vector<Mistake>& mistakes) {
  const auto has_moment = [&](const char* path) { return in.has(path) && in.quantity(path) != 0.0; };
  for (const char* moment : {"load.moment", "load.moment_across"}) {
    if (in.has("load.tilt") && has_moment(moment))
      add_error_at(in, "load.tilt", fmt::format("a tilt together with {}", moment),
                   "either the moment, with the tilt that follows, or the tilt is required", mistakes);
    if (in.model() == roller_bearing && has_moment(moment) && in.has("bearing.laminae") &&
        in.integer("bearing.laminae") < 2)
      add_error_at(in, "bearing.laminae", "a single lamina, which holds no moment",
                   fmt::format("at least 2 laminae are required with {}", moment), mistakes);
  }
  if (in.model() == roller_bearing && has_moment("load.tilt") && in.has("bearing.laminae") &&
      in.integer("bearing.laminae") < 2)
    add_error_at(in, "bearing.laminae", "a single lamina, which is not affected by a tilt",
                 "at least 2 laminae are required with load.tilt", mistakes);
  if (in.model() != roller_bearing || !in.has("load.radial")) return;
  if (in.quantity("load.radial") <= 0.0)
    add_error_at(in, "load.radial", "no load", "a radial load greater than 0 N is required", mistakes);
}

void check_balls(const ResolvedCase& in, std::vector<Mistake>& mistakes) {
  if (!has_all(
          in, {"bearing.balls", "bearing.ball_diameter", "bearing.pitch_diameter", "bearing.inner_osculation",
               "bearing.outer_osculation", "bearing.contact_angle", "bearing.radial_clearance"}))
    return;
  const double diameter = in.quantity("bearing.ball_diameter");
  const double spacing =
      in.quantity("bearing.pitch_diameter") * std::sin(constants::pi / in.integer("bearing.balls"));
  if (diameter >= spacing)
    add_error_at(
        in, "bearing.balls",
        fmt::format("{} balls do not fit around the pitch circle", in.integer("bearing.balls")),
        fmt::format("a ball diameter ({:.4g} mm) less than their centre distance, {:.4g} mm, is required",
                    1e3 * diameter, 1e3 * spacing),
        mistakes);
  const double openness = in.number("bearing.inner_osculation") + in.number("bearing.outer_osculation") - 1.0;
  const double most = 2.0 * openness * diameter * std::cos(in.quantity("bearing.contact_angle"));
  if (in.quantity("bearing.radial_clearance") >= most)
    add_error_at(in, "bearing.radial_clearance", "a clearance in which the balls touch at no contact angle",
                 fmt::format("less than {:.4g} um is required by the grooves", 1e6 * most), mistakes);
}

// Formulas that go by the flow, the speed and the size.
void check_oil_supply(const ResolvedCase& in, std::vector<Mistake>& mistakes) {
  const auto is = [&](const char* path, const char* value) {
    return in.has(path) && in.choice(path) == value;
  };
  const auto on = [&](const char* path) { return in.has(path) && in.flag(path); };
  const auto flows = [&] { return in.has("lubricant.flow") && in.quantity("lubricant.flow") > 0.0; };
  const bool filled = on("drag.enabled") && is("lubricant.fill", "parker");
  if (filled && !flows())
    add_error_at(in, "lubricant.fill", "a share of oil by the flow without a flow",
                 "lubricant.flow greater than 0 L/min is required", mistakes);
  if (filled && has_all(in, {"operation.shaft_speed", "operation.outer_speed"}) &&
      in.quantity("operation.shaft_speed") == in.quantity("operation.outer_speed"))
    add_error_at(in, "lubricant.fill", "a share of oil by the speed of rings that do not rotate",
                 "operation.shaft_speed is required", mistakes);
  if (on("heat.enabled") && is("heat.model", "oil") && !flows())
    add_error_at(in, "heat.model", "heat that leaves with the oil, without a flow",
                 "lubricant.flow greater than 0 L/min is required", mistakes);
  const bool at_rest = in.model() == roller_bearing;
  if (at_rest && on("heat.enabled") && is("heat.model", "network"))
    add_error_at(in, "heat.model", "a network of bodies for rollers",
                 "oil is required: rollers heat the oil alone", mistakes);
  if (!at_rest && is("traction.starvation", "replenished"))
    add_error_at(in, "traction.starvation", "oil that returns to the tracks of a bearing in motion",
                 "none or skf is required: it is known of rollers at rest alone", mistakes);
  if ((at_rest || on("traction.rolling_resistance")) && is("traction.starvation", "skf") &&
      !(at_rest ? size_of(in).has_value() : has_all(in, {"bearing.bore", "bearing.outside_diameter"})))
    add_error_at(in, "traction.starvation", "starvation of a bearing whose size is not known",
                 "bearing.bore and bearing.outside_diameter are required", mistakes);
}

// What a motion needs beyond a balance.
void check_motion(const ResolvedCase& in, std::vector<Mistake>& mistakes) {
  if (in.model() != ball_motion) return;
  const auto positive = [&](const char* path) { return in.has(path) && in.quantity(path) > 0.0; };
  if (!(positive("rotor.mass") && positive("rotor.inertia")) &&
      !has_all(in, {"bearing.bore", "bearing.width"}))
    add_error_at(in, "simulation.duration", "an inner ring in motion whose mass is not known",
                 "bearing.bore and bearing.width are required, or rotor.mass and rotor.inertia", mistakes);
  check_oil_supply(in, mistakes);
  if (!in.has("load.radial") || positive("load.axial") || positive("load.radial")) return;
  add_error_at(in, "load.radial", "no load", "a radial or axial load greater than 0 N is required", mistakes);
}

void check_life(const ResolvedCase& in, std::vector<Mistake>& mistakes) {
  if (in.has("lubricant.grade")) return;  // a viscosity that is always there
  check_either(in, "life.viscosity_ratio", "lubricant.kinematic_viscosity", mistakes);
  const bool film = in.has("life.viscosity_ratio") || in.has("lubricant.kinematic_viscosity");
  for (const char* path : {"life.contamination_factor", "life.cleanliness"})
    if (in.has(path) && !film)
      add_error_at(in, path, "cleanliness without a viscosity",
                   "life.viscosity_ratio or lubricant.kinematic_viscosity is required with it", mistakes);
  for (const char* path : {"life.viscosity_ratio", "lubricant.kinematic_viscosity"})
    if (in.has(path) && !in.has("life.contamination_factor") && !in.has("life.cleanliness"))
      add_error_at(in, path, "a viscosity without cleanliness",
                   "life.contamination_factor or life.cleanliness is required with it", mistakes);
  if (in.has("lubricant.kinematic_viscosity") && in.has("operation.shaft_speed") &&
      in.has("operation.outer_speed") &&
      in.quantity("operation.shaft_speed") == in.quantity("operation.outer_speed"))
    add_error_at(in, "lubricant.kinematic_viscosity", "a viscosity for rings that do not rotate",
                 "operation.shaft_speed is required, from which the viscosity ratio follows", mistakes);
}

}  // namespace

void check_cleanliness(const ResolvedCase& in, std::vector<Mistake>& mistakes) {
  check_either(in, "life.contamination_factor", "life.cleanliness", mistakes);
  if (!has_all(in, {"life.cleanliness", "life.lubrication"})) return;
  const std::string &level = in.choice("life.cleanliness"), &how = in.choice("life.lubrication");
  if ((level == "lowest" || level == "-/21/18") && how == "circulating-oil")
    add_error_at(in, "life.cleanliness", fmt::format("'{}' for circulating oil", level),
                 "one of highest, high, medium, low is required with a filter", mistakes);
  if (level.front() == '-' && how == "grease")
    add_error_at(in, "life.cleanliness", fmt::format("'{}' for grease", level),
                 "one of highest, high, medium, low, lowest is required: codes of ISO 4406 are those of oil",
                 mistakes);
}

void check_static_bearing(const ResolvedCase& resolved, std::vector<Mistake>& mistakes) {
  if ((resolved.model() & with_balls) != 0) check_balls(resolved, mistakes);
  if (resolved.model() == planetary_drivetrain) check_oil_supply(resolved, mistakes);
  if (resolved.model() == ball_motion) check_motion(resolved, mistakes);
  if (resolved.model() != roller_bearing && resolved.model() != ball_bearing &&
      resolved.model() != ball_motion)
    return;
  if (resolved.model() == roller_bearing) check_oil_supply(resolved, mistakes);
  check_load(resolved, mistakes);
  check_life(resolved, mistakes);
}

}  // namespace orbearing::app
