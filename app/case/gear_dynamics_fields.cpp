// Fields of the dynamics of a planetary set: bodies, supports, damping, errors, and the run in time.
#include "app/case/field_table.hpp"

namespace orbearing::app::table {

namespace {

constexpr unsigned drivetrain = planetary_drivetrain;
const std::string kBlock = "gearset.dynamics.";

// Bodies and springs of the set. Where there are several sets, their meshes give mean forces.
constexpr unsigned without_gear_motion = use::rollers_at_rest | use::mesh | use::fmu_bearing;

const Use& of_bodies() {
  static const Use use = Use(use::gears_in_motion | use::natural, without_gear_motion)
                             .felt_too(use::quasi_static, where_pins_are_displaced());
  return use;
}

// Of turning, which planets at rest under their mean loads do not feel.
const Use& of_inertia() {
  static const Use use(use::gears_in_motion | use::natural, without_gear_motion);
  return use;
}

// What modes without damping and load do not feel.
const Use& of_motion() {
  static const Use use(use::gears_in_motion, without_gear_motion | use::natural);
  return use;
}

// Of flanks: which of them touch also decides who carries how much at rest.
const Use& of_flanks() {
  static const Use use = of_motion().felt_too(use::quasi_static, where_pins_are_displaced());
  return use;
}

struct Row {
  std::string path;
  std::string meaning;
  Use use;
  Range range{};
  std::string text{};  // default; empty: derived, or none
  std::string reason{};
};

Field quantity(const Dimension& dimension, Row row) {
  return {.path = kBlock + row.path,
          .kind = Kind::quantity,
          .meaning = std::move(row.meaning),
          .use = std::move(row.use),
          .models = drivetrain,
          .dimension = dimension,
          .range = row.range,
          .default_text = std::move(row.text),
          .default_reason = std::move(row.reason)};
}

Field number(Row row) {
  Field field = quantity({}, std::move(row));
  field.kind = Kind::number;
  return field;
}

constexpr Range positive(double most) {
  return {.least = 0.0, .most = most, .least_allowed = false};
}

Field needed_without_teeth(Field field) {
  field.required_by = toothless_set;
  return field;
}

void add_body(std::vector<Field>& fields, const std::string& member, const std::string& radius) {
  fields.push_back(needed_without_teeth(quantity(
      dimension::mass, {member + ".mass", "mass of the " + member + "; derived from the teeth if absent",
                        of_bodies(), positive(1e6)})));
  fields.push_back(needed_without_teeth(
      quantity(dimension::mass, {member + ".equivalent_mass",
                                 "moment of inertia of the " + member + " over the square of its " + radius +
                                     "; derived from the teeth if absent",
                                 of_inertia(), positive(1e6)})));
}

void add_central(std::vector<Field>& fields, const std::string& member, const std::string& radius,
                 const std::string& support, const std::string& reason) {
  add_body(fields, member, radius);
  fields.push_back(
      quantity(dimension::stiffness, {member + ".support_stiffness",
                                      "stiffness that holds the " + member + " in its place, 0: floating",
                                      of_bodies(),
                                      {0.0, 1e13},
                                      support,
                                      reason}));
  fields.push_back(quantity(dimension::stiffness,
                            {member + ".torsional_stiffness",
                             "stiffness against rotation of the " + member + ", on " + radius + " x angle",
                             of_bodies(),
                             {0.0, 1e13},
                             "0 N/m",
                             "free to turn; a fixed member is then held rigidly"}));
}

void add_bodies(std::vector<Field>& fields) {
  add_central(fields, "sun", "base radius", "1e8 N/m", "a sun on a slender shaft");
  add_central(fields, "ring", "base radius", "1e9 N/m", "a ring bolted to its housing");
  add_central(fields, "carrier", "centre distance", "5e8 N/m", "two bearings of the carrier");
  add_body(fields, "planet", "base radius");
  // The pin spans the walls: its stiffness follows from them where support.stiffness is left out.
  const Use of_walls =
      Use(use::gears_in_motion | use::natural | use::rollers_in_motion, use::rollers_at_rest | use::mesh)
          .felt_too(use::quasi_static, where_pins_are_displaced());
  Field bearing =
      quantity(dimension::stiffness,
               {"planet.bearing_stiffness",
                "radial stiffness of all bearings of a planet and their pins; of the given bearing "
                "at its mean load if absent",
                // Coupled gears start on it; --fidelity dynamic fits a law of its own, and warns.
                Use(use::gears | use::natural | use::fmu_gearset | use::co_simulated | use::monolithic,
                    without_gear_motion),
                positive(1e13), "3e8 N/m", "two roller bearings of a planet of some 70 mm, loaded"});
  bearing.default_without_bearing = true;
  fields.push_back(std::move(bearing));
  fields.push_back(number({"carrier.plate_ratio",
                           "thickness of both side plates of the carrier as a share of the face width",
                           of_walls,
                           {.least = 0.0, .most = 10.0, .least_allowed = false},
                           "0.5",
                           "the carrier's design is not given; discs that reach to the planets' rims"}));
}

void add_meshes(std::vector<Field>& fields) {
  for (const std::string mesh : {"sun", "ring"})
    fields.push_back(needed_without_teeth(quantity(
        dimension::stiffness,
        {"mesh_stiffness." + mesh, "constant stiffness of the " + mesh + " mesh; from the teeth if absent",
         of_bodies(), positive(1e13)})));
  fields.push_back(number({"damping_ratio.mesh",
                           "damping of both gears turning on their mesh",
                           of_motion(),
                           {0.0, 2.0},
                           "0.07",
                           "usual of oiled steel gears"}));
  fields.push_back(number({"damping_ratio.bearing",
                           "damping of a planet on its bearings; bearings of rollers have their own",
                           Use(use::gears, without_gear_motion | use::natural | use::fmu_gearset),
                           {0.0, 2.0},
                           "0.05",
                           "oiled roller bearings in a steel structure"}));
  fields.push_back(number({"damping_ratio.support",
                           "damping of a member on its support",
                           of_motion(),
                           {0.0, 2.0},
                           "0.05",
                           "bolted steel structure"}));
  fields.push_back(quantity(dimension::length, {"backlash",
                                                "play between the flanks along the line of action",
                                                of_flanks(),
                                                {0.0, 100.0},
                                                "0.1 mm",
                                                "usual of modules of a few millimetres"}));
  fields.push_back({.path = kBlock + "separation",
                    .kind = Kind::flag,
                    .meaning = "teeth push only and can part; false: they also pull",
                    .use = of_flanks(),
                    .models = drivetrain,
                    .default_text = "true",
                    .default_reason = "nothing left out"});
}

Field lengths(std::string path, std::string meaning, const Use& use) {
  return {.path = kBlock + std::move(path),
          .kind = Kind::list,
          .meaning = std::move(meaning),
          .use = use,
          .models = drivetrain,
          .dimension = dimension::small_length,
          .range = {-1e5, 1e5},
          .element = Kind::quantity};
}

void add_errors(std::vector<Field>& fields) {
  for (const std::string mesh : {"sun", "ring"})
    fields.push_back(lengths("transmission_error." + mesh,
                             "missing material on the flanks of the " + mesh +
                                 " mesh at equal steps of a mesh period that begins as a pair touches",
                             of_flanks()));
  // Planets share the load unevenly in every rung of one set. What crown varies is a planet of the mean load,
  // and sets among several, which have shafts in place of a driving member, carry alike: both warn.
  const Use of_pins =
      Use(use::gears_in_motion | use::quasi_static, use::natural | use::mesh | use::fmu_bearing)
          .when(where_given({"input.member"}));
  fields.push_back(lengths("pin_error.radial", "how far each pin stands outward of its place", of_pins));
  fields.push_back(lengths("pin_error.tangential",
                           "how far each pin stands ahead of its place in the sense of rotation", of_pins));
}

void add_run(std::vector<Field>& fields) {
  const Use of_run_up(use::gears | use::fmu_gearset, without_gear_motion | use::natural);
  const Use of_run(use::gears, without_gear_motion | use::natural | use::in_time | use::fmu_gearset);
  fields.push_back(number({"run_up.from", "speed at the start as a share of input.speed",
                           of_run_up.when(where_given({"gearset.dynamics.run_up.duration"})), positive(10.0),
                           "1", "no run-up"}));
  fields.push_back(
      quantity(dimension::time,
               {"run_up.duration", "time to reach input.speed", of_run_up, {0.0, 1e4}, "0 s", "no run-up"}));
  Field observed = number({"observed_periods",
                           "mesh periods that are averaged once steady",
                           of_run,
                           {1, 1000000},
                           "200",
                           "many turns of the slowest vibration"});
  Field settling = number({"settling_periods",
                           "mesh periods allowed to become steady",
                           of_run,
                           {100, 10000000},
                           "4000",
                           "several times what damping takes"});
  observed.kind = settling.kind = Kind::integer;
  fields.push_back(std::move(observed));
  fields.push_back(std::move(settling));
}

}  // namespace

void add_gear_dynamics_fields(std::vector<Field>& fields) {
  add_bodies(fields);
  add_meshes(fields);
  add_errors(fields);
  add_run(fields);
}

}  // namespace orbearing::app::table
