// Fields of the gear set, of the power that drives it and of its run in time.
#include "app/case/bearing_fields.hpp"
#include "app/case/described_fields.hpp"
#include "app/case/drivetrain_analyses.hpp"
#include "app/case/field_table.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/spectrum_case.hpp"
#include "app/case/use_conditions.hpp"
#include "gearset/parameters.hpp"
#include "gearset/planet_pair.hpp"
#include "gearset/spatial/spatial_set.hpp"

namespace orbearing::app::table {

namespace {

using analysis::Physics;

// Torque, or torque over speed, instead of the power, with the same use; and a load spectrum.
void add_duty(std::vector<Field>& fields) {
  Rows rows(fields, planetary_drivetrain);
  const Use use = row_of(fields, keys().power).use;
  constexpr int load = 1, time = 2;  // groups of columns of which a row has one
  rows.quantity(kTorquePath,
                "torque on the shaft whose speed is input.speed, instead of input.power; a sweep over speed "
                "then has constant torque",
                use, dimension::torque, positive(1e12));
  rows.list_of_rows(
          kTorqueCurvePath,
          "torque over speed, instead of input.power: rows in ascending order of speed, linear between them",
          use, {{"speed", dimension::angular_speed, {0.0, 1e6}}, {"torque", dimension::torque, {0.0, 1e12}}})
      .from_file = true;
  rows.list_of_rows(kSpectrumPath,
                    "load spectrum: duration of each power or torque with its speed. Use share or hours, the "
                    "same for all rows; speed 0 is rest. Optional: file, the record of a row, for damage by "
                    "file",
                    Use(analyses_with_lives(), all_of_drivetrains().without(analyses_with_lives())),
                    {{"power", dimension::power, {0.0, 1e7}, load},
                     {"torque", dimension::torque, {0.0, 1e12}, load},
                     {"speed", dimension::angular_speed, {0.0, 1e6}},
                     {"share", {}, {0.0, 1.0 + kShareRoundOff}, time},
                     {"hours", {"time", "s", "h", "120 h", 3600.0}, {0.0, 1e9}, time, "h"},
                     {.name = "file", .text = true, .optional = true}})
      .from_file = true;
}

void add_bodies(std::vector<Field>& fields) {
  Rows rows(fields, planetary_drivetrain);
  const Use bodies =
      Use(analyses_with(Physics::gear_motion) | analyses_with(Physics::vibration) | AnalysisId::mesh,
          analyses_with(Physics::equilibrium) | AnalysisId::fmu_bearing)
          .used_too(AnalysisId::quasi_static, where_planets_carry_unlike_loads());
  const Use planet = Use(analyses_with(Physics::springs) | AnalysisId::mesh,
                         analyses_with_lives() | AnalysisId::fmu_bearing | AnalysisId::planet_stiffness)
                         .when(where_absent(keys().rollers))
                         .when(where_absent(keys().balls));
  rows.number("gearset.sun_bore_ratio", "bore of the sun as a share of its root diameter", bodies,
              {0.02, 0.98})
      .by_default("0.5", "a sun on a shaft; affects mesh stiffness and mass of the sun");
  rows.number("gearset.ring_outside_ratio",
              "outside diameter of the ring, where it is held, as a multiple of its root diameter", bodies,
              {1.005, 20.0})
      .by_default("1.15", "a rim of some five modules; affects mesh stiffness and mass of the ring");
  rows.number(keys().planet_bore_ratio,
              "bore of a planet without a stated bearing, as a share of module x (teeth - 2.5)", planet,
              {0.02, 0.98})
      .by_default("0.7", "room for roller bearings under a rim of a few modules");
}

// First drafts of a gear set have none: the planet's follows from the common centre distance.
void add_default_shifts(std::vector<Field>& fields) {
  for (const char* path : {"gearset.profile_shift.sun", "gearset.profile_shift.ring"}) {
    Field& shift = row_of(fields, path);
    shift.required_by = no_model;
    shift.by_default("0", "no profile shift; that of the planet follows");
  }
}

// Values that follow from others and may be stated as a check: no result depends on them.
void add_checks(std::vector<Field>& fields) {
  Rows rows(fields, planetary_drivetrain);
  const Use checked(all_of_drivetrains(), {});
  rows.quantity(
      "gearset.centre_distance",
      "check only: working centre distance of a drawing; refused if teeth, module and shifts give a "
      "value more than 0.01 mm away",
      checked, dimension::length, positive(1e5));
  rows.number(
      "gearset.profile_shift.planet",
      "check only: profile shift of a planet, in modules; refused if the common centre distance gives "
      "a value more than 0.005 away",
      checked, {-2.0, 2.0});
}

// From a speed up to that of the input, until mesh periods repeat.
void add_run(std::vector<Field>& fields) {
  Rows rows(fields, planetary_drivetrain);
  const AnalysisSet without_motion = analyses_with(Physics::equilibrium) | AnalysisId::mesh |
                                     AnalysisId::fmu_bearing | analyses_with(Physics::vibration);
  const Use of_run_up(AnalysisId::gears | AnalysisId::fmu_gearset, without_motion);
  const Use of_run(AnalysisId::gears, without_motion | analyses_with(Physics::run) | AnalysisId::fmu_gearset);
  rows.number("gearset.dynamics.run_up.from", "speed at the start as a share of input.speed",
              of_run_up.when(where_given({"gearset.dynamics.run_up.duration"})), positive(10.0))
      .by_default("1", "no run-up");
  rows.quantity("gearset.dynamics.run_up.duration", "time to reach input.speed",
                of_run_up.used_only(AnalysisId::fmu_gearset,
                                    {where_true(gears_run_up, "with a run_up.from other than 1")}),
                dimension::time, {0.0, 1e4})
      .by_default("0 s", "no run-up");
  rows.integer("gearset.dynamics.observed_periods",
               "number of mesh periods for the means of the steady state", of_run, {1, 1000000})
      .by_default("200", "many turns of the slowest vibration")
      .of_numerics();
  rows.integer("gearset.dynamics.settling_periods", "maximum number of mesh periods to reach a steady state",
               of_run, {100, 10000000})
      .by_default("4000", "several times what damping takes")
      .of_numerics();
}

}  // namespace

void add_drivetrain_fields(std::vector<Field>& fields) {
  add_described(fields, gearset::Drive{});
  add_duty(fields);
  add_described(fields, gearset::PlanetarySet{});
  add_default_shifts(fields);
  add_described(fields, gearset::SecondPlanet{});
  add_described(fields, gearset::spatial::CarrierMounting{});
  row_of(fields, keys().housing_stiffness).from_file = true;
  add_bodies(fields);
  add_checks(fields);
  add_described(fields, default_gears());
  add_run(fields);
}

}  // namespace orbearing::app::table
