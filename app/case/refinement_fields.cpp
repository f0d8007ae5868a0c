// Fields of what a bearing may have beyond the ideal one: races that are not round, unequal rollers, mixed
// lubrication, oil in the pockets, speeds that change, and variants as a source prints them.
#include "app/case/field_table.hpp"

namespace orbearing::app::table {

namespace {

constexpr unsigned drivetrain = planetary_drivetrain;
constexpr unsigned without_motion = use::rollers_at_rest | use::bearings_as_springs | use::mesh;

const Use& of_motion() {
  static const Use use(use::rollers_in_motion, without_motion);
  return use;
}

// The mean over one roller pitch knows like rollers and races that stand.
const Use& of_turning_form() {
  static const Use use(use::rollers_in_motion, use::bearings_as_springs | use::mesh, use::rollers_at_rest);
  return use;
}

const Use& of_standing_form() {
  static const Use use(use::lives | use::bearings_as_springs | use::fmu_bearing, use::mesh);
  return use;
}

Use of_mixed_lubrication() {
  return of_motion().when(where("contact.lubrication", {"mixed"}));
}

// One system of equations knows pockets without oil.
const Use& of_pocket_film() {
  static const Use use(use::rollers_in_motion & ~unsigned{use::monolithic}, without_motion, use::monolithic);
  return use;
}

Field choice(std::string path, std::string meaning, const Use& use, std::vector<std::string> choices,
             std::string reason) {
  Field field{.path = std::move(path),
              .kind = Kind::choice,
              .meaning = std::move(meaning),
              .use = use,
              .models = drivetrain,
              .choices = std::move(choices),
              .default_text = {},
              .default_reason = std::move(reason)};
  field.default_text = field.choices.front();
  return field;
}

Field quantity(const Dimension& dimension, std::string path, std::string meaning, const Use& use, Range range,
               std::string text, std::string reason) {
  return {.path = std::move(path),
          .kind = Kind::quantity,
          .meaning = std::move(meaning),
          .use = use,
          .models = drivetrain,
          .dimension = dimension,
          .range = range,
          .default_text = std::move(text),
          .default_reason = std::move(reason)};
}

Field list(std::string path, std::string meaning, const Use& use, Kind element, const Dimension& dimension,
           Range range) {
  return {.path = std::move(path),
          .kind = Kind::list,
          .meaning = std::move(meaning),
          .use = use,
          .models = drivetrain,
          .dimension = dimension,
          .range = range,
          .element = element};
}

// Waves of one race: lists of equal length, phases may be left out.
void add_form(std::vector<Field>& fields, const std::string& block, const std::string& which,
              const Use& use) {
  const Use of_waves = use.when(where_given({block + ".amplitude"}));
  fields.push_back(list(block + ".order", "waves around " + which, of_waves, Kind::integer, {}, {1, 1000}));
  fields.push_back(list(block + ".amplitude", "amplitude of each wave of " + which + ", outward", use,
                        Kind::quantity, dimension::small_length, {-1000.0, 1000.0}));
  fields.push_back(list(block + ".phase", "phase of each wave of " + which, of_waves, Kind::quantity,
                        dimension::angle, {-360.0, 360.0}));
}

void add_forms(std::vector<Field>& fields) {
  add_form(fields, "bearing.inner_race.standing_form", "the pin's race, standing in the carrier",
           of_standing_form());
  add_form(fields, "bearing.inner_race.turning_form", "the pin's race, turning with it", of_turning_form());
  add_form(fields, "bearing.outer_race.standing_form", "the bore's race, standing in the carrier",
           of_standing_form());
  add_form(fields, "bearing.outer_race.turning_form", "the bore's race, turning with it", of_turning_form());
  fields.push_back(list("bearing.roller_diameter_deviation",
                        "by how much single rollers are larger than roller_diameter, from the first on",
                        of_turning_form(), Kind::quantity, dimension::small_length, {-1000.0, 1000.0}));
}

void add_lubrication(std::vector<Field>& fields) {
  fields.push_back(choice("contact.lubrication",
                          "friction in the race contacts: one law, or shared by film and asperities",
                          of_motion(), {"full", "mixed"}, "smooth surfaces, fully parted"));
  fields.push_back(quantity(dimension::small_length, "contact.roughness",
                            "composite roughness (rms) of roller and race, for mixed lubrication",
                            of_mixed_lubrication(), {.least = 0.0, .most = 100.0, .least_allowed = false},
                            "0.2 um", "honed races, ground rollers"));
  fields.push_back({.path = "contact.boundary_friction",
                    .kind = Kind::number,
                    .meaning = "friction coefficient of asperities, for mixed lubrication",
                    .use = of_mixed_lubrication(),
                    .models = drivetrain,
                    .range = {0.0, 1.0},
                    .default_text = "0.12",
                    .default_reason = "mineral oil with additives"});
  fields.push_back(choice("bearing.cage.pocket_film", "oil between roller and pocket bar before they touch",
                          of_pocket_film(), {"none", "hydrodynamic"},
                          "the bars are felt when they are touched"));
  fields.push_back(quantity(dimension::small_length, "bearing.cage.pocket_roughness",
                            "roughness of roller and bar, the least film in the pocket",
                            of_pocket_film().when(where("bearing.cage.pocket_film", {"hydrodynamic"})),
                            {.least = 0.0, .most = 100.0, .least_allowed = false}, "0.4 um",
                            "a moulded or milled bar"));
}

void add_printed_variants(std::vector<Field>& fields) {
  fields.push_back(
      choice("film.approach", "a film adds to the elastic approach, or is subtracted as [Gai2025] prints it",
             Use(use::rollers_at_rest | use::dynamic | use::dynamic_of_sets | use::bearings_as_springs,
                 use::mesh, use::co_simulated | use::monolithic | use::fmu_bearing)
                 .when(where("film.enabled", {"true"})),
             {"added", "as-printed"}, "a film takes room between roller and race"));
  fields.push_back(choice(
      "contact.damping_law", "damping follows the approach speed, or the approach as [Gai2025] prints it",
      of_motion(), {"approach-speed", "as-printed"}, "without a speed nothing is damped"));
  fields.push_back(choice("bearing.cage.reference_speed",
                          "speed at which the cage starts and from which its slip is counted: pure rolling, "
                          "or as [Gai2025] prints it",
                          Use(use::dynamic | use::dynamic_of_sets, without_motion,
                              use::co_simulated | use::monolithic | use::fmu_bearing),
                          {"rolling", "as-printed"}, "the printed speed is that of a turning inner race"));
}

void add_run_up(std::vector<Field>& fields) {
  fields.push_back(quantity(
      dimension::angular_acceleration, "input.acceleration",
      "growth of the input speed at constant power, for a single dynamic run",
      Use(use::dynamic | use::dynamic_of_sets, use::crown | use::natural | use::mesh | use::fmu_bearing,
          use::quasi_static | use::co_simulated | use::monolithic),
      {-1e9, 1e9}, "0 rpm/s", "steady speeds"));
  fields.push_back(quantity(dimension::time, "simulation.run_up_time", "time of the run-up",
                            Use(use::dynamic | use::dynamic_of_sets,
                                without_motion | use::co_simulated | use::monolithic | use::fmu_bearing)
                                .when(where_given({"input.acceleration"})),
                            {.least = 0.0, .most = 1e4, .least_allowed = false}, "0.05 s",
                            "some revolutions of the cage"));
}

}  // namespace

void add_refinement_fields(std::vector<Field>& fields) {
  add_forms(fields);
  add_lubrication(fields);
  add_printed_variants(fields);
  add_run_up(fields);
}

}  // namespace orbearing::app::table
