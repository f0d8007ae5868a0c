#include "app/study/sensitivity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "app/case/drivetrain_reader.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/machines.hpp"
#include "app/case/static_case.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/errors.hpp"
#include "app/results/record_writers.hpp"
#include "app/results/sweep_row.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/planetary_case.hpp"
#include "app/units.hpp"
#include "bearing/life/rating_record.hpp"

namespace orbearing::app {

namespace dimension = described::dimension;

namespace {

double speed_of_smallest(const LifeCurve& curve, const std::vector<double>& values) {
  return curve.speed_rpm[static_cast<std::size_t>(std::ranges::min_element(values) - values.begin())];
}

bool rises_then_falls(const LifeCurve& curve) {
  const auto peak = std::max_element(curve.life_h.begin(), curve.life_h.end());
  const bool inside = peak != curve.life_h.begin() && peak != curve.life_h.end() - 1;
  const bool one_peak = std::is_sorted(curve.life_h.begin(), peak) &&
                        std::is_sorted(peak, curve.life_h.end(), std::greater<>());
  return inside && one_peak;
}

std::string life_cell(double life) {
  return std::isnan(life) ? "failed" : fmt::format("{:.0f}", life);
}

// Difference at the best speed of the unchanged case [h]; NaN where either failed.
double gain_at_best(const ChangeResult& reference, const ChangeResult& result) {
  const std::size_t at = best_point(reference);
  return life_of(result.points[at]) - life_of(reference.points[at]);
}

constexpr double kWorthKnowing = 0.1;  // [-]  of a life
constexpr double kMore = 0.1;          // [-]  of a default
constexpr std::size_t kMostWarnings = 3;

/// With parts that take seconds replaced by those that take none. Empty where the case requires these parts:
/// two gears on each planet require computed tilts.
std::optional<ResolvedCase> simplified(const ResolvedCase& in) {
  std::vector<Setting> settings;
  for (const Input& input : in.inputs()) {
    if (!in.has(input.path)) continue;
    if (input.field->path == keys().rim && in.choice(input.path) == "elastic")
      settings.push_back({input.path, "rigid"});
    if (input.field->path == keys().tilt && in.choice(input.path) == "computed")
      settings.push_back({input.path, "stated"});
  }
  const ResolvedCase one = in.without_sweep();
  if (settings.empty()) return one;
  try {
    return one.with(settings);
  } catch (const BadInput&) {
    return std::nullopt;
  }
}

/// NaN where there is none.
double life_at_rest(const ScalarResult& life, const ResolvedCase& in) {
  try {
    return life.compute(in).number;
  } catch (const std::exception&) {  // check reports it elsewhere, or the values form no case
    return std::numeric_limits<double>::quiet_NaN();
  }
}

// K_A is 1 by the meaning of the power and L10 is that of 90 %: neither is an estimate.
bool is_estimate(const ResolvedCase& in, const Input& input, const ScalarResult& life) {
  return in.has(input.path) && in.origin(input.path) == "default" && is_numeric(*input.field) &&
         input.field->kind != Kind::integer && in.value(input.path).number != 0.0 &&
         input.path != keys().application_factor && input.path != keys().reliability &&
         use_status_in_row(in, input, life.analysis) == UseStatus::used;
}

/// Effect on the life of a 10 % larger number; NaN where another input determines it or there is no such
/// case.
double effect_of_more(const ResolvedCase& in, const std::string& path, const ScalarResult& life,
                      double here) {
  const double more = (1.0 + kMore) * in.value(path).number;
  constexpr double round_off = 1e-9;
  try {
    const ResolvedCase other = in.with(path, more);
    if (std::abs(other.value(path).number / more - 1.0) > round_off)
      return std::numeric_limits<double>::quiet_NaN();
    return life_at_rest(life, other) / here - 1.0;
  } catch (const BadInput&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

// "the default, 0.83", or whose it is: "12 kN of ACME K 20x26x17 (own drawing)".
std::string default_text(const ResolvedCase& in, const std::string& path) {
  const Field& field = *find_field(path);
  const auto reason = in.assumed().find(path);
  const std::string own = "default: ";
  if (reason == in.assumed().end() || reason->second == own + field.default_reason ||
      !reason->second.starts_with(own))
    return "the default, " + in.given(path);
  const std::string whose = reason->second.substr(own.size());
  if (is_one_of(field.path, {keys().dynamic_capacity, keys().static_capacity, keys().fatigue_load_limit}))
    return fmt::format("{} of {}", in.given(path), whose);
  return fmt::format("the default, {} ({})", in.given(path), whose);
}

void warn_of_defaults(const ResolvedCase& in, const ScalarResult& life, std::vector<std::string>& warnings) {
  const double here = life_at_rest(life, in);
  std::vector<std::pair<double, std::string>> effects;
  if (std::isfinite(here) && here > 0.0)
    for (const Input& input : in.inputs())
      if (is_estimate(in, input, life))
        if (const double effect = effect_of_more(in, input.path, life, here);
            std::abs(effect) >= kWorthKnowing)
          effects.emplace_back(effect, input.path);
  std::ranges::stable_sort(effects, std::ranges::greater{},
                           [](const auto& one) { return std::abs(one.first); });
  if (effects.size() > kMostWarnings) effects.resize(kMostWarnings);
  for (const auto& [effect, path] : effects)
    warnings.push_back(fmt::format("{}: not stated; with {:g} % more than {}, {} changes by {:+.0f} %", path,
                                   100.0 * kMore, default_text(in, path), life.quantity, 100.0 * effect));
}

void warn_of_load_sharing(const ResolvedCase& in, const std::vector<Derived>& derived,
                          std::vector<std::string>& warnings) {
  const std::string pins = "gearset.dynamics.pin_error.";
  if (in.has(pins + "radial") || in.has(pins + "tangential")) return;
  const auto value = [&](std::string_view path) {
    const auto row = std::ranges::find(derived, path, &Derived::path);
    return row == derived.end() ? std::numeric_limits<double>::quiet_NaN() : row->value;
  };
  const double share = value("one_pin_off.load_share"), shortest = value("one_pin_off.shortest_life");
  if (!std::isfinite(shortest)) return;
  const ScalarResult life = scalar_result(in);
  const double even = life_at_rest(life, in);
  if (!(shortest < (1.0 - kWorthKnowing) * even)) return;
  warnings.push_back(fmt::format(
      "gearset.dynamics.pin_error: not stated; planets share the load evenly. One pin off by its tolerance, "
      "js7 of "
      "ISO 286-1, gives K_gamma {:.3g} and a shortest {} of {:.5g} h, {:+.0f} % against {:.5g} h",
      share, life.quantity, shortest, 100.0 * (shortest / even - 1.0), even));
}

constexpr double kMovesALife = 0.01;  // [-]

using Lives = std::vector<std::pair<std::string, double>>;  // names, hours or revolutions

// Lives of one bearing, quasi-static; of several sets those of the governing one; none where there is no such
// result.
Lives lives_at_rest(const ResolvedCase& in) {
  try {
    if (in.model() == planetary_drivetrain) {
      std::vector<analysis::NamedSet> sets = bearing_sets(in);
      for (analysis::NamedSet& set : sets) set.drivetrain.carrier_mounting.reset();
      const analysis::PointResult point = analysis::evaluate(sets);
      Lives lives;
      for (const bearing::rating::RatedLife& life : bearing::rating::kRatedLives)
        lives.emplace_back(life.name, point.rating.hours.*life.hours);
      lives.emplace_back("life_h", point.life_hours);
      return lives;
    }
    if (!is_static_bearing(in)) return {};
    const analysis::LifeValue value = bearing_under_load(in).life_table().value;
    const bool timed = std::isfinite(value("life_h"));
    Lives lives;
    for (const char* name : {"L10", "L10r", "L10m", "L10mr", "life"}) {
      const std::string unit = timed ? (name == std::string("life") ? "_h" : "h") : "_Mrev";
      lives.emplace_back(name + unit, value(name + unit));
    }
    return lives;
  } catch (const BadInput&) {
  } catch (const std::runtime_error&) {  // its run reports it
  } catch (const std::logic_error&) {
  }
  return {};
}

struct Effect {
  std::string text;
  double largest = 0.0;  // [-]  size of the largest change of a life
};

// Empty where no life changes.
Effect effect_on(const Lives& here, const Lives& there) {
  Effect effect;
  for (std::size_t i = 0; i < here.size() && i < there.size(); ++i) {
    const double change = there[i].second / here[i].second - 1.0;
    if (!std::isfinite(change) || std::abs(change) < kMovesALife) continue;
    effect.text +=
        fmt::format("{}{} {:+.0f} %", effect.text.empty() ? "" : ", ", here[i].first, 100.0 * change);
    effect.largest = std::max(effect.largest, std::abs(change));
  }
  return effect;
}

// Other values of an assumed input, as a case writes them; each with what it requires besides.
std::vector<std::vector<Setting>> alternatives(const ResolvedCase& in, const Input& input) {
  const Field& field = *input.field;
  std::vector<std::vector<Setting>> others;
  if (field.kind == Kind::choice)
    for (const std::string& other : field.choices)
      if (other != in.choice(input.path)) others.push_back({{input.path, other}});
  if (field.path == keys().tilt)
    for (std::vector<Setting>& other : others) {
      const std::string laminae =
          input.path.substr(0, input.path.size() - field.path.size()) + keys().laminae;
      if (!in.has(laminae)) other.push_back({laminae, std::to_string(analysis::default_laminae)});
    }
  if (field.kind == Kind::flag) others.push_back({{input.path, in.flag(input.path) ? "false" : "true"}});
  if ((field.kind == Kind::quantity || field.kind == Kind::number) && in.value(input.path).number != 0.0)
    others.push_back({{input.path, "", (1.0 + kMore) * in.value(input.path).number}});
  return others;
}

// Inputs that are left out are no estimates: the meaning of the power and of L10, the governing life,
// catalogue ratings, and effects that take seconds or are another machine.
bool is_assumption(const ResolvedCase& in, const Input& input, AnalysisId analysis) {
  return in.has(input.path) && in.origin(input.path) == "default" &&
         !is_one_of(input.field->path,
                    {keys().reliability, keys().life_method, keys().rim, keys().fixed_member,
                     keys().complement, keys().clearance_state, keys().oil_grade, keys().dynamic_capacity,
                     keys().static_capacity, keys().fatigue_load_limit}) &&
         !input.field->path.starts_with("input.") &&
         use_status_in_row(in, input, analysis) == UseStatus::used;
}

}  // namespace

std::vector<AssumedEffect> assumed_effects(const ResolvedCase& resolved) {
  const std::optional<ResolvedCase> simple = simplified(resolved);
  if (!simple || !unequal_loads_by(*simple).empty()) return {};  // each change would take seconds
  const ResolvedCase& in = *simple;
  const Lives here = lives_at_rest(in);
  std::vector<std::pair<double, AssumedEffect>> found;
  if (here.empty()) return {};
  const AnalysisId analysis = in.model() == planetary_drivetrain ? AnalysisId::quasi_static
                                                                 : machine_analysis(in.model(), "run")->used;
  for (const Input& input : in.inputs()) {
    if (!is_assumption(in, input, analysis)) continue;
    std::string text;
    double largest = 0.0;
    for (const std::vector<Setting>& other : alternatives(in, input)) try {
        const ResolvedCase changed = in.with(other);
        if (changed.given(input.path) == in.given(input.path)) continue;  // another input decides it
        const Effect effect = effect_on(here, lives_at_rest(changed));
        if (effect.text.empty()) continue;
        text += fmt::format("{}{}: {}", text.empty() ? "" : "; ",
                            other.front().number ? "10 % more" : changed.given(input.path), effect.text);
        largest = std::max(largest, effect.largest);
      } catch (const BadInput&) {  // no such case
      }
    if (!text.empty()) found.push_back({largest, {input.path, std::move(text)}});
  }
  std::ranges::stable_sort(found, std::ranges::greater{}, [](const auto& one) { return one.first; });
  std::vector<AssumedEffect> effects;
  for (auto& [size, effect] : found) effects.push_back(std::move(effect));
  return effects;
}

std::string assumed_effects_text(const ResolvedCase& resolved, const std::vector<AssumedEffect>& effects) {
  if (effects.empty()) return "";
  std::string text = "assumed inputs that change the lives, and their effect:\n";
  for (const auto& [path, effect] : effects)
    text += fmt::format("  {} {}; {}\n", path, resolved.given(path), effect);
  return text + "\n";
}

std::vector<std::string> default_warnings(const ResolvedCase& resolved, const std::vector<Derived>& derived) {
  std::vector<std::string> warnings;
  try {
    const std::optional<ResolvedCase> in = simplified(resolved);
    if (!in) return {};
    const ScalarResult life = scalar_result(*in);
    if (!life.is_at_rest()) return {};
    warn_of_load_sharing(*in, derived, warnings);
    warn_of_defaults(*in, life, warnings);
  } catch (const BadInput&) {  // a case without a life
  }
  return warnings;
}

LifeCurve life_curve(const ChangeResult& result) {
  LifeCurve curve;
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    const analysis::PointResult& point = result.points[i];
    if (!is_computed(point.status)) continue;  // the sweep reports the reason
    curve.speed_rpm.push_back(in_table_unit(result.speed[i], 1.0 / kRadiansPerSecond));
    curve.life_h.push_back(analysis::governing_hours(point));
    curve.roller_load_rms.push_back(point.outer.load_rms);
  }
  if (curve.speed_rpm.empty()) throw ComputationFailed("no point of the sweep has a life");
  return curve;
}

LifeCurve life_curve(const ResolvedCase& resolved) {
  return life_curve(results_of(resolved, with_reference({}), {}).front());
}

void describe(described::Record& record, const LifeCurve& curve) {
  const auto speed = [&](const char* name, const char* meaning, double rpm) {
    record.value(name, in_rpm, meaning, rpm);
  };
  const auto longest = std::ranges::max_element(curve.life_h);
  speed("peak_speed_rpm", "of the longest life on the grid",
        curve.speed_rpm[static_cast<std::size_t>(longest - curve.life_h.begin())]);
  record.value("peak_life_h", dimension::hours, "longest on the grid", *longest);
  speed("least_load_speed_rpm", "of the least roller loads", speed_of_smallest(curve, curve.roller_load_rms));
  speed("shortest_life_speed_rpm", "of the shortest life", speed_of_smallest(curve, curve.life_h));
  record.value("life_rises_then_falls", "whether life has one maximum over speed", rises_then_falls(curve));
}

double property(const LifeCurve& curve, const std::string& quantity) {
  return number_in(record_of(curve), quantity);
}

std::vector<Sensitivity> sensitivities(const std::vector<ChangeResult>& results) {
  const double stated = property(life_curve(results.front()), "peak_life_h");
  std::vector<Sensitivity> all;
  for (std::size_t i = 1; i < results.size(); ++i) {
    Sensitivity one{.change = results[i].change, .curve = life_curve(results[i])};
    one.peak_speed_rpm = property(one.curve, "peak_speed_rpm");
    one.peak_life_h = property(one.curve, "peak_life_h");
    one.difference_h = one.peak_life_h - stated;
    all.push_back(std::move(one));
  }
  return all;
}

void put_derivatives(const ResolvedCase& resolved, double peak_rpm, int jobs, std::vector<Sensitivity>& all) {
  DerivativeOptions options{.jobs = jobs};
  for (const Sensitivity& one : all) options.paths.push_back(one.change.group);
  if (options.paths.empty()) return;
  const ResolvedCase at_peak = resolved.without_sweep().with({input_speed(peak_rpm)});
  const ScalarResult life = scalar_result(at_peak);
  const Derivatives found = derivatives(at_peak, life, value_here(at_peak, life), options);
  for (Sensitivity& one : all)
    for (const Derivative& derivative : found.inputs)
      if (derivative.path == one.change.group) one.derivative = derivative;
}

ChangeStudy study_of(const ResolvedCase& resolved, const MotionPlan& plan, int jobs) {
  ChangeStudy study{.fidelity = fidelity_of(plan.fidelity), .jobs = jobs};
  for (const double rpm : plan.speed_rpm)
    study.speed.push_back(resolved.with({input_speed(rpm)}).quantity(keys().speed));
  return study;
}

std::string motion_heading(const std::string& case_name, const MotionPlan& plan) {
  std::string text =
      fmt::format("{}: what assumptions are worth in motion ({}), life of one bearing [h]\n{:<46}", case_name,
                  plan.fidelity, "assumption");
  for (const double rpm : plan.speed_rpm) text += fmt::format("{:>10}", fmt::format("{:.0f} rpm", rpm));
  return text + fmt::format("{:>12}{:>12}  {}\n", "best [rpm]", "worth [h]", "reading");
}

std::string motion_line(const MotionPlan& plan, const ChangeResult& reference, const ChangeResult& result) {
  std::string text = fmt::format("{:<46}", result.change.group);
  for (const analysis::PointResult& point : result.points)
    text += fmt::format("{:>10}", life_cell(life_of(point)));
  const double difference = gain_at_best(reference, result);
  return text + fmt::format("{:>12.0f}{:>12}  {}\n", plan.speed_rpm[best_point(result)],
                            std::isnan(difference) ? "-" : fmt::format("{:+.0f}", difference),
                            result.change.name);
}

void describe_reading(described::Record& row, const std::string& case_name, const MotionPlan& plan,
                      const ChangeResult& reference, const ChangeResult& result) {
  row.value("case", "name", case_name);
  row.value("fidelity", "of the motion", plan.fidelity);
  row.value("assumption", "key of the case", result.change.group);
  row.value("reading", "other interpretation", result.change.name);
  row.value("settings", "of the case", result.change.settings);
  std::vector<std::pair<double, const analysis::PointResult*>> points;
  for (std::size_t i = 0; i < result.points.size(); ++i)
    points.emplace_back(plan.speed_rpm[i], &result.points[i]);
  row.table("points", "point", "lives over speed", points, [](described::Record& point, const auto& one) {
    point.value("speed_rpm", in_rpm, "of the driving member", one.first);
    point.value("life_h", dimension::hours, "of one bearing", life_of(*one.second));
    point.value("status", "ok, or why the point failed", one.second->status);
  });
  row.value("best_speed_rpm", in_rpm, "of the longest life", plan.speed_rpm[best_point(result)]);
  row.value("life_change_h", dimension::hours, "change of life at the best speed of the unchanged case",
            gain_at_best(reference, result))
      .former = "worth_h";
}

}  // namespace orbearing::app
