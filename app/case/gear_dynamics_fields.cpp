// Fields of the dynamics of a planetary set: bodies, supports, damping, errors, and the run in time.
#include "app/case/bearing_fields.hpp"
#include "app/case/described_fields.hpp"
#include "app/case/field_table.hpp"
#include "app/case/use_conditions.hpp"

namespace orbearing::app::table {

namespace {

void add_run(std::vector<Field>& fields) {
  Rows rows(fields, planetary_drivetrain);
  constexpr unsigned without_motion = use::rollers_at_rest | use::mesh | use::fmu_bearing | use::natural;
  const Use of_run_up(use::gears | use::fmu_gearset, without_motion);
  const Use of_run(use::gears, without_motion | use::in_time | use::fmu_gearset);
  rows.number("gearset.dynamics.run_up.from", "speed at the start as a share of input.speed",
              of_run_up.when(where_given({"gearset.dynamics.run_up.duration"})), positive(10.0))
      .by_default("1", "no run-up");
  rows.quantity("gearset.dynamics.run_up.duration", "time to reach input.speed",
                of_run_up.used_only(use::fmu_gearset,
                                    {where_true(gears_run_up, "with a run_up.from other than 1")}),
                dimension::time, {0.0, 1e4})
      .by_default("0 s", "no run-up");
  rows.integer("gearset.dynamics.observed_periods",
               "number of mesh periods for the means of the steady state", of_run, {1, 1000000})
      .by_default("200", "many turns of the slowest vibration");
  rows.integer("gearset.dynamics.settling_periods", "maximum number of mesh periods to reach a steady state",
               of_run, {100, 10000000})
      .by_default("4000", "several times what damping takes");
}

}  // namespace

void add_gear_dynamics_fields(std::vector<Field>& fields) {
  add_described(fields, default_gears());
  add_run(fields);
}

}  // namespace orbearing::app::table
