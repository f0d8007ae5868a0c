#include "app/case/duplex_case.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/case/described_case.hpp"
#include "app/case/mistake.hpp"

namespace orbearing::app {

namespace {

namespace duplex = bearing::duplex;

constexpr std::array<const char*, 5> kMeasured{"measured.tilt_x", "measured.tilt_y", "measured.axial_z",
                                               "measured.radial_x", "measured.radial_y"};

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
  if (in.has("spindle.diameter") && in.has("spindle.inertia_x") && !in.has("measured.preload"))
    in.add_error_at("spindle.diameter", "a cylinder together with the inertias of the shaft",
                    "one of the two is required where nothing is identified");
}

void check_measured(CheckedCase& in) {
  if (!in.has("measured.preload")) {
    for (const char* path : kMeasured)
      if (in.has(path)) in.add_error_at(path, "frequencies without measured.preload", "both are required");
    if (in.has("measured.contact_angle"))
      in.add_error_at("measured.contact_angle", "angles without measured.preload", "both are required");
    return;
  }
  const std::size_t pairs = in.list("measured.preload").size();
  const auto check_length = [&](const char* path) {
    if (!in.has(path))
      in.add_error_at("measured.preload", fmt::format("preloads without {}", path), "all are required");
    else if (in.list(path).size() != pairs)
      in.add_error_at(path, fmt::format("{} values for {} preloads", in.list(path).size(), pairs),
                      "one for each preload is required");
  };
  check_length("measured.contact_angle");
  for (const char* path : kMeasured) check_length(path);
  for (const char* path :
       {"identification.contact_angle", "identification.least_distance", "spindle.diameter"})
    if (!in.has(path))
      in.add_error_at("measured.preload", fmt::format("measured frequencies without {}", path),
                      "it is required to identify the shaft");
}

bool is_identified_from(const ResolvedCase& in, double contact_angle) {
  constexpr double same = 1e-9;  // [rad]
  return std::abs(contact_angle - in.quantity("identification.contact_angle")) < same;
}

void check_identification(CheckedCase& in) {
  if (!has_all(in, {"measured.preload", "measured.contact_angle", "identification.contact_angle"})) return;
  for (const double angle : in.list("measured.contact_angle"))
    if (is_identified_from(in, angle)) return;
  in.add_error_at(
      "identification.contact_angle",
      fmt::format("{}, which measured.contact_angle does not hold", in.given("identification.contact_angle")),
      "one of those measured is required");
}

}  // namespace

bearing::Bearing duplex_bearing_of(const ResolvedCase& in, std::optional<double> contact_angle) {
  bearing::Bearing one = from_case(in, bearing::Bearing{.elements = bearing::Balls{}});
  if (contact_angle) one.balls().contact_angle = *contact_angle;
  return one;
}

duplex::Arrangement arrangement_of_pair(const ResolvedCase& in) {
  return value_named<duplex::Arrangement>(in.choice("arrangement")).value();
}

bool is_linear_pair(const ResolvedCase& in) {
  return in.choice("stiffness") == "linear";
}

double pair_approach_of(const ResolvedCase& in, const bearing::Bearing& bearing, double preload) {
  return duplex::approach_under(bearing, preload) + 0.5 * in.quantity("spacer_difference");
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
    const duplex::Cylinder cylinder = *cylinder_of(in);
    shaft.inertia_x = shaft.inertia_y =
        duplex::cylinder_inertia(shaft.mass, cylinder.diameter, cylinder.density);
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

std::optional<duplex::Cylinder> cylinder_of(const ResolvedCase& in) {
  if (!in.has("spindle.diameter")) return std::nullopt;
  return duplex::Cylinder{in.quantity("spindle.diameter"), in.quantity("spindle.density")};
}

std::vector<MeasuredPair> measured_pairs_of(const ResolvedCase& in) {
  std::vector<MeasuredPair> pairs;
  if (!in.has("measured.preload")) return pairs;
  for (std::size_t k = 0; k < in.list("measured.preload").size(); ++k) {
    MeasuredPair pair{in.list("measured.contact_angle")[k], in.list("measured.preload")[k], {}};
    for (std::size_t i = 0; i < kMeasured.size(); ++i) pair.frequency[i] = in.list(kMeasured[i])[k];
    pairs.push_back(pair);
  }
  return pairs;
}

void check_duplex(CheckedCase& in) {
  if (in.model() != duplex_pair) return;
  if (has_all(in, {"stiffness", "operation.shaft_speed"}) && is_linear_pair(in) &&
      (in.quantity("operation.shaft_speed") != 0.0 || in.has("operation.speeds")))
    in.add_error_at(in.has("operation.speeds") ? "operation.speeds" : "operation.shaft_speed",
                    "a rotating shaft together with stiffness: linear",
                    "nonlinear is required: the linear formulas include no speed");
  check_shaft(in);
  check_measured(in);
  check_identification(in);
  if (has_all(in, {"stiffness", "arrangement"}) && is_linear_pair(in) &&
      arrangement_of_pair(in) == duplex::Arrangement::back_to_back)
    in.add_error_at(
        "stiffness", "'linear' for a pair back to back",
        "nonlinear is required: the linear formulas are printed for face-to-face, and are those of a tandem");
}

}  // namespace orbearing::app
