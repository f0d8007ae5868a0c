// Fields of planet bearings besides those of their members: ratings and lives, scratches and their signal.
#include "app/case/described_fields.hpp"
#include "app/case/drivetrain_analyses.hpp"
#include "app/case/field_table.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/machine_fields.hpp"
#include "app/case/resolved_case.hpp"
#include "app/case/spectrum_case.hpp"
#include "bearing/defect/scratched_bearing.hpp"
#include "bearing/equilibrium/ring_balance.hpp"
#include "bearing/life/rating_lives.hpp"
#include "bearing/motion/balls/parameters.hpp"
#include "bearing/parameters.hpp"
#include "coupling/analysis/planet_rating.hpp"
#include "coupling/analysis/planet_scratch.hpp"
#include "coupling/analysis/scratch_run.hpp"
#include "mechanics/member_keys.hpp"

namespace orbearing::app::table {

namespace {

std::string laminae_key() {
  return mechanics::key_of<bearing::CylindricalRollers>(
      [](const auto& rollers) -> const auto& { return rollers.laminae; });
}

AnalysisSet rated_runs() {
  return analyses_with_lives().without(AnalysisId::crown);
}

// With the least number of laminae, which whole contacts have too, both are one formula.
bool laminae_are_not_the_least(const ResolvedCase& in, std::string_view set) {
  const std::string path = std::string(set) + laminae_key();
  return in.has(path) && in.integer(path) > 0 && in.integer(path) != bearing::rating::kLeastRatedLaminae;
}

// Rows of ratings and lives that single bearings have as well, with the uses by analyses of planets.
void add_life(std::vector<Field>& fields) {
  const auto add = [&]<class Struct, class Member>(const Struct& part, const Member& member, const Use& use) {
    fields.push_back(field_of_row<Struct>(mechanics::MemberKeys(part)(member), planetary_drivetrain, use));
  };
  const analysis::PlanetRating rating;
  const analysis::LifeInputs& life = rating.life;
  const analysis::BearingOil& oil = rating.oil;
  const analysis::StatedCapacities& capacities = rating.capacities;
  const mechanics::MemberKeys key(rating);
  const Condition oil_is_stated =
      where_given({key(oil.stated.grade), key(life.cleanliness), key(life.contamination_factor),
                   key(life.viscosity_ratio), key(oil.kinematic_viscosity)});
  Rows planets(fields, planetary_drivetrain);
  const Use by_planets(rated_runs(), all_of_drivetrains().without(analyses_with_lives()));
  const Use by_life(analyses_with_lives(), all_of_drivetrains().without(analyses_with_lives()));
  // C_0 affects the fatigue load limit alone, which a crown shows in lives with an oil.
  const Use by_limit = Use(rated_runs(), all_of_drivetrains().without(rated_runs()))
                           .used_too(AnalysisId::crown, oil_is_stated);
  add(capacities, capacities.dynamic_capacity, by_life);
  add(capacities, capacities.static_capacity, by_limit);
  add(capacities, capacities.fatigue_load_limit, by_limit);
  // Unless kappa is that of the film, which crown does not compute.
  const Use by_stated_kappa = by_life.when(where(key(rating.viscosity_ratio_by), {"speed"}))
                                  .used_too(AnalysisId::crown, std::vector<Condition>{});
  add(life, life.method, by_life.used_too(AnalysisId::crown, where(key(life.method), {"iso-16281"})));
  add(rating.rollers, rating.rollers.stress_riser,
      by_life.when(where_true(laminae_are_not_the_least, "where " + laminae_key() + " is not 30"))
          .used_too(AnalysisId::crown, where_absent(laminae_key())));  // which takes 40 then
  planets.number(
      kMinimumLoadPath,
      "minimum load P/C: in rows of the spectrum below it, rolling elements may skid. Makers' rule "
      "of thumb [SKFMinimumLoad]: 0.02 for roller bearings, 0.01 for ball bearings",
      by_planets.when(where_given({kSpectrumPath})), positive(1.0));
  // a_1 is in L10m and L10mr, which require an oil.
  add(life, life.reliability, by_life.when(oil_is_stated));
  add(life, life.viscosity_ratio, by_stated_kappa);
  add(life, life.contamination_factor, by_life);
  add(life, life.lubrication,
      by_life.when(where_absent(key(life.contamination_factor)))
          .when(where_given({key(life.cleanliness), key(oil.stated.grade), key(life.viscosity_ratio),
                             key(oil.kinematic_viscosity)})));
  add(life, life.cleanliness, by_life);
  add(rating, rating.viscosity_ratio_by,
      Use(rated_runs(), all_of_drivetrains().without(analyses_with_lives()))
          .when(where_given({key(oil.stated.grade), key(life.cleanliness), key(life.contamination_factor)})));
  add(oil, oil.kinematic_viscosity, by_stated_kappa.when(where_absent(key(oil.stated.grade))));
}

void add_defects(std::vector<Field>& fields) {
  add_described(fields, bearing::defect::Scratch{});
  row_of(fields, keys().scratched).required_by = no_model;  // a drivetrain without a scratch states none
  add_described(fields, analysis::ScratchedPosition{});
  add_described(fields, analysis::PlanetSampling{});
  Rows(fields, planetary_drivetrain)
      .text(std::string(kScratchedSet), "set with the scratched bearing, of several sets",
            Use(AnalysisId::planet_defect, {}));
  const analysis::EnvelopeBand band;
  fields.push_back(field_of_row<analysis::EnvelopeBand>(
      mechanics::MemberKeys(band)(band.ends), planetary_drivetrain, Use(AnalysisId::planet_defect, {})));
}

}  // namespace

void add_static_fields(std::vector<Field>& fields) {
  const AnalysisSet judged_by = AnalysisId::quasi_static | analyses_with(analysis::Physics::run);
  add_described(fields, bearing::equilibrium::RingLoad{}, no_model);
  add_described(fields, bearing::Bearing{.elements = bearing::Balls{}}, no_model);
  add_described(fields, bearing::balls::MotionParameters{}, no_model);
  add_life(fields);
  add_requirements(fields, planetary_drivetrain, Use(judged_by, all_of_drivetrains().without(judged_by)),
                   AnalysisId::crown);
  add_defects(fields);
}

}  // namespace orbearing::app::table
