// Fields of one bearing: balls and grooves, loads, speeds, inputs of the standard life, scratches and their
// signal.
#include "app/case/described_fields.hpp"
#include "app/case/field_table.hpp"
#include "app/case/resolved_case.hpp"
#include "app/case/spectrum_case.hpp"
#include "bearing/defect/scratched_bearing.hpp"
#include "bearing/equilibrium/jones_balls.hpp"
#include "bearing/equilibrium/ring_balance.hpp"
#include "bearing/life/rating_lives.hpp"
#include "bearing/motion/balls/parameters.hpp"
#include "bearing/parameters.hpp"
#include "coupling/study/planet_scratch.hpp"
#include "coupling/study/scratch_run.hpp"
#include "coupling/system/heated_balls.hpp"

namespace orbearing::app::table {

namespace {

constexpr unsigned static_bearing = roller_bearing | ball_bearing;
constexpr unsigned single_bearing = roller_bearing | single_ball_bearing;
constexpr unsigned rated = single_bearing | planetary_drivetrain;
constexpr unsigned rated_runs = use::lives & ~unsigned{use::crown};

Condition where_oil_is_stated() {
  return where_given({"lubricant.grade", "life.cleanliness", "life.contamination_factor",
                      "life.viscosity_ratio", "lubricant.kinematic_viscosity"});
}

// With the least number of laminae, which whole contacts have too, both are one formula.
bool laminae_are_not_the_least(const ResolvedCase& in, std::string_view set) {
  const std::string path = set.empty() ? "bearing.laminae" : "sets." + std::string(set) + ".bearing.laminae";
  return in.has(path) && in.integer(path) > 0 && in.integer(path) != bearing::rating::kLeastRatedLaminae;
}

Condition where_balls_turn_with_effect() {
  return where_true(
      [](const ResolvedCase& in, std::string_view) {
        return is_on(in, "equilibrium.ball_inertia") || is_on(in, "film.enabled");
      },
      "where equilibrium.ball_inertia or film.enabled is true");
}

void add_operation(std::vector<Field>& fields) {
  Rows rows(fields, single_bearing);
  const Use by_any_load(use::static_load | use::ball_run,
                        use::stiffness);  // hours of life follow from speeds
  const Condition of_balls = where_given({"bearing.balls"});
  Use of_shaft = by_any_load;
  of_shaft.by |= use::defect | use::moving_defect;
  // The stiffness of balls is computed at the speed of the shaft.
  Rows(fields, single_bearing | described::single_scratched)
      .quantity("operation.shaft_speed", "speed of the inner ring",
                of_shaft.used_too(use::stiffness, {of_balls, where_absent("operation.speeds")}),
                dimension::angular_speed, {-1e6, 1e6})
      .by_default("0 rpm", "a stationary ring");
  rows.quantity("operation.outer_speed", "speed of the outer ring",
                by_any_load.used_too(use::stiffness, {of_balls, where_balls_turn_with_effect()}),
                dimension::angular_speed, {-1e6, 1e6})
      .by_default("0 rpm", "a stationary ring");
  Rows(fields, ball_bearing)
      .quantity(
          "operation.speeds",
          "speeds of the inner ring over which run and stiffness tabulate the equilibrium, and modes and "
          "run of a duplex pair its natural frequencies",
          Use(use::single_bearing_equilibrium, 0), dimension::angular_speed, {-1e6, 1e6})
      .listed();
  Rows(fields, static_bearing)
      .number("operation.load_factors", "factors of the whole load at which stiffness is given; left out: 1",
              Use(use::stiffness, use::static_load), positive(1e6))
      .listed();
  rows.choice("operation.turning_race", "race that rotates relative to the load", by_any_load,
              {"inner", "outer"})
      .by_default("inner", "a stationary load on a rotating shaft");
  Rows(fields, ball_motion)
      .quantity("operation.shaft_acceleration",
                "acceleration of the inner ring from rest up to its speed; 0: that speed from the start on",
                Use(use::ball_run, 0), dimension::angular_acceleration, {0.0, 1e9})
      .by_default("0 rpm/s", "steady speed");
}

void add_capacities(std::vector<Field>& fields) {
  Rows rows(fields, rated);
  constexpr unsigned shown_by = use::static_load | use::ball_run;
  const Use by_lives(shown_by | use::lives, use::stiffness | (use::of_a_drivetrain & ~unsigned{use::lives}));
  // C_0 affects the fatigue load limit alone, which a crown shows in lives with an oil.
  const Use by_limit = Use(shown_by | rated_runs, use::stiffness | (use::of_a_drivetrain & ~rated_runs))
                           .used_too(use::crown, where_oil_is_stated());
  rows.quantity("bearing.dynamic_capacity",
                "basic dynamic load rating C, for the lives by ISO 281 and ISO/TS 16281; if absent, C by ISO "
                "281",
                by_lives, dimension::force, positive(1e9));
  rows.quantity("bearing.static_capacity", "basic static load rating C_0; if absent, C_0 by ISO 76", by_limit,
                dimension::force, positive(1e9));
  rows.quantity("bearing.fatigue_load_limit", "fatigue load limit C_u; if absent, C_u by ISO 281 from C_0",
                by_limit, dimension::force, positive(1e9));
}

void add_life(std::vector<Field>& fields) {
  Rows planets(fields, planetary_drivetrain), rows(fields, rated);
  const Use by_planets(rated_runs, use::of_a_drivetrain & ~use::lives);
  // Lives by film and cleanliness.
  const Use by_life(use::static_load | use::ball_run | use::lives,
                    use::stiffness | (use::of_a_drivetrain & ~unsigned{use::lives}));
  // Unless kappa is that of the film, which crown does not compute.
  const Use by_stated_kappa = by_life.when(where("life.viscosity_ratio_by", {"speed"}))
                                  .used_too(use::crown, std::vector<Condition>{});
  rows.choice(
          "life.method",
          "governing life, by which requirements, peaks, spectra, crowns and sensitivities go. "
          "lundberg-palmgren: life_h; iso-281: L10mh where the oil is stated, else L10h; iso-16281: L10mrh "
          "where the oil is stated, else L10rh. crown uses life_h with iso-281, whose life is that of all "
          "crowns",
          by_life.used_too(use::crown, where("life.method", {"iso-16281"})),
          choices_of<bearing::rating::LifeMethod>())
      .by_default("lundberg-palmgren", "neither the rating C nor a requirement is stated");
  Rows(fields, roller_bearing | planetary_drivetrain)
      .choice(
          "life.stress_riser",
          "stress at the ends of rollers in L10rh and L10mrh. position: a function of the position along "
          "the roller, equal to the formula of ISO/TS 16281 for 30 laminae; standard: its formula for the "
          "laminae of the case, on whose number lives of straight rollers then depend",
          by_life.when(where_true(laminae_are_not_the_least, "where bearing.laminae is not 30"))
              .used_too(use::crown, where_absent("bearing.laminae")),  // which takes 40 then
          choices_of<bearing::rating::StressRiser>())
      .by_default("position", "lives do not depend on the number of laminae");
  planets.number(
      kMinimumLoadPath,
      "minimum load P/C: in rows of the spectrum below it, rolling elements may skid. Makers' rule "
      "of thumb [SKFMinimumLoad]: 0.02 for roller bearings, 0.01 for ball bearings",
      by_planets.when(where_given({kSpectrumPath})), positive(1.0));
  // a_1 is in L10m and L10mr, which require an oil; a quasi-static bearing under a load shows it in any case.
  rows.number("life.reliability", "reliability: share of bearings that reach the life",
              by_life.when(where_oil_is_stated())
                  .used_too(use::static_load,
                            where_given({"load.radial", "load.axial", "load.moment", "load.moment_across"})),
              {.least = 0.0, .most = 1.0, .least_allowed = false, .most_allowed = false})
      .by_default("0.9", "rating lives are those of 90 %");
  rows.number("life.viscosity_ratio", "viscosity ratio kappa of ISO 281; with it the life includes a_ISO",
              by_stated_kappa, {0.1, 1000.0});
  rows.number("life.contamination_factor", "e_C of ISO 281", by_life, {0.0, 1.0});
  rows.choice("life.lubrication", "kind of lubrication, for the contamination factor",
              by_life.when(where_absent("life.contamination_factor"))
                  .when(where_given({"life.cleanliness", "lubricant.grade", "life.viscosity_ratio",
                                     "lubricant.kinematic_viscosity"})),
              {"circulating-oil", "oil-bath", "grease"})
      .by_default("circulating-oil", "oil with a filter in its line");
  rows.choice(
      "life.cleanliness",
      "level of cleanliness, or its ISO 4406 code for filtered oil, instead of the contamination factor",
      by_life,
      {"highest", "high", "medium", "low", "lowest", "-/13/10", "-/15/12", "-/17/14", "-/19/16", "-/21/18"});
  planets
      .choice("life.viscosity_ratio_by",
              "source of kappa: speed and viscosity, or the ratio of the least computed film to "
              "contact.roughness, to the power of 1.3",
              Use(rated_runs, use::of_a_drivetrain & ~unsigned{use::lives})
                  .when(where_given({"lubricant.grade", "life.cleanliness", "life.contamination_factor"})),
              {"speed", "film"})
      .by_default("speed", "as ISO 281 defines kappa; the film's own is its alternative");
  rows.quantity(
      "lubricant.kinematic_viscosity", "kinematic viscosity at running temperature, instead of kappa",
      by_stated_kappa.when(where_absent("lubricant.grade")), dimension::kinematic_viscosity, positive(1e6));
}

void add_defects(std::vector<Field>& fields) {
  add_described(fields, bearing::defect::VibratingRing{});
  add_described(fields, bearing::defect::Scratch{});
  add_described(fields, study::Sampling{});
  add_described(fields, study::ScratchedPosition{});
  add_described(fields, study::PlanetSampling{});
  Rows(fields, planetary_drivetrain)
      .text("defect.set", "set with the scratched bearing, of several sets", Use(use::planet_defect, 0));
  Rows(fields, scratched_bearings)
      .quantity("signal.band",
                "lower and upper end of the band whose envelope is taken; left out: the band of largest "
                "spectral kurtosis",
                Use(use::defect | use::moving_defect | use::planet_defect, 0), dimension::frequency,
                positive(1e5))
      .listed();
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
  add_requirements(fields);
  add_defects(fields);
}

}  // namespace orbearing::app::table
