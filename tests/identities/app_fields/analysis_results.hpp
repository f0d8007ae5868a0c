// Results of each analysis of a case, as one text with all digits: equal texts are results equal to the last
// bit.
#pragma once

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/case/drivetrain_analyses.hpp"
#include "app/case/field_use.hpp"
#include "app/case/machines.hpp"
#include "app/case/spectrum_case.hpp"
#include "app/case/use_conditions.hpp"
#include "app/results/record_writers.hpp"
#include "app/results/sweep_row.hpp"
#include "app/results/verdicts.hpp"
#include "app/study/carrier_study.hpp"
#include "app/study/crown/crown_study.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/fmu_model.hpp"
#include "app/study/gear_case.hpp"
#include "app/study/mesh_study.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/resonance_lines.hpp"
#include "app/study/scratch_case.hpp"
#include "app/study/stiffness_study.hpp"
#include "app/study/sweep_study.hpp"
#include "coupling/analysis/crowning/crown_grid.hpp"
#include "coupling/analysis/multi_stage.hpp"
#include "coupling/fmu/model.hpp"

namespace orbearing::app::fields_test {

template <class Numbers>
std::string digits(const Numbers& numbers) {
  std::string text;
  for (const double number : numbers) text += fmt::format("{} ", number);
  return text;
}

/// All that a result describes and prints.
template <class Result>
std::string record_text(const Result& result) {
  return json_of(record_of(result)).dump();
}

/// Verdicts on the requirements that the case states.
inline std::string verdicts_result(const std::vector<Verdict>& verdicts) {
  Record record;
  describe_verdicts(record, verdicts);
  return json_of(record).dump();
}

/// Result of a machine, with the verdicts on its lives.
inline std::string machine_text(const ResolvedCase& in, const MachineAnalysis& analysis) {
  const AnalysisResult result = analysis.compute(in, {});
  const std::string text = json_of(result.record).dump();
  return result.lives ? text + verdicts_result(verdicts_of(stated_requirements(in), result.lives->value))
                      : text;
}

/// Analyses of a machine by their commands, as bits.
template <class... Commands>
AnalysisSet analyses_of_machine(Model model, const Commands&... commands) {
  return (AnalysisSet(machine_analysis(model, commands)->used) | ...);
}

/// Lives under the spectrum that the case states, and what each bin uses up.
inline std::string spectrum_result(const ResolvedCase& in, analysis::Fidelity fidelity) {
  SweepRequest request = sweep_request(in, fidelity_names().at(static_cast<std::size_t>(fidelity)));
  request.quiet = true;
  const SweepOutcome outcome = run_sweep(request);
  return spectrum_json(outcome.header, outcome.spectra).dump();
}

/// The nearest resonance of the gears, which rows of points in motion name.
inline std::string resonance_result(const ResolvedCase& in, const analysis::PointResult& point,
                                    analysis::Fidelity fidelity) {
  SweepRequest request;
  request.header.fidelity = fidelity_names().at(static_cast<std::size_t>(fidelity));
  name_resonances(in, request);
  if (!request.resonance_of) return "";
  const std::optional<Resonance> found = request.resonance_of({.input_speed = point.input_speed});
  return found ? json_of(record_of(*found)).dump() : "";
}

/// One point of a run or sweep: all columns, the loads by place, the final state.
inline std::string point_result(const ResolvedCase& in, analysis::Fidelity fidelity) {
  const analysis::PointResult point = analysis::evaluate(bearing_sets(in), fidelity);
  const ManifestHeader header{.sets = bearing_set_names(in)};
  const SweepRow row = sweep_row(point, header);
  std::vector<double> numbers;
  for (const auto& [name, number] : named_numbers(header, row)) numbers.push_back(number);
  std::string text = digits(numbers) + digits(std::vector<double>{analysis::governing_hours(point)}) +
                     digits(point.distribution.inner_load) + digits(point.distribution.outer_load);
  if (point.dynamic) text += digits(point.dynamic->final_state) + resonance_result(in, point, fidelity);
  if (point.coupled) text += digits(point.coupled->bearing_life_hours);
  if (in.has(kSpectrumPath)) text += spectrum_result(in, fidelity);
  const SweepOutcome outcome{header, {row}};
  text += verdicts_result(verdicts_of(stated_requirements(in), outcome));
  return text + point.status;
}

/// One profile of the study, at one tilt.
inline std::string crown_result(const ResolvedCase& in) {
  using namespace analysis::crowning;
  constexpr double drop = 4e-6, tilt = 1e-3;  // [m], [rad]  any that load a part of the roller less
  CrownChoices options;
  if (in.shape().several) options.of_set = in.shape().sets.front();
  const CrownRequest request = crown_request(in, options);
  const CrownProblem problem = problem_of(request);
  const ProfileFamily family = family_in(problem, request.profiles.front());
  const CrownPoint point =
      crown_grid(problem, RollerPressure(problem), {profile_of(family, {drop, default_share(family)})},
                 {drop}, {tilt}, 1, {})
          .front();
  return digits(std::vector{point.life_hours, point.rated_hours.basic, point.rated_hours.reference,
                            point.rated_hours.modified_reference, point.pressure.peak,
                            point.pressure.edge_ratio}) +
         point.status;
}

/// Outputs of the model inside an FMU, run for a while at fixed inputs, with the parameters that the FMU
/// shows, or with `parameters`.
inline std::string machine_result(const fmu::NumberTable& numbers, bool bearing,
                                  std::vector<double> parameters = {}) {
  constexpr double step = 2e-5;  // [s]
  constexpr int steps = 200;     // some revolutions of the cage pockets past the load
  const fmu::ModelFacts facts = fmu::facts_of(numbers);
  std::vector<double> inputs;
  if (parameters.empty())
    for (const fmu::ShownField& parameter : facts.shown.parameters) parameters.push_back(parameter.start);
  for (const system::Input& input : facts.inputs) inputs.push_back(input.start);
  if (bearing) {
    inputs.at(0) = 2e-6;  // [m]        outward
    inputs.at(1) = 6e-6;  // [m]        under load
    inputs.at(6) = 2e3;   // [rad/s^2]  of the carrier
  }
  if (!bearing) inputs.at(0) += 200.0;  // [N]  on one planet, so that bodies leave their places
  const std::unique_ptr<system::Participant> driven = fmu::make_participant(numbers, parameters);
  driven->initialize(0.0, inputs);
  for (int i = 0; i < steps; ++i) {
    std::vector<system::InputPolynomial> polynomials;
    for (const double input : inputs) polynomials.push_back(system::InputPolynomial::constant(input));
    driven->advance({i * step, (i + 1) * step}, polynomials);
  }
  return digits(driven->values(inputs, facts.outputs.size()));
}

inline std::string modes_result(const ResolvedCase& in, bool rotating) {
  constexpr double carrier_speed = 100.0, nominal_speed = 900.0;  // [rad/s]
  const auto model = gear_model_of(in, rotating ? carrier_speed : 0.0);
  if (!rotating) {
    Record spatial;
    if (carrier_is_body(in, "")) describe_spatial_modes(spatial, in);
    return record_text(mode_study(model)) + json_of(spatial).dump();
  }
  return record_text(mode_study(model, true)) + record_text(campbell(model, nominal_speed));
}

inline std::string gears_result(const ResolvedCase& in) {
  return record_text(analysis::run_gears(moving_gears_of(in), gear_run_options(in)));
}

inline std::string result_of(const ResolvedCase& in, AnalysisId analysis) {
  switch (analysis) {
    case AnalysisId::quasi_static:
      return point_result(in, analysis::Fidelity::quasi_static);
    case AnalysisId::dynamic:
    case AnalysisId::dynamic_of_sets:
      return point_result(in, analysis::Fidelity::dynamic);
    case AnalysisId::co_simulated:
      return point_result(in, analysis::Fidelity::co_simulated);
    case AnalysisId::monolithic:
      return point_result(in, analysis::Fidelity::monolithic);
    case AnalysisId::planet_defect:
      return record_text(vibration_of_scratched_set(scratched_set_of(in)));
    case AnalysisId::crown:
      return crown_result(in);
    case AnalysisId::gears:
      return gears_result(in);
    case AnalysisId::modes:
    case AnalysisId::modes_at_speed:
      return modes_result(in, analysis == AnalysisId::modes_at_speed);
    case AnalysisId::mesh:
      return record_text(mesh_study(in));
    case AnalysisId::carrier:
      return record_text(carrier_study(in));
    case AnalysisId::fmu_bearing:
      return machine_result(bearing_numbers(in), true);
    case AnalysisId::fmu_gearset:
      return machine_result(gear_numbers(in), false);
    case AnalysisId::planet_stiffness:
      return record_text(stiffness_study(in));
    default:
      break;
  }
  const auto of_machine = std::ranges::find(machine_analyses(), analysis, &MachineAnalysis::used);
  return of_machine == machine_analyses().end() ? "" : machine_text(in, *of_machine);
}

}  // namespace orbearing::app::fields_test
