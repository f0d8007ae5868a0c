// Fields of one bearing under a static load: balls and grooves, loads, speeds, and what the standard life
// asks.
#include <span>

#include "app/case/described_fields.hpp"
#include "app/case/field_table.hpp"
#include "app/case/requirements_case.hpp"
#include "app/case/resolved_case.hpp"
#include "app/case/spectrum_case.hpp"
#include "bearing/equilibrium/jones_balls.hpp"
#include "bearing/equilibrium/ring_balance.hpp"
#include "bearing/life/rating_lives.hpp"
#include "bearing/motion/balls/parameters.hpp"
#include "bearing/parameters.hpp"
#include "coupling/system/heated_balls.hpp"

namespace orbearing::app::table {

namespace {

constexpr unsigned static_bearing = roller_bearing | ball_bearing;
constexpr unsigned single_bearing = roller_bearing | single_ball_bearing;

const Use& by_static_load() {
  static const Use use(use::static_load, use::stiffness);
  return use;
}

constexpr unsigned rated = single_bearing | planetary_drivetrain;

// Unless kappa is that of the film, which crown does not compute.
Use where_kappa_is_stated(const Use& use) {
  return use.when(where("life.viscosity_ratio_by", {"speed"})).used_too(use::crown, std::vector<Condition>{});
}

// Lives by film and cleanliness.
const Use& by_rated_life() {
  static const Use use(use::static_load | use::ball_run | use::lives,
                       use::stiffness | (use::of_a_drivetrain & ~unsigned{use::lives}));
  return use;
}

const Use& by_any_load() {
  static const Use use(use::static_load | use::ball_run, use::stiffness);
  return use;
}

constexpr unsigned rated_runs = use::lives & ~unsigned{use::crown};

const Use& by_lives_of_planets() {
  static const Use use(rated_runs, use::of_a_drivetrain & ~use::lives);
  return use;
}

// Affects the fatigue load limit alone, which a crown shows in lives with an oil.
const Use& by_fatigue_limit() {
  static const Use use =
      Use(use::static_load | use::ball_run | rated_runs,
          use::stiffness | (use::of_a_drivetrain & ~rated_runs))
          .used_too(use::crown,
                    where_given({"lubricant.grade", "life.cleanliness", "life.contamination_factor",
                                 "life.viscosity_ratio", "lubricant.kinematic_viscosity"}));
  return use;
}

Field optional_quantity(const Dimension& dimension, std::string path, std::string meaning, unsigned models,
                        Range range, const Use& use = by_static_load()) {
  return {.path = std::move(path),
          .kind = Kind::quantity,
          .meaning = std::move(meaning),
          .use = use,
          .models = models,
          .dimension = dimension,
          .range = range};
}

const Condition& where_balls_turn_with_effect() {
  static const Condition pulled = where_true(
      [](const ResolvedCase& in, std::string_view) {
        const auto is_on = [&](const char* path) { return in.has(path) && in.flag(path); };
        return is_on("equilibrium.ball_inertia") || is_on("film.enabled");
      },
      "where equilibrium.ball_inertia or film.enabled is true");
  return pulled;
}

// Hours of life follow from it.
Field speed_of_ring(std::string path, std::string meaning) {
  return {.path = std::move(path),
          .kind = Kind::quantity,
          .meaning = std::move(meaning),
          .use = Use(use::static_load | use::ball_run, use::stiffness),
          .models = single_bearing,
          .dimension = dimension::angular_speed,
          .range = {-1e6, 1e6},
          .default_text = "0 rpm",
          .default_reason = "a stationary ring"};
}

void add_operation(std::vector<Field>& fields) {
  Field shaft = speed_of_ring("operation.shaft_speed", "speed of the inner ring");
  shaft.use.by |= use::defect | use::moving_defect;
  // The stiffness of balls stands beside the speed of the shaft.
  shaft.use =
      shaft.use.used_too(use::duplex, where_balls_turn_with_effect())
          .used_too(use::stiffness, {where_given({"bearing.balls"}), where_absent("operation.speeds")});
  shaft.models |= described::single_scratched | duplex_pair;
  fields.push_back(std::move(shaft));
  Field outer = speed_of_ring("operation.outer_speed", "speed of the outer ring");
  outer.use =
      outer.use.used_too(use::stiffness, {where_given({"bearing.balls"}), where_balls_turn_with_effect()});
  fields.push_back(std::move(outer));
  fields.push_back({.path = "operation.speeds",
                    .kind = Kind::list,
                    .meaning = "speeds of the inner ring over which run and stiffness tabulate the "
                               "equilibrium, and modes and run of a duplex pair its natural frequencies",
                    .use = Use(use::single_bearing_equilibrium | use::duplex, 0),
                    .models = ball_bearing | duplex_pair,
                    .dimension = dimension::angular_speed,
                    .range = {-1e6, 1e6},
                    .element = Kind::quantity});
  fields.push_back({.path = "operation.load_factors",
                    .kind = Kind::list,
                    .meaning = "factors of the whole load at which stiffness is given; left out: 1",
                    .use = Use(use::stiffness, use::static_load),
                    .models = static_bearing,
                    .range = positive(1e6)});
  fields.push_back({.path = "operation.turning_race",
                    .kind = Kind::choice,
                    .meaning = "race that rotates relative to the load",
                    .use = by_any_load(),
                    .models = single_bearing,
                    .choices = {"inner", "outer"},
                    .default_text = "inner",
                    .default_reason = "a stationary load on a rotating shaft"});
  fields.push_back({.path = "operation.shaft_acceleration",
                    .kind = Kind::quantity,
                    .meaning =
                        "acceleration of the inner ring from rest up to its speed; 0: that speed from the "
                        "start on",
                    .use = Use(use::ball_run, 0),
                    .models = ball_motion,
                    .dimension = dimension::angular_acceleration,
                    .range = {0.0, 1e9},
                    .default_text = "0 rpm/s",
                    .default_reason = "steady speed"});
}

void add_capacities(std::vector<Field>& fields) {
  constexpr Range above_zero{.least = 0.0, .most = 1e9, .least_allowed = false};
  const Use by_load(use::static_load | use::ball_run | use::lives,
                    use::stiffness | (use::of_a_drivetrain & ~unsigned{use::lives}));
  fields.push_back(optional_quantity(
      dimension::force, "bearing.dynamic_capacity",
      "basic dynamic load rating C, for the lives by ISO 281 and ISO/TS 16281; if absent, C by ISO 281",
      single_bearing | planetary_drivetrain, above_zero, by_load));
  fields.push_back(optional_quantity(dimension::force, "bearing.static_capacity",
                                     "basic static load rating C_0; if absent, C_0 by ISO 76", rated,
                                     above_zero, by_fatigue_limit()));
  fields.push_back(optional_quantity(dimension::force, "bearing.fatigue_load_limit",
                                     "fatigue load limit C_u; if absent, C_u by ISO 281 from C_0", rated,
                                     above_zero, by_fatigue_limit()));
  for (Field& field : std::span(fields).last(3)) {  // of each row of a pair too
    field.models |= duplex_pair;
    field.use.by |= use::duplex_run;
    field.use.not_modelled_by |= use::duplex_modes;
  }
}

Field life_number(std::string path, std::string meaning, Range range) {
  return {.path = std::move(path),
          .kind = Kind::number,
          .meaning = std::move(meaning),
          .use = by_rated_life(),
          .models = rated,
          .range = range};
}

std::vector<std::string> methods_of_life() {
  std::vector<std::string> names;
  for (const auto& name : names_of(bearing::rating::LifeMethod{})) names.emplace_back(name.text);
  return names;
}

void add_life(std::vector<Field>& fields) {
  fields.push_back({.path = "life.method",
                    .kind = Kind::choice,
                    .meaning = "life of peaks, spectra and sensitivities. lundberg-palmgren: life_h; "
                               "iso-281: L10mh where the oil is stated, else L10h; iso-16281: L10mrh where "
                               "the oil is stated, else L10rh. crown uses L10rh with iso-16281, else life_h",
                    .use = by_lives_of_planets().used_too(use::crown, where("life.method", {"iso-16281"})),
                    .models = planetary_drivetrain,
                    .choices = methods_of_life(),
                    .default_text = "lundberg-palmgren",
                    .default_reason = "what published cases use"});
  fields.push_back(minimum_load_field(by_lives_of_planets()));
  Field reliability = life_number("life.reliability", "reliability: share of bearings that reach the life",
                                  {.least = 0.0, .most = 1.0, .least_allowed = false, .most_allowed = false});
  // a_1 is in L10m and L10mr, which need an oil; a bearing at rest under a load shows it by itself.
  reliability.use =
      by_rated_life()
          .when(where_given({"lubricant.grade", "life.cleanliness", "life.contamination_factor",
                             "life.viscosity_ratio", "lubricant.kinematic_viscosity"}))
          .used_too(use::static_load,
                    where_given({"load.radial", "load.axial", "load.moment", "load.moment_across"}));
  reliability.default_text = "0.9";
  reliability.default_reason = "rating lives are those of 90 %";
  fields.push_back(reliability);
  Field ratio =
      life_number("life.viscosity_ratio", "viscosity ratio kappa of ISO 281; with it the life includes a_ISO",
                  {.least = 0.1, .most = 1000.0});
  ratio.use = where_kappa_is_stated(ratio.use);
  fields.push_back(ratio);
  fields.push_back(life_number("life.contamination_factor", "e_C of ISO 281", {0.0, 1.0}));
  fields.push_back({.path = "life.lubrication",
                    .kind = Kind::choice,
                    .meaning = "kind of lubrication, for the contamination factor",
                    .use = by_rated_life()
                               .when(where_absent("life.contamination_factor"))
                               .when(where_given({"life.cleanliness", "lubricant.grade",
                                                  "life.viscosity_ratio", "lubricant.kinematic_viscosity"})),
                    .models = rated,
                    .choices = {"circulating-oil", "oil-bath", "grease"},
                    .default_text = "circulating-oil",
                    .default_reason = "oil with a filter in its line"});
  fields.push_back(
      {.path = "life.cleanliness",
       .kind = Kind::choice,
       .meaning =
           "level of cleanliness, or its ISO 4406 code for filtered oil, instead of the contamination factor",
       .use = by_rated_life(),
       .models = rated,
       .choices = {"highest", "high", "medium", "low", "lowest", "-/13/10", "-/15/12", "-/17/14", "-/19/16",
                   "-/21/18"}});
  fields.push_back(
      {.path = "life.viscosity_ratio_by",
       .kind = Kind::choice,
       .meaning = "source of kappa: speed and viscosity, or the ratio of the least computed film to "
                  "contact.roughness, to the power of 1.3",
       .use = Use(use::lives & ~unsigned{use::crown}, use::of_a_drivetrain & ~unsigned{use::lives})
                  .when(where_given({"lubricant.grade", "life.cleanliness", "life.contamination_factor"})),
       .models = planetary_drivetrain,
       .choices = {"speed", "film"},
       .default_text = "speed",
       .default_reason = "as ISO 281 defines kappa; the film's own is its alternative"});
  fields.push_back(
      optional_quantity(dimension::kinematic_viscosity, "lubricant.kinematic_viscosity",
                        "kinematic viscosity at running temperature, instead of kappa", rated,
                        {.least = 0.0, .most = 1e6, .least_allowed = false},
                        where_kappa_is_stated(by_rated_life()).when(where_absent("lubricant.grade"))));
}

}  // namespace

void add_static_fields(std::vector<Field>& fields) {
  add_described(fields, bearing::equilibrium::RingLoad{});
  add_described(fields, bearing::equilibrium::BallInertia{});
  add_operation(fields);
  add_described(fields, bearing::Bearing{.elements = bearing::Balls{}});
  add_described(fields, bearing::balls::MotionParameters{});
  add_described(fields, system::BallRunOptions{});
  add_described(fields, system::HeatParameters{});
  add_capacities(fields);
  add_life(fields);
  for (Field& field : requirement_fields()) fields.push_back(std::move(field));
}

}  // namespace orbearing::app::table
