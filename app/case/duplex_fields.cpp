// Fields of a duplex pair: how it is preloaded, what it carries, and what was measured on it.
#include "app/case/field_table.hpp"
#include "app/case/use_conditions.hpp"

namespace orbearing::app::table {

namespace {

constexpr unsigned by_both = use::duplex_modes | use::duplex_run;

Field pair_quantity(const Dimension& dimension, std::string path, std::string meaning, Range range,
                    unsigned used_by = by_both) {
  return {.path = std::move(path),
          .kind = Kind::quantity,
          .meaning = std::move(meaning),
          .use = Use(used_by, by_both & ~used_by),
          .models = duplex_pair,
          .dimension = dimension,
          .range = range};
}

Field with_default(Field field, std::string text, std::string reason) {
  field.default_text = std::move(text);
  field.default_reason = std::move(reason);
  return field;
}

Field required(Field field) {
  field.required_by = duplex_pair;
  return field;
}

Field under(Condition condition, Field field) {
  field.use = field.use.when(std::move(condition));
  return field;
}

void add_preload(std::vector<Field>& fields) {
  fields.push_back({.path = "arrangement",
                    .kind = Kind::choice,
                    .meaning = "arrangement of both bearings",
                    .use = Use(by_both, 0),
                    .models = duplex_pair,
                    .required_by = duplex_pair,
                    .choices = {"face-to-face", "back-to-back", "tandem"}});
  fields.push_back(with_default(
      pair_quantity(dimension::force, "preload", "axial load with which each row is pressed", {0.0, 1e9}),
      "0 N", "spacers alone press the rows"));
  fields.push_back(with_default(
      pair_quantity(dimension::small_length, "spacer_difference",
                    "length difference of the spacers, which presses both rows further than the preload",
                    {-1000.0, 1000.0}),
      "0 um", "preload is stated as a load"));
  fields.push_back({.path = "stiffness",
                    .kind = Kind::choice,
                    .meaning = "stiffness of the pair: of its nonlinear equilibrium, or by the linear "
                               "formulas as published, with the constants under linear",
                    .use = Use(by_both, 0),
                    .models = duplex_pair,
                    .choices = {"nonlinear", "linear"},
                    .default_text = "nonlinear",
                    .default_reason = "nothing left out, and rows that face each other"});
}

void add_shaft(std::vector<Field>& fields) {
  const Range above_zero = positive(1e6);
  fields.push_back(required(pair_quantity(dimension::mass, "spindle.mass", "mass of the shaft", above_zero)));
  for (const char* row : {"first", "second"})
    fields.push_back(required(pair_quantity(
        dimension::length, std::string("spindle.") + row + "_lever",
        std::string("distance of the ") + row + " row from the shaft's mass centre", {-1e4, 1e4})));
  for (const char* axis : {"x", "y"})
    fields.push_back(
        pair_quantity(dimension::inertia, std::string("spindle.inertia_") + axis,
                      std::string("inertia of the shaft about ") + axis +
                          " through its mass centre; left out: that of a cylinder of spindle.diameter",
                      above_zero));
  fields.push_back(pair_quantity(dimension::length, "spindle.diameter",
                                 "diameter of a solid cylinder equivalent to the shaft", above_zero));
  fields.push_back(with_default(
      under(where_given({"spindle.diameter"}), pair_quantity(dimension::density, "spindle.density",
                                                             "density of that cylinder", {100.0, 25000.0})),
      "7850 kg/m3", "steel"));
  fields.push_back(pair_quantity(dimension::mass, "housing.mass",
                                 "mass of a housing that is free to move; left out: fixed housing",
                                 above_zero));
  fields.push_back(pair_quantity(dimension::inertia, "housing.inertia",
                                 "its inertia about a diameter through its mass centre", above_zero));
}

void add_linear(std::vector<Field>& fields) {
  const Range above_zero = positive(1e6);
  const auto add = [&](const Dimension& dimension, const char* name, const char* meaning, Range range) {
    Field field =
        under(where("arrangement", {"face-to-face", "tandem"}),
              pair_quantity(dimension, std::string("linear.") + name,
                            std::string(meaning) + " for the linear formulas; left out: the shaft's", range,
                            use::duplex_run));
    field = under(where_true(pair_run_has_linear_column,
                             "where operation.shaft_speed is 0, or together with measured.preload"),
                  std::move(field));
    field.use = field.use.used_too(use::duplex_modes,
                                   where_true(pair_has_linear_column, "where operation.shaft_speed is 0"));
    fields.push_back(std::move(field));
  };
  add(dimension::mass, "mass", "mass", above_zero);
  add(dimension::length, "first_lever", "distance of the first row from the mass centre", {-1e4, 1e4});
  add(dimension::length, "second_lever", "distance of the second row from the mass centre", {-1e4, 1e4});
  add(dimension::inertia, "inertia_x", "inertia about x", above_zero);
  add(dimension::inertia, "inertia_y", "inertia about y", above_zero);
}

Field measured_list(const Dimension& dimension, std::string name, std::string meaning, Range range) {
  return {.path = "measured." + std::move(name),
          .kind = Kind::list,
          .meaning = std::move(meaning),
          .use = Use(use::duplex_run, use::duplex_modes),
          .models = duplex_pair,
          .dimension = dimension,
          .range = range,
          .element = Kind::quantity};
}

void add_measured(std::vector<Field>& fields) {
  fields.push_back(measured_list(dimension::angle, "contact_angle",
                                 "nominal contact angles of the pairs that were measured", {0.0, 85.0}));
  fields.push_back(measured_list(dimension::force, "preload", "their preloads", positive(1e9)));
  const auto add = [&](const char* name, const char* motion) {
    fields.push_back(measured_list(dimension::frequency, name,
                                   std::string("their natural frequencies of ") + motion, positive(1000.0)));
  };
  add("tilt_x", "rotation about x");
  add("tilt_y", "rotation about y");
  add("axial_z", "translation along the shaft");
  add("radial_x", "translation along x");
  add("radial_y", "translation along y");
  fields.push_back(under(where_given({"measured.preload"}),
                         pair_quantity(dimension::angle, "identification.contact_angle",
                                       "contact angle of the pairs whose frequencies identify the shaft",
                                       {0.0, 85.0}, use::duplex_run)));
  fields.push_back(
      under(where_given({"measured.preload"}),
            pair_quantity(dimension::length, "identification.least_distance",
                          "least distance of both rows that identification may find: the width of a "
                          "bearing",
                          positive(1e4), use::duplex_run)));
}

void add_response(std::vector<Field>& fields) {
  fields.push_back(
      {.path = "response.loss_factor",
       .kind = Kind::number,
       .meaning = "structural damping of the frequency response: loss factor eta of all stiffness",
       .use = Use(use::duplex_run, use::duplex_modes),
       .models = duplex_pair,
       .range = {.least = 0.0, .most = 1.0, .least_allowed = false},
       .default_text = "0.005",
       .default_reason = "steel, by the source of the model"});
  fields.push_back(with_default(pair_quantity(dimension::length, "response.position",
                                              "position of the impact and of the measured motion across the "
                                              "shaft, from its mass centre towards the first row",
                                              {-1e4, 1e4}, use::duplex_run),
                                "0 mm", "at the mass centre"));
}

}  // namespace

void add_duplex_fields(std::vector<Field>& fields) {
  add_preload(fields);
  add_shaft(fields);
  add_linear(fields);
  add_measured(fields);
  add_response(fields);
}

}  // namespace orbearing::app::table
