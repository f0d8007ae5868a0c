#include "app/commands/presentation.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>

#include "app/case/bearing_type.hpp"
#include "app/case/case_file.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/use_conditions.hpp"
#include "app/results/motion_summary.hpp"
#include "app/results/sweep_table.hpp"
#include "app/results/verdicts.hpp"
#include "app/standard_error.hpp"
#include "app/study/carrier_study.hpp"
#include "app/study/life_peak.hpp"
#include "app/study/motion_budget.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/sensitivity.hpp"
#include "app/study/stiffness_study.hpp"
#include "app/study/sweep_study.hpp"
#include "app/study/sweep_warnings.hpp"
#include "coupling/analysis/parallel.hpp"
#include "coupling/analysis/roller_loads.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

ResolvedCase case_of(const StatedCase& stated) {
  return stated.given ? *stated.given : read_case(stated.file, stated.settings);
}

ResolvedCase point_of(const StatedCase& stated) {
  return stated.given ? stated.given->without_sweep() : read_point(stated.file, stated.settings);
}

void print_object(const nlohmann::ordered_json& object, const Printing& print) {
  if (print.to.result)
    print.to.result(object);
  else
    fmt::print("{}\n", object.dump(2));
}

void print_result(nlohmann::ordered_json object, const Record& record, const Printing& print) {
  if (print.to.record) print.to.record(record);
  object["units"].update(units_of(record));
  print_object(object, print);
}

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) fmt::print("warning: {}\n", printable(warning));
}

void print_failures(const std::string& line, const Printing& print) {
  if (print.to.failures)
    print.to.failures(line);
  else
    print_to_standard_error("{}\n", line);
}

namespace {

std::string first_failure(const SweepOutcome& outcome) {
  for (const SweepRow& row : outcome.rows)
    if (!row.ok()) return row.point.status;
  for (const SpectrumResult& result : outcome.spectra)
    for (const SpectrumBin& bin : result.bins)
      if (bin.row && !bin.row->ok()) return bin.row->point.status;
  return "of a spectrum that is not whole";
}

std::size_t points_of(const SweepOutcome& outcome) {
  return outcome.rows.size() + outcome.header.spectrum.points();
}

// Stiffness of one planet bearing at the operating point; of several sets, by set. None where tilts of
// planets are computed, and for other bearings than cylindrical ones: their stiffness is not computed
// (`orbearing stiffness` refuses such a case).
nlohmann::ordered_json stiffness_of_run(const ResolvedCase& resolved) {
  if (!has_cylindrical_rollers(resolved)) return nullptr;
  for (const Input& input : resolved.inputs())
    if (input.field->path == keys().tilt && resolved.has(input.path) &&
        resolved.choice(input.path) == "computed")
      return nullptr;
  const StiffnessStudy study = stiffness_study(resolved);
  const auto matrix = [](const StiffnessPoint& point) {
    Record record;
    describe(record, point);
    return json_of(record).at("stiffness");
  };
  if (study.points.size() == 1) return matrix(study.points.front());
  nlohmann::ordered_json by_set;
  for (const StiffnessPoint& point : study.points) by_set[point.set] = matrix(point);
  return by_set;
}

}  // namespace

PlannedSweep plan_sweep(const ResolvedCase& resolved, const SweepLimits& limits,
                        const std::function<SweepRequest(const ResolvedCase&)>& request_of) {
  const bool budgeted = !limits.budget.empty();
  if (budgeted) {
    budget_option(limits.budget);
    require_motion_for_budget(limits.fidelity);
  }
  PlannedSweep plan{resolved, request_of(resolved)};
  std::optional<MotionEstimate> estimate;
  if (budgeted || !limits.quiet) estimate = motion_estimate(resolved, plan.request, budgeted);
  if (!estimate) return plan;
  analysis::MotionWindows windows = estimate->stated;
  if (budgeted) {
    if (std::optional<BudgetedCase> found = within_budget(resolved, *estimate, limits.budget)) {
      plan = {found->resolved, request_of(found->resolved)};
      windows = found->windows;
      if (!limits.quiet) print_to_standard_error("{}\n", found->chosen);
    }
  }
  if (limits.quiet) return plan;
  plan.request.work = estimate->work(windows);
  const double beyond =
      estimate->seconds(windows) - std::accumulate(plan.request.work.begin(), plan.request.work.end(), 0.0);
  plan.request.announce = [beyond, added = estimate->added.size(), jobs = limits.jobs,
                           accuracy = estimate->accuracy(),
                           one = plan.request.header.continued.has_value() ||
                                 plan.request.points.size() == 1](double seconds, std::size_t missing) {
    const auto threads = static_cast<int>(analysis::threads_for(missing + added, one ? 1 : jobs));
    const std::string text = estimate_text(seconds + beyond, missing, added, threads, accuracy);
    if (!text.empty()) print_to_standard_error("{}\n", text);
  };
  return plan;
}

void put_execution(const ResultPlace& place, int jobs, const Printing& print, SweepRequest& request) {
  request.folder = place.folder;
  request.jobs = jobs;
  request.resume = place.resume;
  request.quiet = print.quiet;
  if (print.to.point)
    request.take_row = [&take = print.to.point](const ManifestHeader& header, const SweepRow& row) {
      take(row_json(header, row));
    };
}

namespace {

// Effects of assumptions at one quasi-static operating point; in a sweep or in time they would take too long.
std::vector<AssumedEffect> effects_at_rest(const ResolvedCase& resolved, const SweepOutcome& outcome) {
  const bool one = resolved.axes().empty() && outcome.rows.size() == 1 && outcome.failed == 0;
  return one && outcome.header.fidelity == "quasi-static" ? assumed_effects(resolved)
                                                          : std::vector<AssumedEffect>{};
}

// Skid risk of a single point; none of a sweep, or where the point failed.
std::optional<SkidRisk> skid_risk_of_run(const ResolvedCase& resolved, const SweepOutcome& outcome) {
  if (!resolved.axes().empty() || outcome.rows.size() != 1 || !outcome.rows.front().ok()) return std::nullopt;
  const LoadSpectrum& spectrum = outcome.header.spectrum;
  return skid_risk_of(outcome.rows.front().point,
                      spectrum.bins.empty() ? kMinimumLoad : spectrum.minimum_load);
}

}  // namespace

nlohmann::ordered_json sweep_object(const ResolvedCase& resolved, const SweepOutcome& outcome, Record& form) {
  const FoundPeak found = find_peak(outcome);
  nlohmann::ordered_json object =
      sweep_json(outcome, found.peak, assumptions_json(resolved, effects_at_rest(resolved, outcome)),
                 sweep_warnings(resolved, outcome, found), versions_json());
  form = sweep_form(found.peak);
  Record judged;
  const std::vector<Verdict> verdicts = verdicts_of(stated_requirements(resolved), outcome);
  for (Record* record : {&form, &judged}) {
    describe_verdicts(*record, verdicts);
    if (resolved.axes().empty()) describe(*record, power_of(resolved));
    if (const std::optional<SkidRisk> risk = skid_risk_of_run(resolved, outcome)) describe(*record, *risk);
  }
  object.update(json_of(judged));
  if (resolved.axes().empty() && outcome.failed == 0 && outcome.header.fidelity == "quasi-static") {
    object["stiffness"] = stiffness_of_run(resolved);
    if (has_cylindrical_rollers(resolved)) {
      const std::vector<analysis::RollerLoads> rollers = analysis::roller_loads(bearing_sets(resolved));
      object.update(json_of(record_of(rollers)));
      describe(form, rollers);
    }
    if (carrier_is_body(resolved, "")) {
      const analysis::CarrierRevolution carrier = carrier_study(resolved);
      Record child;
      for (Record* record : {&child, &form})
        record->child("carrier", "the carrier in three dimensions, over a revolution", carrier);
      object.update(json_of(child));
    }
  }
  object["units"].update(units_of(form));
  return object;
}

namespace {

void add_earlier_findings(const FindingsBeforeSweep& before, nlohmann::ordered_json& object) {
  if (before.record == nullptr) return;
  nlohmann::ordered_json whole = json_of(*before.record);
  whole.update(object);
  whole["warnings"] = before.warnings;
  for (const nlohmann::ordered_json& warning : object.at("warnings")) whole["warnings"].push_back(warning);
  whole["units"].update(units_of(*before.record));
  object = std::move(whole);
}

}  // namespace

int present_sweep(const ResolvedCase& resolved, const SweepOutcome& outcome, const Printing& print,
                  const FindingsBeforeSweep& before) {
  if (print.json) {
    Record form;
    nlohmann::ordered_json object = sweep_object(resolved, outcome, form);
    add_earlier_findings(before, object);
    print_result(std::move(object), form, print);
  } else if (!print.quiet) {
    const FoundPeak found = find_peak(outcome);
    if (before.record != nullptr) fmt::print("{}\n", text_of(*before.record));
    if (resolved.axes().empty() && outcome.rows.size() == 1 && outcome.header.fidelity != "quasi-static")
      fmt::print("{}\n",
                 motion_summary_text(outcome.rows.front().point, skid_risk_of_run(resolved, outcome)));
    fmt::print("{}{}\n{}{}", lives_text_of(resolved, outcome), sweep_table(outcome.header, outcome.rows),
               peak_text(outcome.header, outcome.rows, found.peak),
               spectrum_text(outcome.header, outcome.spectra));
    if (const auto verdicts = verdicts_of(stated_requirements(resolved), outcome); !verdicts.empty())
      fmt::print("\n{}", verdicts_text(verdicts));
    fmt::print("{}", assumed_effects_text(resolved, effects_at_rest(resolved, outcome)));
    print_warnings(before.warnings);
    print_warnings(sweep_warnings(resolved, outcome, found));
  }
  if (outcome.failed == 0) return 0;
  print_failures(fmt::format("{} of {} points failed; their rows say why, the first: {}", outcome.failed,
                             points_of(outcome), first_failure(outcome)),
                 print);
  return 1;
}

}  // namespace orbearing::app
