// Fields of load, material, contact, lubricant, switches and numerics.
#include "app/case/field_table.hpp"

namespace orbearing::app::table {

namespace {

constexpr unsigned drivetrain = planetary_drivetrain;
constexpr unsigned single_bearing = roller_bearing | ball_bearing;

const Use& by_static_load() {
  static const Use use(use::static_load, 0);
  return use;
}

// What the loads of the rollers and with them stiffness and life follow from.
const Use& of_loads() {
  static const Use use(use::lives | use::bearings_as_springs | use::fmu_bearing, use::mesh);
  return use;
}

void add_operation(std::vector<Field>& fields) {
  constexpr Range speeds{-1e6, 1e6};
  fields.push_back({.path = "load.radial",
                    .kind = Kind::quantity,
                    .meaning = "radial load on the bearing",
                    .use = by_static_load(),
                    .models = single_bearing,
                    .required_by = single_bearing,
                    .dimension = dimension::force,
                    .range = {0.0, 1e9}});
  fields.push_back({.path = "operation.shaft_speed",
                    .kind = Kind::quantity,
                    .meaning = "speed of the inner ring",
                    .use = by_static_load().when(where_given({"lubricant.kinematic_viscosity"})),
                    .models = single_bearing,
                    .dimension = dimension::angular_speed,
                    .range = speeds,
                    .default_text = "0 rpm",
                    .default_reason = "a static load"});
  fields.push_back({.path = "operation.outer_speed",
                    .kind = Kind::quantity,
                    .meaning = "speed of the outer ring",
                    .use = by_static_load().when(where_given({"lubricant.kinematic_viscosity"})),
                    .models = single_bearing,
                    .dimension = dimension::angular_speed,
                    .range = speeds,
                    .default_text = "0 rpm",
                    .default_reason = "a static load"});
  fields.push_back({.path = "operation.turning_race",
                    .kind = Kind::choice,
                    .meaning = "race that turns relative to the load",
                    .use = by_static_load(),
                    .models = single_bearing,
                    .choices = {"inner", "outer"},
                    .default_text = "inner",
                    .default_reason = "a load that stands still on a turning shaft"});
}

void add_material(std::vector<Field>& fields) {
  fields.push_back({.path = "material.youngs_modulus",
                    .kind = Kind::quantity,
                    .meaning = "Young's modulus of gears, rings and rollers",
                    .use = Use(use::all, 0),
                    .models = every_model,
                    .dimension = dimension::stress,
                    .range = {1.0, 1000.0},
                    .default_text = "206 GPa",
                    .default_reason = "rolling bearing steel"});
  fields.push_back({.path = "material.poisson_ratio",
                    .kind = Kind::number,
                    .meaning = "Poisson's ratio of gears, rings and rollers",
                    .use = Use(use::all, 0),
                    .models = every_model,
                    .range = {.least = 0.0, .most = 0.5, .most_allowed = false},
                    .default_text = "0.3",
                    .default_reason = "rolling bearing steel"});
  fields.push_back(
      {.path = "material.density",
       .kind = Kind::quantity,
       .meaning = "density of gears, rings and rollers",
       .use = Use(use::lives | use::bearings_as_springs | use::fmu_bearing, use::mesh | use::static_load),
       .models = every_model,
       .dimension = dimension::density,
       .range = {100.0, 25000.0},
       .default_text = "7850 kg/m3",
       .default_reason = "rolling bearing steel"});
}

void add_contact(std::vector<Field>& fields) {
  fields.push_back(
      {.path = "contact.law",
       .kind = Kind::choice,
       .meaning = "stiffness of roller and race: Palmgren's for each contact, or ISO/TS 16281's for both",
       .use = Use(use::lives | use::bearings_as_springs | use::fmu_bearing | use::static_load, use::mesh),
       .choices = {"palmgren", "iso16281"},
       .default_text = "palmgren",
       .default_reason = "each contact on its own, as the film needs it"});
  fields.push_back(
      {.path = "lubricant.viscosity",
       .kind = Kind::quantity,
       .meaning = "dynamic viscosity at the inlet, at running temperature",
       .use = Use(use::lives | use::bearings_as_springs | use::fmu_bearing, use::mesh | use::static_load),
       .dimension = dimension::viscosity,
       .range = {1e-5, 100.0},
       .default_text = "0.01 Pa.s",
       .default_reason = "a gear oil when warm"});
  fields.push_back(
      {.path = "lubricant.pressure_viscosity",
       .kind = Kind::quantity,
       .meaning = "pressure-viscosity coefficient at running temperature",
       .use = Use(use::lives | use::bearings_as_springs | use::fmu_bearing, use::mesh | use::static_load),
       .dimension = dimension::pressure_viscosity,
       .range = {0.1, 100.0},
       .default_text = "1.5e-8 Pa-1",
       .default_reason = "a mineral oil when warm"});
  fields.push_back(
      {.path = "film.enabled",
       .kind = Kind::flag,
       .meaning = "the film takes part in the approach",
       .use = Use(use::lives | use::bearings_as_springs | use::fmu_bearing, use::mesh, use::static_load),
       .default_text = "false",
       .default_reason = "dry contacts first; the film's worth is shown apart"});
  fields.push_back(
      {.path = "life.lambda",
       .kind = Kind::number,
       .meaning = "reduction factor of the capacity: the product lambda nu of ISO/TR 1281-1",
       .use = Use(use::lives | use::fmu_bearing | use::static_load, use::bearings_as_springs | use::mesh),
       .range = {.least = 0.0, .most = 1.0, .least_allowed = false},
       .default_text = "0.83",
       .default_reason = "the product for cylindrical roller bearings in ISO/TR 1281-1"});
}

void add_switch(std::vector<Field>& fields, std::string path, std::string meaning, const Use& use) {
  fields.push_back({.path = std::move(path),
                    .kind = Kind::flag,
                    .meaning = std::move(meaning),
                    .use = use,
                    .models = drivetrain,
                    .default_text = "true",
                    .default_reason = "nothing left out"});
}

}  // namespace

void add_condition_fields(std::vector<Field>& fields) {
  add_operation(fields);
  add_material(fields);
  add_contact(fields);
  add_switch(fields, "inertia.own_orbit", "inertia of the rollers' orbit about the bearing", of_loads());
  add_switch(fields, "inertia.coriolis", "Coriolis terms of the carrier frame", of_loads());
  add_switch(fields, "inertia.carrier_centrifugal", "centrifugal terms of the carrier frame", of_loads());
  add_switch(fields, "inertia.euler", "terms of the carrier's angular acceleration",
             Use(use::dynamic | use::dynamic_of_sets | use::gears | use::fmu_gearset | use::fmu_bearing,
                 use::rollers_at_rest | use::co_simulated | use::monolithic | use::natural | use::mesh));
  fields.push_back(
      {.path = "numerics.cage_positions",
       .kind = Kind::integer,
       .meaning = "positions of the roller set over one roller pitch that are averaged",
       .use = Use(use::rollers_at_rest | use::one_set_in_time | use::bearings_as_springs,
                  use::dynamic_of_sets | use::mesh | use::fmu_bearing),
       .models = drivetrain,
       .range = {1, 10000},
       .default_text = "16",
       .default_reason = "evenly over one pitch, so that the place of the rollers averages out"});
}

}  // namespace orbearing::app::table
