#include "app/results/verdicts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <utility>

#include "app/case/input_keys.hpp"
#include "app/results/record_writers.hpp"
#include "bearing/life/life_modification.hpp"

namespace orbearing::app {

namespace {

// The result of that name of the worst bearing.
using ValueOfWorst = std::function<WorstBearing(const std::string& key)>;

/// Load condition at which requirements are judged: an operating point, a bin or a whole spectrum.
struct Sample {
  std::function<ValueOfWorst()> values;
  std::string at;
  std::string failure{};  // of a point that was not computed
};

const char* bound_text(const Requirement& requirement) {
  return requirement.at_most ? "at most" : "at least";
}

bool is_met(const Requirement& requirement, double value) {
  return requirement.at_most ? value <= requirement.limit : value >= requirement.limit;
}

bool is_worse(const Requirement& requirement, double value, double other) {
  return requirement.at_most ? value > other : value < other;
}

// "L10mr_Mrev" of "L10mrh".
std::string in_revolutions(const std::string& life) {
  return (life == "life_h" ? "life" : life.substr(0, life.size() - 1)) + "_Mrev";
}

bool needs_oil(const std::string& key) {
  return key == "L10mh" || key == "L10mrh" || key == "kappa";
}

std::string missing_reason(const std::string& key, const ValueOfWorst& of_worst) {
  const double kappa = of_worst("kappa").value;
  if (needs_oil(key) && std::isnan(kappa))
    return "the case states no oil; state lubricant.grade, lubricant.temperature and life.cleanliness";
  if (needs_oil(key) && kappa < bearing::rating::kLeastViscosityRatio)
    return fmt::format("kappa is {:.3g}; a_ISO of ISO 281 begins at {:g}", kappa,
                       bearing::rating::kLeastViscosityRatio);
  if (is_life(key) && !std::isnan(of_worst(in_revolutions(key)).value))
    return "the rings do not rotate; state operation.shaft_speed";
  if (key == "largest_load_share")
    return "all planets carry the same load in this case; state errors of the pins, as " +
           keys().tangential_pin_errors;
  return "ISO 281 and ISO 76 have equivalent loads for nominal contact angles of 0, 15, 20, 25, 30, 35, 40 "
         "and 45 degrees; a life by L10rh or L10mrh does not require them";
}

// One of `samples` conditions at which a verdict is given.
void judge_at(const Sample& sample, const ValueOfWorst& of_worst, std::size_t samples, Verdict& verdict) {
  const Requirement& requirement = verdict.requirement;
  const WorstBearing worst = sample.failure.empty() ? of_worst(requirement.key) : WorstBearing{};
  if (std::isnan(worst.value)) {
    if (!verdict.reason.empty()) return;
    verdict.reason = sample.failure.empty() ? missing_reason(requirement.key, of_worst)
                                            : "a point was not computed: " + sample.failure;
    if (samples > 1) verdict.reason = sample.at + ": " + verdict.reason;
    return;
  }
  if (!is_met(requirement, worst.value)) ++verdict.points_failed;
  if (!std::isnan(verdict.value) && !is_worse(requirement, worst.value, verdict.value)) return;
  verdict.value = worst.value;
  verdict.result = worst.key;
  verdict.of_set = worst.set;
  verdict.at = sample.at;
}

void conclude(Verdict& verdict) {
  // One failed point decides; that all pass requires all points.
  if (verdict.points_failed > 0)
    verdict.passed = false;
  else if (verdict.reason.empty())
    verdict.passed = true;
  if (std::isinf(verdict.value) && verdict.reason.empty()) verdict.reason = "no load: a life without limit";
}

// Samples by which requirements are judged: under a load spectrum for lives, for the load sharing and for all
// else; without one there are `of_others` alone.
struct Samples {
  std::vector<Sample> of_lives, of_sharing, of_others;
};

const std::vector<Sample>& samples_for(const Requirement& requirement, const Samples& samples) {
  if (requirement.name == "life" && !samples.of_lives.empty()) return samples.of_lives;
  if (requirement.name == "load_share" && !samples.of_sharing.empty()) return samples.of_sharing;
  return samples.of_others;
}

// Numbers of a sample are gathered once for all requirements.
std::vector<Verdict> verdicts_at(const std::vector<Requirement>& requirements, const Samples& samples) {
  std::vector<Verdict> verdicts;
  for (const Requirement& one : requirements)
    verdicts.push_back({.requirement = one, .result = one.key, .points = samples_for(one, samples).size()});
  for (const auto* of : {&samples.of_lives, &samples.of_sharing, &samples.of_others})
    for (const Sample& sample : *of) {
      const ValueOfWorst of_worst = sample.values();
      for (Verdict& verdict : verdicts)
        if (&samples_for(verdict.requirement, samples) == of) judge_at(sample, of_worst, of->size(), verdict);
    }
  std::ranges::for_each(verdicts, conclude);
  return verdicts;
}

// Errors of pins have little effect where the torque is large: a gear rating takes K_gamma at full load.
const SpectrumBin* of_largest_torque(const SpectrumResult& result) {
  const SpectrumBin* largest = nullptr;
  for (const SpectrumBin& one : result.bins)
    if (one.row && one.bin.share > 0.0 &&
        (largest == nullptr || std::abs(one.bin.torque()) > std::abs(largest->bin.torque())))
      largest = &one;
  return largest;
}

// In a row a life without load has no number, as that by Lundberg and Palmgren beside it.
ValueOfWorst values_in_row(const ManifestHeader& header, const SweepRow& row) {
  using Named = std::pair<std::string, double>;
  const auto numbers = std::make_shared<const std::vector<Named>>(named_numbers(header, row));
  const auto number = [numbers](const std::string& name) {
    const auto found = std::ranges::find(*numbers, name, &Named::first);
    return found == numbers->end() ? described::kAbsent : found->second;
  };
  const auto column = [number](const std::string& name) {
    const double value = number(name);
    const std::size_t begin = name.rfind('.') + 1;  // behind that of a set
    const bool unloaded = std::isnan(value) && is_life(name.substr(begin)) &&
                          std::isnan(number(name.substr(0, begin) + "life_h"));
    return unloaded ? std::numeric_limits<double>::infinity() : value;
  };
  return [column, &sets = header.sets](const std::string& key) {
    return worst_bearing(key, key.ends_with("_Mrev") ? std::vector<std::string>{} : sets, column);
  };
}

std::string axes_text(const ManifestHeader& header, const SweepRow& row) {
  std::string text;
  for (std::size_t i = 0; i < header.axes.size(); ++i)
    text += fmt::format(", {} = {:.6g}", header.axes[i].column, row.axes[i]);
  return text;
}

Sample sample_of(const ManifestHeader& header, const SweepRow& row, const std::string& bin = "") {
  return {[&header, &row] { return values_in_row(header, row); },
          fmt::format("{}input_speed_rpm = {:.6g}{}", bin, speed_in_rpm(row.point.input_speed),
                      axes_text(header, row)),
          row.ok() ? "" : row.point.status};
}

// Lives under a spectrum, and the least viscosity ratio of its bins, which explains a missing life.
ValueOfWorst values_under_spectrum(const SweepOutcome& outcome, const SpectrumResult& result) {
  return [&outcome, &result](const std::string& key) {
    if (key != "kappa")
      return worst_bearing(key, outcome.header.sets,
                           [&](const std::string& name) { return life_of(result, name); });
    WorstBearing least{.key = key};
    for (const SpectrumBin& bin : result.bins)
      if (bin.row) least.value = std::fmin(least.value, values_in_row(outcome.header, *bin.row)(key).value);
    return least;
  };
}

Sample sample_of(const SweepOutcome& outcome, const SpectrumResult& result) {
  Sample sample{[&] { return values_under_spectrum(outcome, result); }, "load spectrum"};
  for (const SpectrumBin& bin : result.bins) {
    if (!bin.row) continue;
    if (!bin.row->ok()) sample.failure = bin.row->point.status;
    if (outcome.spectra.size() > 1) sample.at = "load spectrum" + axes_text(outcome.header, *bin.row);
  }
  return sample;
}

}  // namespace

void describe(Record& record, const Verdict& verdict) {
  const Requirement& requirement = verdict.requirement;
  record.value("requirement", "key of the block requirements", requirement.name);
  record.value("value", {}, "the worst result, in the stated unit", verdict.value);
  record.value("limit", {}, "that the case requires, in the stated unit", requirement.limit);
  if (verdict.passed)
    record.value("passed", "whether the requirement is met", *verdict.passed);
  else
    record.nothing("passed", "whether the requirement is met");
  record.value("key", "name among the results", requirement.key);
  record.value(
      "result",
      "column of that value: of the bearing with the shortest life where bearings carry unlike loads",
      verdict.result);
  record.value("of_set", "of several sets, the one with that value", verdict.of_set);
  record.value("unit", "of value and limit", requirement.unit);
  record.value("bound", "at least or at most", bound_text(requirement));
  record.value("at", "operating point or bin of the worst result", verdict.at);
  record.value("reason", "why there is no number", verdict.reason);
  record.value("points", "operating points that were judged", verdict.points);
  record.value("points_failed", "of these, points that do not meet the requirement", verdict.points_failed);
}

void describe_verdicts(Record& record, const std::vector<Verdict>& verdicts) {
  if (!verdicts.empty())
    record.table("verdicts", "verdict", "requirements of the case", verdicts).detail = true;
}

std::string verdicts_text(const std::vector<Verdict>& verdicts) {
  if (verdicts.empty()) return "";
  std::string text = fmt::format("{:<26} {:>12} {:>8} {:>12} {:<4} {}\n", "requirement", "value", "", "limit",
                                 "unit", "verdict");
  for (const Verdict& one : verdicts) {
    const Requirement& requirement = one.requirement;
    const bool named = requirement.name == "life", shortest = one.result != requirement.key;
    const std::string value = std::isfinite(one.value) ? fmt::format("{:.6g}", one.value) : "-";
    const char* judged = !one.passed ? "not judged" : *one.passed ? "passed" : "FAILED";
    text += fmt::format(
        "{:<26} {:>12} {:>8} {:>12.6g} {:<4} {}{}{}{}\n",
        named ? fmt::format("life ({}{})", shortest ? "shortest " : "", requirement.key) : requirement.name,
        value, bound_text(requirement), requirement.limit, requirement.unit, judged,
        one.of_set.empty() ? "" : ", set " + one.of_set,
        one.at.empty() ? "" : (one.points > 1 ? ", worst at " : ", at ") + one.at,
        one.reason.empty() ? "" : ": " + one.reason);
  }
  return text;
}

std::vector<Verdict> verdicts_of(const std::vector<Requirement>& requirements, const LifeValue& value) {
  const ValueOfWorst of_worst = [&](const std::string& key) { return worst_bearing(key, {}, value); };
  return verdicts_at(requirements, {{}, {}, {{[&] { return of_worst; }, ""}}});
}

std::vector<Verdict> verdicts_of(const std::vector<Requirement>& requirements, const SweepOutcome& outcome) {
  if (requirements.empty()) return {};
  Samples samples;
  for (const SpectrumResult& result : outcome.spectra) {
    samples.of_lives.push_back(sample_of(outcome, result));
    const SpectrumBin* largest = of_largest_torque(result);
    for (std::size_t i = 0; i < result.bins.size(); ++i) {
      const SpectrumBin& bin = result.bins[i];
      if (!bin.row || !(bin.bin.share > 0.0)) continue;
      samples.of_others.push_back(sample_of(outcome.header, *bin.row, fmt::format("bin {}, ", i + 1)));
      if (&bin == largest) samples.of_sharing.push_back(samples.of_others.back());
    }
  }
  if (!outcome.spectra.empty()) return verdicts_at(requirements, samples);
  for (const SweepRow& row : outcome.rows) samples.of_others.push_back(sample_of(outcome.header, row));
  return verdicts_at(requirements, samples);
}

}  // namespace orbearing::app
