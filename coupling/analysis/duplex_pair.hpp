// A rigid shaft on two equal, preloaded bearings of balls: the model duplex-pair.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "bearing/duplex/pair.hpp"
#include "bearing/duplex/shaft.hpp"
#include "bearing/equilibrium/jones_balls.hpp"
#include "bearing/life/standard_life.hpp"
#include "bearing/parameters.hpp"
#include "coupling/analysis/bearing_rows.hpp"
#include "coupling/analysis/stated_capacities.hpp"
#include "mechanics/conditional.hpp"
#include "mechanics/problem.hpp"

namespace orbearing::analysis {

/// A shaft that is a solid cylinder.
struct CylindricalShaft {
  double diameter = 0.0;    // [m]
  double density = 7850.0;  // [kg/m^3]
};
template <class Visitor>
void describe(Visitor& visit, CylindricalShaft& m) {
  using namespace described;
  members(visit, m,
          input(m.diameter, "diameter", "diameter of a solid cylinder equivalent to the shaft",
                {.dimension = dimension::length, .range = positive(1e6)}),
          input(m.density, "density", "density of that cylinder",
                {.dimension = dimension::density, .range = {100.0, 25000.0}, .reason = "steel"}));
}

/// A shaft of any form.
struct ShaftOfInertia {
  double inertia_x = 0.0;  // [kg m^2]  about diameters through the mass centre
  double inertia_y = 0.0;  // [kg m^2]
};
template <class Visitor>
void describe(Visitor& visit, ShaftOfInertia& m) {
  using namespace described;
  const auto inertia = [](double& member, const std::string& axis) {
    return input(member, "inertia_" + axis,
                 "inertia of the shaft about " + axis +
                     " through its mass centre; left out: that of a cylinder of spindle.diameter",
                 {.dimension = dimension::inertia, .range = positive(1e6)});
  };
  members(visit, m, inertia(m.inertia_x, "x"), inertia(m.inertia_y, "y"));
}

/// The shaft with all that moves as one with it.
struct Spindle {
  double mass = 0.0;          // [kg]
  double first_lever = 0.0;   // [m]
  double second_lever = 0.0;  // [m]
  std::variant<CylindricalShaft, ShaftOfInertia> form{};

  bearing::duplex::Shaft shaft() const;
};
template <class Visitor>
void describe(Visitor& visit, Spindle& m) {
  using namespace described;
  const auto lever = [](double& member, const std::string& row) {
    return input(member, row + "_lever", "distance of the " + row + " row from the shaft's mass centre",
                 {.dimension = dimension::length, .range = {-1e4, 1e4}});
  };
  members(visit, m,
          input(m.mass, "mass", "mass of the shaft", {.dimension = dimension::mass, .range = positive(1e6)}),
          lever(m.first_lever, "first"), lever(m.second_lever, "second"), either(m.form));
}

struct FixedHousing {};
template <class Visitor>
void describe(Visitor&, FixedHousing&) {}

/// Constants for the linear formulas; those of the shaft where they are not stated.
struct LinearConstants {
  std::optional<double> mass{};          // [kg]
  std::optional<double> first_lever{};   // [m]
  std::optional<double> second_lever{};  // [m]
  std::optional<double> inertia_x{};     // [kg m^2]
  std::optional<double> inertia_y{};     // [kg m^2]
};
template <class Visitor>
void describe(Visitor& visit, LinearConstants& m) {
  using namespace described;
  const auto constant = [](std::optional<double>& member, const char* key, const std::string& meaning,
                           const Dimension& of, Range range) {
    return input(member, key, meaning + " for the linear formulas; left out: the shaft's",
                 {.dimension = of, .range = range});
  };
  const Range above_zero = positive(1e6), lever{-1e4, 1e4};
  members(visit, m, constant(m.mass, "mass", "mass", dimension::mass, above_zero),
          constant(m.first_lever, "first_lever", "distance of the first row from the mass centre",
                   dimension::length, lever),
          constant(m.second_lever, "second_lever", "distance of the second row from the mass centre",
                   dimension::length, lever),
          constant(m.inertia_x, "inertia_x", "inertia about x", dimension::inertia, above_zero),
          constant(m.inertia_y, "inertia_y", "inertia about y", dimension::inertia, above_zero));
}

/// Speeds of the shaft.
struct ShaftOperation {
  double shaft_speed = 0.0;      // [rad/s]
  std::vector<double> speeds{};  // [rad/s]  over which results are tabulated
};
template <class Visitor>
void describe(Visitor& visit, ShaftOperation& m) {
  using namespace described;
  members(visit, m,
          input(m.shaft_speed, "shaft_speed", "speed of the inner ring",
                {.dimension = dimension::angular_speed, .range = {-1e6, 1e6}, .reason = "a stationary ring"}),
          input(m.speeds, "speeds",
                "speeds of the inner ring over which run and stiffness tabulate the equilibrium, and modes "
                "and run of a duplex pair its natural frequencies",
                {.dimension = dimension::angular_speed, .range = {-1e6, 1e6}}));
}

enum class PairStiffness { nonlinear, linear };
constexpr described::Names<PairStiffness, 2> names_of(PairStiffness) {
  return {{{PairStiffness::nonlinear, "nonlinear"}, {PairStiffness::linear, "linear"}}};
}

/// The shaft on the pair under its preload.
struct PreloadedPair {
  bearing::duplex::Arrangement arrangement = bearing::duplex::Arrangement::face_to_face;
  double preload = 0.0;            // [N]
  double spacer_difference = 0.0;  // [m]
  PairStiffness stiffness = PairStiffness::nonlinear;
  bearing::Bearing bearing{.elements = bearing::Balls{}};  // either of both
  Spindle spindle;
  std::variant<FixedHousing, bearing::duplex::Housing> housing{};
  LinearConstants linear;
  ShaftOperation operation;
  bearing::equilibrium::BallInertia ball_inertia;

  bool rotates() const;  // at any of its speeds
  bool is_linear() const { return stiffness == PairStiffness::linear; }
  /// Whether the linear formulas hold: a stationary shaft, rows that do not separate.
  bool has_linear_formulas() const;
  bearing::duplex::Shaft linear_shaft() const;
  std::optional<bearing::duplex::Housing> free_housing() const;
  /// [m]  of each row. Throws as duplex::approach_under.
  double approach() const;
  bearing::equilibrium::RowMotion motion_at(double speed) const;

  static std::vector<mechanics::Conditional<PreloadedPair>> conditions();
};
template <class Visitor>
void describe(Visitor& visit, PreloadedPair& m) {
  using namespace described;
  members(
      visit, m, input(m.arrangement, "arrangement", "arrangement of both bearings"),
      input(m.preload, "preload", "axial load with which each row is pressed",
            {.dimension = dimension::force, .range = {0.0, 1e9}, .reason = "spacers alone press the rows"}),
      input(m.spacer_difference, "spacer_difference",
            "length difference of the spacers, which presses both rows further than the preload",
            {.dimension = dimension::small_length,
             .range = {-1000.0, 1000.0},
             .reason = "preload is stated as a load"}),
      input(m.stiffness, "stiffness",
            "stiffness of the pair: of its nonlinear equilibrium, or by the linear formulas as published, "
            "with the constants under linear",
            {.reason = "nothing left out, and rows that face each other"}),
      part(m.bearing, [&] { describe_inside(visit, m.bearing); }), block(m.spindle, "spindle"),
      either(m.housing), block(m.linear, "linear"), block(m.operation, "operation"), part(m.ball_inertia));
}

/// The machine of the model duplex-pair.
struct DuplexPair {
  static constexpr std::string_view model = "duplex-pair";

  PreloadedPair preloaded;
  StatedCapacities capacities;
  bearing::duplex::ResponsePoint response;

  static std::vector<mechanics::Conditional<DuplexPair>> conditions();
};
template <class Visitor>
void describe(Visitor& visit, DuplexPair& m) {
  described::members(visit, m, described::part(m.preloaded), described::part(m.capacities),
                     described::block(m.response, "response"));
}

/// Inconsistencies of the inputs.
mechanics::Problems problems(const DuplexPair& machine);

}  // namespace orbearing::analysis
