#include "app/study/gear_case.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "app/case/bearing_type.hpp"
#include "app/case/drivetrain_reader.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/machines.hpp"
#include "app/errors.hpp"
#include "app/study/drivetrain_case.hpp"
#include "coupling/analysis/gear_quantities.hpp"

namespace orbearing::app {

namespace {

void require_one_set(const ResolvedCase& in) {
  if (in.model() != planetary_drivetrain)
    throw BadInput(in.origin("model") + ": model: found " + in.choice("model") +
                   "; required: planetary-drivetrain, whose gears have dynamics");
  if (in.shape().several)
    throw BadInput(in.file() +
                   ": sets: found several sets; required: one set, as gearset at the top of a case");
}

// The springs that replace the bearings are those of cylindrical rollers.
void require_known_springs(const ResolvedCase& in) {
  if (has_cylindrical_rollers(in)) return;
  throw BadInput(
      fmt::format("{}: bearing.type: found {}; required: cylindrical-roller, of which the stiffness under "
                  "moving gears is "
                  "computed; run, sweep and mesh take other types",
                  in.origin(keys().bearing_type), in.choice(keys().bearing_type)));
}

// Result of `compute`. A gear without a body under its teeth is a mistake of the case.
template <class Compute>
auto of_sound_gears(const ResolvedCase& in, const Compute& compute) {
  try {
    return compute();
  } catch (const std::domain_error& error) {
    throw BadInput(in.file() + ": gearset: " + error.what());
  }
}

analysis::PlanetaryDrivetrain single_set(const analysis::StatedDrivetrain& stated) {
  return drivetrain_of(stated.single(), drive_of(stated));
}

}  // namespace

analysis::PlanetaryDrivetrain with_sound_gears(const ResolvedCase& in,
                                               analysis::PlanetaryDrivetrain drivetrain) {
  if (drivetrain.gear_set)
    drivetrain.gear_set = [in, built = std::move(drivetrain.gear_set)] { return of_sound_gears(in, built); };
  return drivetrain;
}

analysis::PlanetaryDrivetrain with_refused_gears(const ResolvedCase& in,
                                                 analysis::PlanetaryDrivetrain drivetrain) {
  if (drivetrain.gear_set)
    drivetrain.gear_set = [in, built = std::move(drivetrain.gear_set)] {
      require_known_springs(in);
      return of_sound_gears(in, built);
    };
  return drivetrain;
}

gearset::dynamics::SetModel gear_model_of(const ResolvedCase& in, double carrier_speed) {
  require_one_set(in);
  const analysis::StatedDrivetrain& stated = stated_drivetrain(in);
  const analysis::StatedSet& set = stated.single();
  if (!in.shape().teeth) return analysis::toothless_model(set.teeth, set.gears.choice, carrier_speed);
  require_known_springs(in);
  const analysis::PlanetaryDrivetrain drivetrain = single_set(stated);
  return of_sound_gears(
      in, [&] { return analysis::gear_model(drivetrain, analysis::geometry_of(drivetrain), set.gears); });
}

gearset::dynamics::SetModel moving_gears_of(const ResolvedCase& in) {
  const gearset::dynamics::SetModel model = gear_model_of(in);
  return in.shape().teeth && !in.flag(keys().mesh_variation) ? gearset::dynamics::averaged(model) : model;
}

analysis::GearRunOptions gear_run_options(const ResolvedCase& in) {
  return analysis::gear_run_options(machine_of<analysis::GearRunPeriods>(in));
}

std::vector<Derived> gear_dynamics_quantities(const ResolvedCase& in) {
  require_one_set(in);
  require_known_springs(in);
  described::Record record;
  const analysis::StatedDrivetrain& stated = stated_drivetrain(in);
  if (!in.shape().teeth)
    describe(record, analysis::GearQuantities{gear_model_of(in)});
  else
    describe(record, of_sound_gears(in, [&] {
               return analysis::gear_quantities(single_set(stated), stated.single().gears);
             }));
  return derived_rows(record);
}

std::vector<std::string> gear_dynamics_warnings(const ResolvedCase& in) {
  std::vector<std::string> texts = gear_warnings(in);
  for (std::string& text : planar_warnings(in)) texts.push_back(std::move(text));
  if (!in.shape().teeth) return texts;
  const analysis::StatedDrivetrain& stated = stated_drivetrain(in);
  for (const gearset::Warning& warning : analysis::mesh_warnings(single_set(stated), stated.single().gears))
    texts.push_back(warning.key + ": " + warning.text);
  return texts;
}

}  // namespace orbearing::app
