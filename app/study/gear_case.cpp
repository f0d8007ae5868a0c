#include "app/study/gear_case.hpp"

#include <fmt/format.h>

#include "app/case/bearing_type.hpp"
#include "app/case/described_case.hpp"
#include "app/case/machine_of.hpp"
#include "app/case/machines.hpp"
#include "app/case/set_case.hpp"
#include "app/errors.hpp"
#include "app/study/drivetrain_case.hpp"
#include "coupling/analysis/gear_quantities.hpp"

namespace orbearing::app {

study::SetGears set_gears_of(const ResolvedCase& in) {
  study::SetGears gears{.choice = from_case<study::GearDynamicsChoice>(in),
                        .material = from_case<mechanics::Elasticity>(in)};
  if (!in.shape().teeth) return gears;
  gears.choice.bodies = machine_of<gearset::BodyRatios>(in);
  gears.choice.run_up = machine_of<gearset::dynamics::RunUp>(in);
  gears.choice.frame = machine_of<gearset::dynamics::FrameSwitches>(in);
  return gears;
}

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
                  in.origin("bearing.type"), in.choice("bearing.type")));
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

}  // namespace

gearset::dynamics::SetModel gear_model_of(const ResolvedCase& in,
                                          const study::PlanetaryDrivetrain& drivetrain,
                                          const std::optional<study::DrivetrainGeometry>& known) {
  require_one_set(in);
  const study::SetGears gears = set_gears_of(in);
  if (!in.shape().teeth) return study::toothless_model(stated_set(in), gears.choice, 0.0);
  if (!known) require_known_springs(in);
  return of_sound_gears(in, [&] {
    return study::gear_model(drivetrain, known ? *known : study::geometry_of(drivetrain), gears);
  });
}

gearset::dynamics::SetModel gear_model_of(const ResolvedCase& in, double carrier_speed) {
  require_one_set(in);
  return in.shape().teeth ? gear_model_of(in, drivetrain_without_gear_set(in))
                          : study::toothless_model(stated_set(in), set_gears_of(in).choice, carrier_speed);
}

std::function<gearset::dynamics::SetParameters()> gears_of(
    const ResolvedCase& in, const study::PlanetaryDrivetrain& drivetrain,
    const std::optional<study::DrivetrainGeometry>& known) {
  return [in, any_type = known.has_value(),
          built = study::gears_built_once(drivetrain, set_gears_of(in), known)] {
    if (!any_type) require_known_springs(in);
    return of_sound_gears(in, built);
  };
}

gearset::dynamics::SetModel moving_gears_of(const ResolvedCase& in) {
  const gearset::dynamics::SetModel model = gear_model_of(in);
  return in.shape().teeth && !in.flag("gearset.mesh_variation") ? gearset::dynamics::averaged(model) : model;
}

study::GearRunOptions gear_run_options(const ResolvedCase& in) {
  return study::gear_run_options(machine_of<study::GearRunPeriods>(in));
}

std::vector<Derived> gear_dynamics_quantities(const ResolvedCase& in) {
  require_one_set(in);
  require_known_springs(in);
  described::Record record;
  if (!in.shape().teeth)
    describe(record, analysis::GearQuantities{gear_model_of(in)});
  else
    describe(record, of_sound_gears(in, [&] {
               return analysis::gear_quantities(drivetrain_without_gear_set(in), set_gears_of(in));
             }));
  return derived_rows(record);
}

std::vector<std::string> gear_dynamics_warnings(const ResolvedCase& in) {
  std::vector<std::string> texts = gear_warnings(in);
  for (std::string& text : planar_warnings(in)) texts.push_back(std::move(text));
  if (!in.shape().teeth) return texts;
  for (const gearset::Warning& warning :
       study::mesh_warnings(drivetrain_without_gear_set(in), set_gears_of(in)))
    texts.push_back(warning.key + ": " + warning.text);
  return texts;
}

}  // namespace orbearing::app
