#include "orbearing/analyses.hpp"

#include <algorithm>

#include "app/case/machine_of.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/study/analysis.hpp"
#include "app/study/crown/crown_study.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/gear_case.hpp"
#include "app/study/life_peak.hpp"
#include "app/study/mesh_study.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/sweep_study.hpp"
#include "app/study/sweep_warnings.hpp"

namespace orbearing {

namespace {

const std::string& name_of(Fidelity fidelity) {
  return app::fidelity_names().at(static_cast<std::size_t>(fidelity));
}

/// A sweep, or the one point of a case without one, with its warnings.
struct Computed {
  app::SweepOutcome outcome;
  std::vector<std::string> warnings;
};
Computed computed(const app::ResolvedCase& in, app::SweepRequest request) {
  request.quiet = true;
  Computed found{app::run_sweep(request), {}};
  found.warnings = app::sweep_warnings(in, found.outcome, app::find_peak(found.outcome));
  return found;
}

Warned<OperatingPoint> point_of(const Case& drivetrain, Fidelity fidelity) {
  const app::ResolvedCase in = drivetrain.content().without_sweep();
  app::require_computable(in, name_of(fidelity), false);
  app::SweepRequest request = app::sweep_request(in, name_of(fidelity));
  analysis::PointResult point;
  request.point_files = false;
  request.evaluate = [&point, compute = request.evaluate](std::size_t index) {
    return point = compute(index);
  };
  Computed found = computed(in, std::move(request));
  const app::SweepRow& row = found.outcome.rows.front();
  if (!row.ok()) throw ComputationFailed(in.text("name") + ": " + row.point.status);
  OperatingPoint result{std::move(point)};
  result.governing_life_hours = app::governing_hours(found.outcome.header, row.point);
  return {std::move(result), std::move(found.warnings)};
}

}  // namespace

Warned<OperatingPoint> quasi_static(const Case& drivetrain) {
  return point_of(drivetrain, Fidelity::quasi_static);
}

Warned<OperatingPoint> in_motion(const Case& drivetrain, Fidelity fidelity) {
  return point_of(drivetrain, fidelity);
}

Warned<Sweep> sweep(const Case& drivetrain, const SweepChoices& choices) {
  const app::ResolvedCase& stated = drivetrain.content();
  const app::ResolvedCase in =
      choices.speeds.empty() ? stated : stated.sweeping(app::keys().speed, choices.speeds);
  app::require_computable(in, name_of(choices.fidelity), true);
  app::SweepRequest request = app::sweep_request(in, name_of(choices.fidelity));
  request.jobs = choices.jobs;
  if (!choices.grid_alone) app::refine_peak_of(in, request);
  Computed found = computed(in, std::move(request));
  const app::ManifestHeader& header = found.outcome.header;
  Sweep result{.life = header.life};
  for (const app::SweepRow& row : found.outcome.rows) {
    result.points.push_back(row.point);
    result.governing_life_hours.push_back(app::governing_hours(header, row.point));
  }
  if (const app::SweepRow* longest = app::longest_lived(header, found.outcome.rows))
    result.longest_lived = static_cast<std::size_t>(longest - found.outcome.rows.data());
  return {std::move(result), std::move(found.warnings)};
}

analysis::BearingUnderLoad under_load(const Case& bearing) {
  const app::ResolvedCase& in = bearing.content();
  if (in.model() != app::roller_bearing && in.model() != app::ball_bearing)
    throw BadInput(in.origin("model") + ": model: found " + in.choice("model") +
                   "; required: roller-bearing, or ball-bearing without a block simulation");
  const std::vector<std::string> unused = app::require_used(in, app::analysis_of(in)->used);
  analysis::BearingUnderLoad found =
      in.model() == app::roller_bearing
          ? analysis::rollers_under_load(app::machine_of<analysis::RollersUnderLoad>(in))
          : analysis::balls_under_load(app::machine_of<analysis::BallsUnderLoad>(in));
  found.warnings = app::joined(unused, app::rating_warnings(in), found.warnings);
  return found;
}

analysis::MeshStudy mesh(const Case& gears) {
  return app::mesh_study_with_warnings(gears.content().without_sweep());
}

Warned<analysis::ModeStudy> modes(const Case& gears) {
  const app::ResolvedCase in = gears.content().without_sweep();
  if (in.model() != app::planetary_drivetrain)
    throw BadInput(in.origin("model") + ": model: found " + in.choice("model") +
                   "; required: planetary-drivetrain");
  std::vector<std::string> warnings =
      app::joined(app::gear_dynamics_warnings(in), app::require_used(in, app::AnalysisId::modes));
  return {app::mode_study(app::gear_model_of(in)), std::move(warnings)};
}

namespace {

CrownedRoller roller_of(const app::CrownDesign& design) {
  return {design.profile, design.crown.drop, design.life_hours, design.peak_pressure};
}

}  // namespace

Warned<Crowning> crown(const Case& drivetrain, int jobs) {
  const auto [in, noted] = app::crown_case(drivetrain.content(), {});
  app::require_crown_uses(in, {});  // refuses before it computes
  app::CrownStudy study = app::crown_study(app::crown_request(in, {}), jobs, [](std::size_t) {});
  app::put_lives_in_run(drivetrain.content(), "", jobs, study);
  return {{roller_of(study.recommended.design), roller_of(study.searches.at(study.best).best),
           roller_of(study.straight), roller_of(study.reference)},
          app::crown_warnings(in, {}, noted, study)};
}

}  // namespace orbearing
