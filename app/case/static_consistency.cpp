#include "app/case/consistency.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/case/described_case.hpp"
#include "bearing/motion/starvation.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::app {

namespace {

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

void check_starvation(CheckedCase& in) {
  const bool sized = has_all(in, {"bearing.bore", "bearing.outside_diameter"});
  for (const mechanics::Problem& problem :
       bearing::motion::starvation_problems(from_case<bearing::motion::RaceContactParameters>(in), sized))
    in.add_error(problem.key, problem.text);
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
  if ((in.model() & with_balls) != 0) check_balls(in);
  if (in.model() == planetary_drivetrain) check_starvation(in);
}

}  // namespace orbearing::app
