// Fields of a duplex pair: how it is preloaded, and what it carries.
#include "app/case/field_table.hpp"
#include "app/case/use_conditions.hpp"

namespace orbearing::app::table {

namespace {

const Use& by_both() {
  static const Use use(use::duplex_modes | use::duplex_run, 0);
  return use;
}
const Use& by_run() {
  static const Use use(use::duplex_run, use::duplex_modes);
  return use;
}

void add_preload(Rows& rows) {
  rows.choice("arrangement", "arrangement of both bearings", by_both(),
              {"face-to-face", "back-to-back", "tandem"})
      .required();
  rows.quantity("preload", "axial load with which each row is pressed", by_both(), dimension::force,
                {0.0, 1e9})
      .by_default("0 N", "spacers alone press the rows");
  rows.quantity("spacer_difference",
                "length difference of the spacers, which presses both rows further than the preload",
                by_both(), dimension::small_length, {-1000.0, 1000.0})
      .by_default("0 um", "preload is stated as a load");
  rows.choice("stiffness",
              "stiffness of the pair: of its nonlinear equilibrium, or by the linear formulas as published, "
              "with the constants under linear",
              by_both(), {"nonlinear", "linear"})
      .by_default("nonlinear", "nothing left out, and rows that face each other");
}

void add_shaft(Rows& rows) {
  const Range above_zero = positive(1e6);
  rows.quantity("spindle.mass", "mass of the shaft", by_both(), dimension::mass, above_zero).required();
  for (const std::string row : {"first", "second"})
    rows.quantity("spindle." + row + "_lever", "distance of the " + row + " row from the shaft's mass centre",
                  by_both(), dimension::length, {-1e4, 1e4})
        .required();
  for (const std::string axis : {"x", "y"})
    rows.quantity("spindle.inertia_" + axis,
                  "inertia of the shaft about " + axis +
                      " through its mass centre; left out: that of a cylinder of spindle.diameter",
                  by_both(), dimension::inertia, above_zero);
  rows.quantity("spindle.diameter", "diameter of a solid cylinder equivalent to the shaft", by_both(),
                dimension::length, above_zero);
  rows.quantity("spindle.density", "density of that cylinder", by_both(), dimension::density,
                {100.0, 25000.0})
      .under(where_given({"spindle.diameter"}))
      .by_default("7850 kg/m3", "steel");
  rows.quantity("housing.mass", "mass of a housing that is free to move; left out: fixed housing", by_both(),
                dimension::mass, above_zero);
  rows.quantity("housing.inertia", "its inertia about a diameter through its mass centre", by_both(),
                dimension::inertia, above_zero);
}

void add_linear(Rows& rows) {
  const Range above_zero = positive(1e6), lever{-1e4, 1e4};
  const Use linear = by_both()
                         .when(where("arrangement", {"face-to-face", "tandem"}))
                         .when(where_true(pair_has_linear_column, "where operation.shaft_speed is 0"));
  const auto add = [&](const Dimension& dimension, const char* name, const char* meaning, Range range) {
    rows.quantity(std::string("linear.") + name,
                  std::string(meaning) + " for the linear formulas; left out: the shaft's", linear, dimension,
                  range);
  };
  add(dimension::mass, "mass", "mass", above_zero);
  add(dimension::length, "first_lever", "distance of the first row from the mass centre", lever);
  add(dimension::length, "second_lever", "distance of the second row from the mass centre", lever);
  add(dimension::inertia, "inertia_x", "inertia about x", above_zero);
  add(dimension::inertia, "inertia_y", "inertia about y", above_zero);
}

void add_response(Rows& rows) {
  rows.number("response.loss_factor",
              "structural damping of the frequency response: loss factor eta of all stiffness", by_run(),
              positive(1.0))
      .by_default("0.005", "steel, by the source of the model");
  rows.quantity("response.position",
                "position of the impact and of the measured motion across the shaft, from its mass centre "
                "towards the first row",
                by_run(), dimension::length, {-1e4, 1e4})
      .by_default("0 mm", "at the mass centre");
}

}  // namespace

void add_duplex_fields(std::vector<Field>& fields) {
  Rows rows(fields, duplex_pair);
  add_preload(rows);
  add_shaft(rows);
  add_linear(rows);
  add_response(rows);
}

}  // namespace orbearing::app::table
