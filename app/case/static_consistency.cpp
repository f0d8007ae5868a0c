#include "app/case/consistency.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/case/catalogue_case.hpp"
#include "bearing/life/life_modification.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::app {

namespace {

void check_load(CheckedCase& in) {
  const bool rollers = in.model() == roller_bearing;
  const bool single_lamina = rollers && in.has("bearing.laminae") && in.integer("bearing.laminae") < 2;
  for (const char* moment : {"load.moment", "load.moment_across"}) {
    if (!is_nonzero(in, moment)) continue;
    if (in.has("load.tilt"))
      in.add_error_at("load.tilt", fmt::format("a tilt together with {}", moment),
                      "either the moment, with the tilt that follows, or the tilt is required");
    if (single_lamina)
      in.add_error_at("bearing.laminae", "a single lamina, which holds no moment",
                      fmt::format("at least 2 laminae are required with {}", moment));
  }
  if (single_lamina && is_nonzero(in, "load.tilt"))
    in.add_error_at("bearing.laminae", "a single lamina, which is not affected by a tilt",
                    "at least 2 laminae are required with load.tilt");
  if (rollers && in.has("load.radial") && in.quantity("load.radial") <= 0.0)
    in.add_error_at("load.radial", "no load", "a radial load greater than 0 N is required");
}

void check_balls(CheckedCase& in) {
  if (!has_all(
          in, {"bearing.balls", "bearing.ball_diameter", "bearing.pitch_diameter", "bearing.inner_osculation",
               "bearing.outer_osculation", "bearing.contact_angle", "bearing.radial_clearance"}))
    return;
  check_ball_circle(in);
  const double openness = in.number("bearing.inner_osculation") + in.number("bearing.outer_osculation") - 1.0;
  const double most =
      2.0 * openness * in.quantity("bearing.ball_diameter") * std::cos(in.quantity("bearing.contact_angle"));
  if (in.quantity("bearing.radial_clearance") >= most)
    in.add_error_at("bearing.radial_clearance", "a clearance in which the balls touch at no contact angle",
                    fmt::format("less than {:.4g} um is required by the grooves", 1e6 * most));
}

bool rings_rotate_alike(const ResolvedCase& in) {
  return has_all(in, {"operation.shaft_speed", "operation.outer_speed"}) &&
         in.quantity("operation.shaft_speed") == in.quantity("operation.outer_speed");
}

bool is_positive(const ResolvedCase& in, const char* path) {
  return in.has(path) && in.quantity(path) > 0.0;
}

// Formulas that go by the flow, the speed and the size.
void check_oil_supply(CheckedCase& in) {
  const bool flows = is_positive(in, "lubricant.flow");
  const bool filled = is_on(in, "drag.enabled") && in.is("lubricant.fill", "parker");
  if (filled && !flows)
    in.add_error_at("lubricant.fill", "a share of oil by the flow without a flow",
                    "lubricant.flow greater than 0 L/min is required");
  if (filled && rings_rotate_alike(in))
    in.add_error_at("lubricant.fill", "a share of oil by the speed of rings that do not rotate",
                    "operation.shaft_speed is required");
  if (is_on(in, "heat.enabled") && in.is("heat.model", "oil") && !flows)
    in.add_error_at("heat.model", "heat that leaves with the oil, without a flow",
                    "lubricant.flow greater than 0 L/min is required");
  const bool at_rest = in.model() == roller_bearing;
  if (at_rest && is_on(in, "heat.enabled") && in.is("heat.model", "network"))
    in.add_error_at("heat.model", "a network of bodies for rollers",
                    "oil is required: rollers heat the oil alone");
  if (!at_rest && in.is("traction.starvation", "replenished"))
    in.add_error_at("traction.starvation", "oil that returns to the tracks of a bearing in motion",
                    "none or skf is required: it is known of rollers at rest alone");
  if ((at_rest || is_on(in, "traction.rolling_resistance")) && in.is("traction.starvation", "skf") &&
      !(at_rest ? size_of(in).has_value() : has_all(in, {"bearing.bore", "bearing.outside_diameter"})))
    in.add_error_at("traction.starvation", "starvation of a bearing whose size is not known",
                    "bearing.bore and bearing.outside_diameter are required");
}

// Additional requirements of a motion, compared with a static equilibrium.
void check_motion(CheckedCase& in) {
  if (in.model() != ball_motion) return;
  if (!(is_positive(in, "rotor.mass") && is_positive(in, "rotor.inertia")) &&
      !has_all(in, {"bearing.bore", "bearing.width"}))
    in.add_error_at("simulation.duration", "an inner ring in motion whose mass is not known",
                    "bearing.bore and bearing.width are required, or rotor.mass and rotor.inertia");
  check_oil_supply(in);
  if (!in.has("load.radial") || is_positive(in, "load.axial") || is_positive(in, "load.radial")) return;
  in.add_error_at("load.radial", "no load", "a radial or axial load greater than 0 N is required");
}

// The viscosity ratio of the oil, by which a_ISO is known: it needs a speed, and begins at 0.1.
void check_viscosity_ratio(CheckedCase& in) {
  const char* kinematic = "lubricant.kinematic_viscosity";
  if (in.has("life.viscosity_ratio") || !in.has(kinematic)) return;
  const char* oil = in.has("lubricant.viscosity_40") ? "lubricant.viscosity_40" : "lubricant.grade";
  const char* path = in.has("lubricant.grade") ? oil : kinematic;
  if (rings_rotate_alike(in)) {
    in.add_error_at(path, "a viscosity for rings that do not rotate",
                    "operation.shaft_speed is required, from which the viscosity ratio follows");
    return;
  }
  if (!has_all(in, {"operation.shaft_speed", "operation.outer_speed", "bearing.pitch_diameter"})) return;
  namespace rating = bearing::rating;
  const double kappa =
      in.quantity(kinematic) /
      rating::required_viscosity(in.quantity("operation.shaft_speed") - in.quantity("operation.outer_speed"),
                                 in.quantity("bearing.pitch_diameter"));
  if (!(kappa >= rating::kLeastViscosityRatio))
    in.add_error_at(path,
                    fmt::format("a viscosity ratio kappa of {:.3g} by a viscosity of {:.3g} mm2/s", kappa,
                                1e6 * in.quantity(kinematic)),
                    fmt::format("at least {:g} is required, where a_ISO begins: a thicker oil, a lower "
                                "temperature or a higher speed",
                                rating::kLeastViscosityRatio));
}

void check_life(CheckedCase& in) {
  check_viscosity_ratio(in);
  if (in.has("lubricant.grade")) return;  // a viscosity that is always there
  check_either(in, "life.viscosity_ratio", "lubricant.kinematic_viscosity");
  const bool film = in.has("life.viscosity_ratio") || in.has("lubricant.kinematic_viscosity");
  for (const char* path : {"life.contamination_factor", "life.cleanliness"})
    if (in.has(path) && !film)
      in.add_error_at(path, "cleanliness without a viscosity",
                      "life.viscosity_ratio or lubricant.kinematic_viscosity is required with it");
  for (const char* path : {"life.viscosity_ratio", "lubricant.kinematic_viscosity"})
    if (in.has(path) && !in.has("life.contamination_factor") && !in.has("life.cleanliness"))
      in.add_error_at(path, "a viscosity without cleanliness",
                      "life.contamination_factor or life.cleanliness is required with it");
}

}  // namespace

void check_either(CheckedCase& in, const char* one, const char* other) {
  if (in.has(one) && in.has(other))
    in.add_error_at(other, fmt::format("a value together with {}", one), "one of the two is required");
}

void check_ball_circle(CheckedCase& in) {
  if (!has_all(in, {"bearing.balls", "bearing.ball_diameter", "bearing.pitch_diameter"})) return;
  const double diameter = in.quantity("bearing.ball_diameter");
  const double spacing =
      in.quantity("bearing.pitch_diameter") * std::sin(constants::pi / in.integer("bearing.balls"));
  if (diameter >= spacing)
    in.add_error_at(
        "bearing.balls",
        fmt::format("{} balls do not fit around the pitch circle", in.integer("bearing.balls")),
        fmt::format("a ball diameter ({:.4g} mm) less than their centre distance, {:.4g} mm, is required",
                    1e3 * diameter, 1e3 * spacing));
}

void check_cleanliness(CheckedCase& in) {
  check_either(in, "life.contamination_factor", "life.cleanliness");
  if (!has_all(in, {"life.cleanliness", "life.lubrication"})) return;
  const std::string &level = in.choice("life.cleanliness"), &how = in.choice("life.lubrication");
  if ((level == "lowest" || level == "-/21/18") && how == "circulating-oil")
    in.add_error_at("life.cleanliness", fmt::format("'{}' for circulating oil", level),
                    "one of highest, high, medium, low is required with a filter");
  if (level.front() == '-' && how == "grease")
    in.add_error_at(
        "life.cleanliness", fmt::format("'{}' for grease", level),
        "one of highest, high, medium, low, lowest is required: codes of ISO 4406 are those of oil");
}

void check_static_bearing(CheckedCase& in) {
  const Model model = in.model();
  if ((model & with_balls) != 0) check_balls(in);
  if (model == planetary_drivetrain || model == roller_bearing) check_oil_supply(in);
  if (model == ball_motion) check_motion(in);
  if ((model & (roller_bearing | single_ball_bearing)) == 0) return;
  check_load(in);
  check_life(in);
}

}  // namespace orbearing::app
