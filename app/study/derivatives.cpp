#include "app/study/derivatives.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <mutex>
#include <nlohmann/json.hpp>
#include <tuple>
#include <utility>

#include "app/case/defect_case.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/static_case.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/errors.hpp"
#include "app/results/record_writers.hpp"
#include "app/results/sweep_row.hpp"
#include "app/results/worst_bearing.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/planetary_case.hpp"
#include "coupling/analysis/multi_stage.hpp"
#include "coupling/analysis/parallel.hpp"

namespace orbearing::app {

namespace {

using Json = nlohmann::ordered_json;

// A run, as what it prints.
struct Run {
  AnalysisId analysis;
  double scatter;
  std::function<Json(const ResolvedCase&)> compute;
};

// The row of its one point.
Json drivetrain_point(const ResolvedCase& in, analysis::Fidelity fidelity) {
  const ManifestHeader header{.sets = bearing_set_names(in)};
  return row_json(header, sweep_row(analysis::evaluate(bearing_sets(in), fidelity), header));
}

bool is_of_planet_bearings(const ResolvedCase& in) {
  return in.shape().several ? !bearing_set_names(in).empty() : in.shape().bearing;
}

Run run_of_drivetrain(const ResolvedCase& in, const std::string& fidelity) {
  require_computable(in, fidelity, false);
  const analysis::Fidelity level = fidelity_of(fidelity);
  return {rung_of(in, fidelity), in_time(level) ? scatter::in_motion : scatter::at_rest,
          [level](const ResolvedCase& changed) { return drivetrain_point(changed, level); }};
}

Run run_of(const ResolvedCase& in, const std::string& fidelity) {
  const Analysis* analysis = analysis_of(in, fidelity);
  if (analysis == nullptr && is_of_planet_bearings(in))
    return run_of_drivetrain(in, fidelity.empty() ? "quasi-static" : fidelity);
  const Analysis& row = analysis != nullptr ? *analysis : gears_alone();
  return {row.used, row.scatter, [compute = row.compute](const ResolvedCase& changed) {
            return json_of(compute(changed, {}).record);
          }};
}

[[noreturn]] void refuse_life(const ResolvedCase& in, const std::string& path, const std::string& found,
                              const std::string& required) {
  throw BadInput(in.origin(path) + ": " + path + ": found " + found + "; required: " + required);
}

// Key and unit of the governing life.
std::pair<std::string, std::string> life_key(const ResolvedCase& in) {
  if (is_static_bearing(in) && in.quantity(keys().shaft_speed) == in.quantity(keys().outer_speed))
    return {bearing::rating::revolutions_key(governing_life(in)), "Mrev"};
  if (is_static_bearing(in) || is_ball_run(in)) return {governing_life_key(in), "h"};
  if (in.model() != planetary_drivetrain)
    refuse_life(
        in, "model", in.choice("model"),
        "a case with a life: planetary-drivetrain, roller-bearing or ball-bearing; --result names any "
        "other number of its run");
  if (is_planet_defect(in))
    throw BadInput(
        in.file() +
        ": defect: found a scratched planet bearing; required: none, for a life; --result names any "
        "other number of its run");
  if (!is_of_planet_bearings(in))
    throw BadInput(in.file() + ": bearing: missing; required: a planet bearing, for its life");
  return {governing_life_key(in), "h"};
}

double number_of(const Json& object, const std::string& key) {
  const Json::json_pointer position("/" + key);
  const bool found = object.contains(position) && object.at(position).is_number();
  return found ? object.at(position).get<double>() : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

ScalarResult scalar_result(const ResolvedCase& in, const std::string& fidelity, const std::string& key) {
  ScalarResult result{.quantity = key, .unit = ""};
  if (key.empty()) std::tie(result.quantity, result.unit) = life_key(in);
  Run run = run_of(in, fidelity);
  result.analysis = run.analysis;
  result.scatter = run.scatter;
  const std::string set = limiting_set_column;
  // With several sets, the row is that of the set with the worst bearing.
  result.compute = [compute = std::move(run.compute), quantity = result.quantity, named = !key.empty(),
                    set](const ResolvedCase& changed) -> ScalarResult::Value {
    const Json object = compute(changed);
    const auto number = [&](const std::string& name) { return number_of(object, name); };
    const WorstBearing worst =
        named ? WorstBearing{number(quantity), quantity} : worst_bearing(quantity, {}, number);
    return {worst.value, worst.key, object.value(set, "")};
  };
  return result;
}

ScalarResult::Value value_here(const ResolvedCase& in, const ScalarResult& result) {
  ScalarResult::Value here = result.compute(in);
  if (std::isfinite(here.number)) return here;
  if (result.unit.empty())
    throw BadInput("--result: found " + result.quantity + "; required: the key of a number that run prints");
  if (is_static_bearing(in) || result.quantity == "life_h")
    throw ComputationFailed(in.text("name") + ": no element is loaded; the life is infinite");
  refuse_life(in, keys().life_method,
              in.choice(keys().life_method) + ", by which there is no " + result.quantity + " here",
              "a case with that life, or lundberg-palmgren");
}

namespace {

// Slopes below this change only the last digits of a quasi-static result.
constexpr double kNothing = 1e-8;  // [-]  of ln of the result
// Slopes to both sides that differ by more mean that a quasi-static result has no derivative.
constexpr double kKink = 1e-2;

// One number of the case: that of an input, or an element of its list.
struct CaseNumber {
  Input input;
  std::optional<std::size_t> item{};

  std::string path() const { return item ? fmt::format("{}[{}]", input.path, *item) : input.path; }
  double value(const ResolvedCase& in) const {  // [SI]
    return item ? in.value(input.path).list.at(*item) : in.value(input.path).number;
  }
  std::string_view unit() const {
    const std::string_view customary = input.field->dimension.customary;
    return customary.empty() ? "1" : customary;
  }
  double per_unit() const {  // [SI/unit]
    const Dimension& dimension = input.field->dimension;
    return dimension.si.empty() ? 1.0 : convert(1.0, dimension.customary, dimension.si).value.value_or(1.0);
  }
  // With the number changed by an offset of (1); none where another input decides it. Throws BadInput where
  // that is no case.
  std::optional<ResolvedCase> changed(const ResolvedCase& in, double offset) const {
    constexpr double round_off = 1e-12;
    const double here = value(in);
    const double required = here != 0.0 ? here * std::exp(offset) : offset * per_unit();
    ResolvedCase other = in.with(path(), required);
    if (std::abs(value(other) - required) > round_off * std::abs(required)) return std::nullopt;
    return other;
  }
};

std::string one_line(const std::exception& error) {
  const std::string text = error.what();
  return text.substr(0, text.find('\n'));
}

// The two runs of a number.
struct Pair {
  CaseNumber number;
  int side = 0;
  std::vector<ResolvedCase> cases{};
  std::array<double, 2> results{};
  std::string failure{};  // of a run
};

std::array<double, 2> offsets(int side) {
  return side == 0 ? std::array{-1.0, 1.0} : std::array{1.0 * side, 2.0 * side};
}

// An input with the reason for no derivative, or with the runs that give one.
struct WithoutEffect {
  std::string path;
};
using Candidate = std::variant<Pair, NoDerivative, WithoutEffect>;

Candidate candidate_of(const ResolvedCase& in, CaseNumber number, double step) {
  const std::string path = number.path(), given = in.given(number.input.path);
  std::string why;
  for (const int side : {0, 1, -1}) {
    try {
      Pair pair{.number = number, .side = side};
      for (const double offset : offsets(side)) {
        std::optional<ResolvedCase> changed = number.changed(in, offset * step);
        if (!changed) return NoDerivative{path, given, "another input decides it"};
        pair.cases.push_back(*std::move(changed));
      }
      return pair;
    } catch (const BadInput& error) {  // no case there
      if (why.empty()) why = one_line(error);
    }
  }
  return NoDerivative{path, given, "the case allows no other value nearby: " + why};
}

// Why an input of that kind has no derivative; none where its numbers have.
std::optional<std::string> reason_of_kind(const Field& field) {
  switch (field.kind) {
    case Kind::integer:
      return "a whole number";
    case Kind::flag:
      return "on or off";
    case Kind::choice:
      return "a choice";
    case Kind::list:
      if (!field.columns.empty()) return "a table of rows, which are not one number each";
      if (field.element == Kind::quantity || field.element == Kind::number) return std::nullopt;
      return field.element == Kind::integer ? "whole numbers" : "a list of what is no number";
    default:
      return std::nullopt;
  }
}

bool is_a_name(const Input& input) {
  const Field& field = *input.field;
  return field.kind == Kind::text || input.path == "model" ||
         (field.kind == Kind::list && field.element == Kind::text);
}

void add_candidates(const ResolvedCase& in, const ScalarResult& result, const Input& input,
                    std::vector<Candidate>& all) {
  if (is_a_name(input)) return;
  if (use_status_in_row(in, input, result.analysis) != UseStatus::used) {
    all.push_back(WithoutEffect{input.path});
  } else if (const auto reason = reason_of_kind(*input.field)) {
    all.push_back(NoDerivative{input.path, in.given(input.path), *reason});
  } else {
    const double step = step_for(result.scatter);
    if (input.field->kind != Kind::list) all.push_back(candidate_of(in, {input}, step));
    for (std::size_t i = 0; input.field->kind == Kind::list && i < in.value(input.path).list.size(); ++i)
      all.push_back(candidate_of(in, {input, i}, step));
  }
}

std::vector<Candidate> candidates_of(const ResolvedCase& in, const ScalarResult& result,
                                     const std::vector<std::string>& paths) {
  std::vector<Candidate> all;
  for (const Input& input : in.inputs())
    if (in.has(input.path) &&
        (paths.empty() || std::find(paths.begin(), paths.end(), input.path) != paths.end()))
      add_candidates(in, result, input, all);
  return all;
}

void compute(std::vector<Candidate>& candidates, const ScalarResult& result,
             const DerivativeOptions& options) {
  std::vector<std::pair<Pair*, std::size_t>> runs;
  for (Candidate& candidate : candidates)
    if (Pair* pair = std::get_if<Pair>(&candidate))
      for (const std::size_t i : {0, 1}) runs.emplace_back(pair, i);
  std::mutex telling;
  std::size_t done = 0;
  if (options.progress) options.progress(done, runs.size());
  analysis::in_parallel(runs.size(), options.jobs, [&](std::size_t run) {
    auto [pair, i] = runs[run];
    std::string failure;
    try {
      pair->results[i] =
          options.remember(fmt::format("{}, {:+g} steps", pair->number.path(), offsets(pair->side)[i]),
                           [&, pair = pair, i = i] { return result.compute(pair->cases[i]).number; });
      if (!std::isfinite(pair->results[i])) failure = "there is none at another value nearby";
    } catch (const std::exception& error) {
      failure = one_line(error);
    }
    const std::scoped_lock lock(telling);
    if (!failure.empty()) pair->failure = failure;
    if (options.progress) options.progress(++done, runs.size());
  });
}

std::string status_text(const ResolvedCase& in, const std::string& path) {
  if (in.origin(path) == "default") return "default";
  return in.assumed().contains(path) ? "assumed" : "given";
}

// The effect is stated of one micrometre for lengths of micrometres, of one unit for what is zero, else of a
// hundredth.
Derivative derivative_of(const ResolvedCase& in, double result, const CaseNumber& number,
                         const Slope& slope) {
  const double value = number.value(in) / number.per_unit();
  const double per = value != 0.0 ? value : 1.0;
  Derivative one{.path = number.path(),
                 .value = value,
                 .unit = std::string(number.unit()),
                 .status = status_text(in, number.input.path),
                 .derivative = slope.value / per,
                 .error = slope.error / std::abs(per),
                 .side = slope.side};
  if (value != 0.0 && result != 0.0) one.elasticity = slope.value / result;
  const bool by_unit = value == 0.0 || one.unit == dimension::small_length.customary;
  one.step = by_unit ? fmt::format("1 {}", one.unit) : "1 %";
  one.change = one.derivative * (by_unit ? 1.0 : 0.01 * value);
  return one;
}

Candidate rated(Pair pair, const ResolvedCase& in, const ScalarResult& result, double here, Slope& slope) {
  const std::string path = pair.number.path(), given = in.given(pair.number.input.path);
  if (!pair.failure.empty()) return NoDerivative{path, given, pair.failure};
  slope = slope_of(here, pair.results, pair.side, result.scatter);
  const double size = here != 0.0 ? std::abs(here) : 1.0;
  if (result.is_at_rest() && slope.error > kKink * std::max(size, std::abs(slope.value)))
    return NoDerivative{path, given, "the result has a kink here: its slopes to both sides differ"};
  if (result.is_at_rest() && std::abs(slope.value) < kNothing * size) return WithoutEffect{path};
  return pair;
}

}  // namespace

double step_for(double scatter) {
  return 0.5 * std::cbrt(3.0 * scatter);
}

Slope slope_of(double here, const std::array<double, 2>& there, int side, double scatter) {
  const bool by_logarithm = std::min({here, there[0], there[1]}) > 0.0;
  const double size = by_logarithm ? here : 1.0, step = step_for(scatter);
  const auto change = [&](double result) { return by_logarithm ? std::log(result / here) : result - here; };
  const double first = change(there[0]), second = change(there[1]);
  const double bend = side == 0 ? first + second : second - 2.0 * first;
  const double slope = side == 0 ? 0.5 * (second - first) : side * (2.0 * first - 0.5 * second);
  const double least = std::sqrt(6.0) * scatter * (by_logarithm ? 1.0 : std::abs(here));
  return {size * slope / step, size * std::max(std::abs(bend), least) / (2.0 * step), side};
}

Derivatives derivatives(const ResolvedCase& resolved, const ScalarResult& result,
                        const ScalarResult::Value& here, const DerivativeOptions& options) {
  const ResolvedCase in = resolved.without_sweep();
  Derivatives found{.quantity = here.key, .unit = result.unit, .value = here.number, .of_set = here.of_set};
  std::vector<Candidate> candidates = candidates_of(in, result, options.paths);
  compute(candidates, result, options);
  for (Candidate& candidate : candidates) {
    Slope slope;
    if (auto* pair = std::get_if<Pair>(&candidate))
      candidate = rated(std::move(*pair), in, result, found.value, slope);
    if (const auto* pair = std::get_if<Pair>(&candidate))
      found.inputs.push_back(derivative_of(in, found.value, pair->number, slope));
    else if (auto* none = std::get_if<NoDerivative>(&candidate))
      found.not_differentiable.push_back(std::move(*none));
    else
      found.without_effect.push_back(std::get<WithoutEffect>(candidate).path);
  }
  const auto weight = [&](const Derivative& one) {
    constexpr double hundred = 100.0;
    return std::abs(one.elasticity.value_or(hundred * one.change / found.value));
  };
  std::stable_sort(found.inputs.begin(), found.inputs.end(),
                   [&](const Derivative& a, const Derivative& b) { return weight(a) > weight(b); });
  return found;
}

namespace {

std::string side_text(int side) {
  if (side == 0) return "";
  return side > 0 ? "to larger values alone" : "to smaller values alone";
}

// Dimension of a life; other results have their unit in their key.
described::Dimension dimension_of(const Derivatives& d) {
  if (d.unit == "h") return described::dimension::hours;
  return d.unit == "Mrev" ? described::Dimension{"revolutions", "1e6", "Mrev", ""} : described::Dimension{};
}

}  // namespace

void describe(described::Record& row, const Derivative& one) {
  row.value("path", "of the input", one.path);
  row.value("value", {}, "of the input, in its unit", one.value);
  row.value("unit", "customary, of the input", one.unit);
  row.value("standing", "given, assumed or default", one.status);
  row.value("derivative", {}, "of the result, per unit of the input", one.derivative);
  row.value("error", {}, "estimated, of the derivative", one.error);
  row.value("elasticity", {}, "d ln(result)/d ln(input)", one.elasticity);
  row.value("step", "a change whose effect is stated", one.step);
  row.value("change", {}, "of the result by that step", one.change);
  if (one.side != 0) row.value("remark", "where the slope is that of one side", side_text(one.side));
}

void describe(described::Record& row, const NoDerivative& one) {
  row.value("path", "of the input", one.path);
  row.value("given", "value", one.given);
  row.value("reason", "why there is no derivative", one.reason);
}

void describe(described::Record& record, const Derivatives& d) {
  record.value("quantity", "key of the result", d.quantity);
  described::Entry& result = record.value(d.quantity, dimension_of(d), "the result itself", d.value);
  result.variable = d.quantity;
  std::ranges::replace(*result.variable, '/', '_');
  record.value("unit", "of the result; that of another one than a life is in its key", d.unit);
  if (!d.of_set.empty()) record.value("of_set", "the one with the worst bearing", d.of_set);
  record.table("inputs", "input", "derivatives by inputs, the largest elasticity first", d.inputs).variable =
      "";
  record.table("not_differentiable", "other_input", "inputs without a derivative", d.not_differentiable);
  record.value("without_effect", "inputs on which the result does not depend", d.without_effect);
}

std::string derivatives_csv(const Derivatives& d) {
  const std::string unit = d.unit.empty() ? "" : "_" + d.unit;
  std::string text = fmt::format(
      "input,value,unit,standing,derivative{0}_per_unit,error{0}_per_unit,elasticity,step,change{0},remark\n",
      unit);
  for (const Derivative& one : d.inputs)
    text += fmt::format("{},{:.12g},{},{},{:.12g},{:.3g},{},{},{:.12g},{}\n", one.path, one.value, one.unit,
                        one.status, one.derivative, one.error,
                        one.elasticity ? fmt::format("{:.12g}", *one.elasticity) : "", one.step, one.change,
                        side_text(one.side));
  for (const NoDerivative& one : d.not_differentiable)
    text += fmt::format("{},{},,,,,,,,{}\n", one.path, csv_field(one.given), csv_field(one.reason));
  for (const std::string& path : d.without_effect) text += fmt::format("{},,,,0,,,,0,without effect\n", path);
  return text;
}

}  // namespace orbearing::app
