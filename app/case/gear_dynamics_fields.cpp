// Fields of the dynamics of a planetary set: bodies, supports, damping, errors, and the run in time.
#include "app/case/bearing_fields.hpp"
#include "app/case/described_fields.hpp"
#include "app/case/field_table.hpp"
#include "app/case/use_conditions.hpp"

namespace orbearing::app::table {

namespace {

constexpr unsigned drivetrain = planetary_drivetrain;
const std::string kBlock = "gearset.dynamics.";
constexpr unsigned without_gear_motion = use::rollers_at_rest | use::mesh | use::fmu_bearing;

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

void add_run(std::vector<Field>& fields) {
  const Use of_run_up(use::gears | use::fmu_gearset, without_gear_motion | use::natural);
  const Use of_run(use::gears, without_gear_motion | use::natural | use::in_time | use::fmu_gearset);
  fields.push_back(number({"run_up.from", "speed at the start as a share of input.speed",
                           of_run_up.when(where_given({"gearset.dynamics.run_up.duration"})), positive(10.0),
                           "1", "no run-up"}));
  fields.push_back(quantity(
      dimension::time,
      {"run_up.duration",
       "time to reach input.speed",
       of_run_up.used_only(use::fmu_gearset, {where_true(gears_run_up, "with a run_up.from other than 1")}),
       {0.0, 1e4},
       "0 s",
       "no run-up"}));
  Field observed = number({"observed_periods",
                           "number of mesh periods for the means of the steady state",
                           of_run,
                           {1, 1000000},
                           "200",
                           "many turns of the slowest vibration"});
  Field settling = number({"settling_periods",
                           "maximum number of mesh periods to reach a steady state",
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
  add_described(fields, default_gears());
  add_run(fields);
}

}  // namespace orbearing::app::table
