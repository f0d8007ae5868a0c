#include "app/case/duplex_case.hpp"

#include <fmt/format.h>

#include "app/case/described_case.hpp"
#include "app/case/mistake.hpp"

namespace orbearing::app {

namespace {

namespace duplex = bearing::duplex;

// Two values that mean something together alone.
void check_both(CheckedCase& in, const char* one, const char* other) {
  if (in.has(one) != in.has(other))
    in.add_error_at(in.has(one) ? one : other, fmt::format("no {} with it", in.has(one) ? other : one),
                    "both or none are required");
}

void check_shaft(CheckedCase& in) {
  check_both(in, "spindle.inertia_x", "spindle.inertia_y");
  check_both(in, "housing.mass", "housing.inertia");
  if (!in.has("spindle.diameter") && !in.has("spindle.inertia_x") && in.has("spindle.mass"))
    in.add_error_at(
        "spindle.mass", "a shaft without inertia",
        "spindle.inertia_x and spindle.inertia_y, or spindle.diameter of a solid cylinder, are required");
  if (in.has("spindle.diameter") && in.has("spindle.inertia_x"))
    in.add_error_at("spindle.diameter", "a cylinder together with the inertias of the shaft",
                    "one of the two is required");
}

}  // namespace

bearing::Bearing duplex_bearing_of(const ResolvedCase& in) {
  return from_case(in, bearing::Bearing{.elements = bearing::Balls{}});
}

duplex::Arrangement arrangement_of_pair(const ResolvedCase& in) {
  return value_named<duplex::Arrangement>(in.choice("arrangement")).value();
}

bool is_linear_pair(const ResolvedCase& in) {
  return in.choice("stiffness") == "linear";
}

double pair_approach_of(const ResolvedCase& in, const bearing::Bearing& bearing) {
  return duplex::approach_under(bearing, in.quantity("preload")) + 0.5 * in.quantity("spacer_difference");
}

bearing::equilibrium::RowMotion pair_motion_of(const ResolvedCase& in) {
  return {.speeds = {.inner = in.quantity("operation.shaft_speed")},
          .inertia = from_case<bearing::equilibrium::BallInertia>(in)};
}

duplex::Shaft duplex_shaft_of(const ResolvedCase& in) {
  duplex::Shaft shaft{.mass = in.quantity("spindle.mass"),
                      .levers = {in.quantity("spindle.first_lever"), in.quantity("spindle.second_lever")}};
  if (in.has("spindle.inertia_x")) {
    shaft.inertia_x = in.quantity("spindle.inertia_x");
    shaft.inertia_y = in.quantity("spindle.inertia_y");
  } else {
    shaft.inertia_x = shaft.inertia_y = duplex::cylinder_inertia(
        shaft.mass, in.quantity("spindle.diameter"), in.quantity("spindle.density"));
  }
  return shaft;
}

duplex::Shaft linear_shaft_of(const ResolvedCase& in) {
  duplex::Shaft shaft = duplex_shaft_of(in);
  const auto replace = [&](const char* path, double& value) {
    if (in.has(path)) value = in.quantity(path);
  };
  replace("linear.mass", shaft.mass);
  replace("linear.first_lever", shaft.levers.first);
  replace("linear.second_lever", shaft.levers.second);
  replace("linear.inertia_x", shaft.inertia_x);
  replace("linear.inertia_y", shaft.inertia_y);
  return shaft;
}

std::optional<duplex::Housing> housing_of(const ResolvedCase& in) {
  if (!in.has("housing.mass")) return std::nullopt;
  return duplex::Housing{in.quantity("housing.mass"), in.quantity("housing.inertia")};
}

void check_duplex(CheckedCase& in) {
  if (in.model() != duplex_pair) return;
  if (has_all(in, {"stiffness", "operation.shaft_speed"}) && is_linear_pair(in) &&
      (in.quantity("operation.shaft_speed") != 0.0 || in.has("operation.speeds")))
    in.add_error_at(in.has("operation.speeds") ? "operation.speeds" : "operation.shaft_speed",
                    "a rotating shaft together with stiffness: linear",
                    "nonlinear is required: the linear formulas include no speed");
  check_shaft(in);
  if (has_all(in, {"stiffness", "arrangement"}) && is_linear_pair(in) &&
      arrangement_of_pair(in) == duplex::Arrangement::back_to_back)
    in.add_error_at(
        "stiffness", "'linear' for a pair back to back",
        "nonlinear is required: the linear formulas are printed for face-to-face, and are those of a tandem");
}

}  // namespace orbearing::app
