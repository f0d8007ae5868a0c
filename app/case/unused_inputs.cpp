#include "app/case/unused_inputs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "app/case/bearing_type.hpp"
#include "app/case/catalogue_warnings.hpp"
#include "app/case/drivetrain_analyses.hpp"
#include "app/case/field_table.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/machine_rows.hpp"
#include "app/case/settings.hpp"
#include "app/case/use_conditions.hpp"
#include "app/errors.hpp"
#include "coupling/analysis/stated_drivetrain.hpp"
#include "mechanics/member_keys.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

const Use& use_of(const ResolvedCase& in, const Input& input) {
  return input.field->use_in(in.model());
}

bool all_zero(const FieldValue& value) {
  return value.number == 0.0 && value.texts.empty() &&
         std::all_of(value.list.begin(), value.list.end(), [](double one) { return one == 0.0; });
}

bool has_magnitude(const Field& field) {
  return field.kind == Kind::quantity || field.kind == Kind::number || field.kind == Kind::integer ||
         field.kind == Kind::list;
}

// The default, or zero where the field may be left out: such a statement has no effect.
bool is_neutral(const ResolvedCase& in, const Input& input) {
  const Field& field = *input.field;
  if (in.origin(input.path) == "default") return true;
  const FieldValue& value = in.value(input.path);
  if (!field.default_text.empty() && !field.default_without_bearing) {
    const FieldValue default_value = read_field_text(field, field.default_text).value;
    return field.kind == Kind::choice
               ? value.given == default_value.given
               : value.number == default_value.number && value.list == default_value.list;
  }
  return has_magnitude(field) && all_zero(value);
}

// A condition speaks of the same set as the field it is for.
std::string beside(const std::string& path, const std::string& other) {
  const Field* field = find_field(other);
  return (field != nullptr && in_each_set(*field) ? set_of(path) : "") + other;
}

bool counts(const ResolvedCase& in, const std::string& path, const std::vector<std::string>& values) {
  if (!in.has(path)) return false;
  if (!values.empty()) return std::find(values.begin(), values.end(), in.given(path)) != values.end();
  const Field& field = *find_field(path);
  return !(has_magnitude(field) && all_zero(in.value(path)));
}

// Whether the condition depends only on inputs of other models: such a condition is met here.
bool is_of_other_models(const ResolvedCase& in, const Condition& condition) {
  return std::none_of(condition.paths.begin(), condition.paths.end(),
                      [&](const std::string& path) { return (find_field(path)->models & in.model()) != 0; });
}

// Conditions of the row are those of its ways too.
bool is_of_row(const ResolvedCase& in, const Input& input, const Condition& condition) {
  const std::vector<Condition>& row = use_of(in, input).conditions;
  return std::any_of(row.begin(), row.end(), [&](const Condition& one) {
    return one.paths == condition.paths && one.values == condition.values;
  });
}

bool holds(const ResolvedCase& in, const Input& input, const Condition& condition) {
  if (condition.holds != nullptr) return condition.holds(in, set_of(input.path));
  if (is_of_other_models(in, condition)) return true;
  const auto one = [&](const std::string& path) {
    const std::string other = beside(input.path, path);
    return condition.absent ? is_stated(in, other) : counts(in, other, condition.values);
  };
  return std::any_of(condition.paths.begin(), condition.paths.end(), one) != condition.absent;
}

const Condition* first_unmet(const ResolvedCase& in, const Input& input) {
  for (const Condition& condition : use_of(in, input).conditions)
    if (!holds(in, input, condition)) return &condition;
  return nullptr;
}

const Way* way_that_holds(const ResolvedCase& in, const Input& input, AnalysisSet analyses);

// Whether some analysis uses the value: that of its row, or one of its other ways.
bool counts_itself(const ResolvedCase& in, const Input& input) {
  return first_unmet(in, input) == nullptr || way_that_holds(in, input, AnalysisSet::all()) != nullptr;
}

// The condition holds with another value that has an effect itself.
bool holds_beside(const ResolvedCase& in, const Input& input, const Condition& condition) {
  if (condition.absent || condition.holds != nullptr) return holds(in, input, condition);
  if (is_of_other_models(in, condition) && is_of_row(in, input, condition)) return true;
  return std::any_of(condition.paths.begin(), condition.paths.end(), [&](const std::string& path) {
    const std::string other = beside(input.path, path);
    if (!counts(in, other, condition.values)) return false;
    return other == input.path || counts_itself(in, {other, find_field(other)});
  });
}

const Way* way_that_holds(const ResolvedCase& in, const Input& input, AnalysisSet analyses) {
  for (const Way& way : use_of(in, input).ways)
    if (way.by.has_some_of(analyses) &&
        std::all_of(way.conditions.begin(), way.conditions.end(),
                    [&](const Condition& condition) { return holds_beside(in, input, condition); }))
      return &way;
  return nullptr;
}

// Parameters that act through another quantity where a choice makes it follow from them: by all that
// uses the parameter `by`.
struct Through {
  std::vector<std::string> paths;
  std::string choice;  // which makes it follow, by this value, and by whose uses it counts
  std::string_view value;
  bool (*also)(const ResolvedCase&, std::string_view set) = nullptr;  // holds as well
  bool meshes = false;                                                // and what makes them

  bool holds(std::string_view path) const {
    return std::find(paths.begin(), paths.end(), path) != paths.end() || (meshes && makes_meshes(path));
  }
};

std::vector<Through> found_through_others() {
  const analysis::StatedSet set;
  const mechanics::MemberKeys key(set);
  const bearing::Bearing& bearing = set.planets.bearing;
  const std::vector<std::string> seats =
      key.of(bearing.inner.seat_diameter, set.planets.mounting.rings, bearing.material.youngs_modulus,
             bearing.material.poisson_ratio);
  const std::string &clearance = key(set.planets.mounting.state), &tilt = key(set.planets.seats.tilt);
  return {{seats, clearance, "unmounted"},  // seats and what they are of make the clearance
                                            // The pin bends under bearings side by side; it and the meshes
                                            // hold a planet that tilts.
          {seats, tilt, "computed", bearings_tilt},
          {key.of(set.gears.choice.bodies), tilt, "computed", planets_tilt, true}};
}
const std::vector<Through>& through_others() {
  static const std::vector<Through> all = found_through_others();
  return all;
}

bool is_chosen(const ResolvedCase& in, const Input& input, const Through& through) {
  const std::vector<Input> inputs = in.inputs();
  const std::string set = set_of(input.path);  // none: of the material, which is that of all sets
  return std::any_of(inputs.begin(), inputs.end(), [&](const Input& other) {
    return other.field->path == through.choice && in.has(other.path) &&
           in.choice(other.path) == through.value && other.path.starts_with(set);
  });
}

bool is_used_through_another(const ResolvedCase& in, const Input& input, AnalysisId analysis) {
  return std::ranges::any_of(through_others(), [&](const Through& through) {
    if (!through.holds(input.field->path) || !is_chosen(in, input, through)) return false;
    const Input by{beside(input.path, through.choice), find_field(through.choice)};
    return (use_of(in, by).by.has(analysis) || way_that_holds(in, by, analysis) != nullptr) &&
           (through.also == nullptr || through.also(in, set_of(input.path)));
  });
}

// The values of a condition that the field may have. No condition asks for a switch that is off.
std::vector<std::string> values_for(const Field& field, const Condition& condition) {
  std::vector<std::string> values = condition.values;
  if (field.kind == Kind::flag)
    std::erase_if(values, [](const std::string& value) { return value != "true"; });
  if (field.kind == Kind::choice)
    std::erase_if(values, [&](const std::string& value) {
      return std::find(field.choices.begin(), field.choices.end(), value) == field.choices.end();
    });
  return values;
}

std::string condition_text(const ResolvedCase& in, const Input& input, const Condition& condition) {
  if (!condition.text.empty()) return condition.text;
  std::vector<std::string> paths;
  for (const std::string& path : condition.paths)
    if ((find_field(path)->models & in.model()) != 0) paths.push_back(beside(input.path, path));
  if (condition.absent) return fmt::format("where {} is not given", fmt::join(paths, " or "));
  if (condition.values.empty()) return fmt::format("together with {}", fmt::join(paths, " or "));
  std::vector<std::string> required;
  for (const std::string& path : paths)
    required.push_back(fmt::format("{} is {}, and here it is {}", path,
                                   fmt::join(values_for(*find_field(path), condition), " or "),
                                   in.has(path) ? in.given(path) : "not given"));
  return fmt::format("where {}", fmt::join(required, ", or where "));
}

// Conditions that keep a value from having an effect, and others under which it would have one, by ways that
// this kind of case has; empty where there are none.
std::string idle_text(const ResolvedCase& in, const Input& input, AnalysisSet analyses) {
  std::vector<std::string> texts;
  if (const Condition* unmet = first_unmet(in, input)) texts.push_back(condition_text(in, input, *unmet));
  for (const Way& way : use_of(in, input).ways) {
    const bool known = std::none_of(way.conditions.begin(), way.conditions.end(), [&](const Condition& one) {
      return one.holds == nullptr && is_of_other_models(in, one) && !is_of_row(in, input, one);
    });
    if (!way.by.has_some_of(analyses) || !known) continue;
    std::vector<std::string> unmet;
    for (const Condition& condition : way.conditions)
      if (!holds_beside(in, input, condition)) unmet.push_back(condition_text(in, input, condition));
    if (unmet.empty()) continue;  // another condition prevents it
    const std::string text = fmt::format("{}", fmt::join(unmet, " and "));
    const bool same = !texts.empty() && std::find(unmet.begin(), unmet.end(), texts.front()) != unmet.end();
    if (!same && std::find(texts.begin(), texts.end(), text) == texts.end()) texts.push_back(text);
  }
  return texts.empty() ? "" : fmt::format("it counts only {}", fmt::join(texts, ", or "));
}

// Whether the analysis moves the bearings of another set: it moves those of the set with the scratched
// bearing.
bool moves_another(const ResolvedCase& in, const std::string& set, AnalysisId analysis) {
  return analysis == AnalysisId::planet_defect && in.has(kScratchedSet) &&
         set != set_prefix(in.text(kScratchedSet));
}

// A set without a bearing passes on torque and speed: the ratios of its teeth alone affect the other sets. So
// does one beside a set with a scratched bearing.
bool is_behind_ratios(const ResolvedCase& in, const Input& input, AnalysisId analysis) {
  const std::string set = set_of(input.path);
  if (set.empty() || (has_planet_bearing(in, set) && !moves_another(in, set, analysis))) return false;
  return !input.field->path.starts_with("gearset.teeth.");
}

bool takes(const TakenDrivetrains& one, const CaseShape& shape) {
  if (shape.several) return one.several_sets;
  if (shape.bearing) return one.single_set;
  return shape.teeth ? one.without_bearing : one.without_teeth;
}

AnalysisSet drivetrain_analyses_that_fit(const ResolvedCase& in) {
  AnalysisSet fit;
  for (const AnalysisId analysis : drivetrain_analyses())
    if (takes(drivetrain_analysis(analysis).takes, in.shape())) fit |= analysis;
  if (!in.shape().defect) fit = fit.without(AnalysisId::planet_defect);
  return in.has(keys().carrier_bearings) ? fit : fit.without(AnalysisId::carrier);
}

// Those that a case of this kind may have.
AnalysisSet analyses_that_fit(const ResolvedCase& in) {
  AnalysisSet fit;
  MachineAnalyses::each([&]<class Row>(Row, std::size_t number) {
    if (Row::model == in.model()) fit |= id_of_machine_analysis(number);
  });
  return in.model() == planetary_drivetrain ? drivetrain_analyses_that_fit(in) : fit;
}

std::string users_text(const ResolvedCase& in, const Input& input) {
  std::vector<std::string> names;
  for (const AnalysisId analysis : analyses_of(in))
    if (is_used(in, input, analysis)) names.push_back(analysis_name(analysis));
  if (!names.empty()) return fmt::format("used by {}", fmt::join(names, ", "));
  const std::string idle = idle_text(in, input, analyses_that_fit(in));
  return idle.empty() ? "nothing in a case of this kind uses it" : idle;
}

std::string warning_of(const ResolvedCase& in, const Input& input, AnalysisId analysis, UseStatus status) {
  const std::string found = fmt::format("{}: {}", input.path, in.written(input.path));
  if (status == UseStatus::idle)
    return fmt::format("{} has no effect: {}", found, idle_text(in, input, analysis));
  return fmt::format("{} has no effect on {}; {}", found, analysis_name(analysis), users_text(in, input));
}

bool goes_through(Axes sweeps, const SweepAxis& axis) {
  return sweeps == Axes::all || (sweeps == Axes::speed && axis.path == keys().speed);
}

// Then the condition may hold at some of the points.
bool is_varied(const Condition& condition, const std::string& path, const std::vector<std::string>& varied) {
  return std::ranges::any_of(condition.paths, [&](const std::string& other) {
    return std::ranges::find(varied, beside(path, other)) != varied.end();
  });
}

// Whether the analysis uses the value at some of the points at least.
bool may_be_used(const ResolvedCase& in, const Input& input, AnalysisId analysis,
                 const std::vector<std::string>& varied) {
  if (is_used(in, input, analysis)) return true;
  if (is_behind_ratios(in, input, analysis) || is_unknown_type(in, input, analysis)) return false;
  const auto may_hold = [&](const Condition& condition, bool holds_here) {
    return holds_here || is_varied(condition, input.path, varied);
  };
  const Use& use = use_of(in, input);
  if (use_status_in_row(in, input, analysis) == UseStatus::used &&
      std::ranges::all_of(use.conditions,
                          [&](const Condition& one) { return may_hold(one, holds(in, input, one)); }))
    return true;
  return std::ranges::any_of(use.ways, [&](const Way& way) {
    return way.by.has(analysis) && std::ranges::all_of(way.conditions, [&](const Condition& one) {
             return may_hold(one, holds_beside(in, input, one));
           });
  });
}

std::vector<std::string> swept_paths(const ResolvedCase& in) {
  std::vector<std::string> paths;
  for (const SweepAxis& axis : in.axes()) paths.push_back(axis.path);
  return paths;
}

// Mistake or warning on an axis: one that the analysis sweeps, or one that an option gives to an analysis
// without sweep.
void check_axis(const ResolvedCase& in, const SweepAxis& axis, AnalysisId analysis, Axes sweeps,
                std::vector<Mistake>& mistakes, std::vector<std::string>& warnings) {
  const std::string path = "sweep." + axis.path;
  const Input input{axis.path, find_field(axis.path)};
  if (goes_through(sweeps, axis) && use_status_in_row(in, input, analysis) == UseStatus::used) {
    if (!may_be_used(in, input, analysis, swept_paths(in)))
      mistakes.push_back({axis.location,
                          path,
                          {"a sweep of an input that has no effect: " + idle_text(in, input, analysis),
                           "a case without this axis is required"}});
  } else if (sweeps != Axes::none) {
    mistakes.push_back(
        {axis.location,
         path,
         {"a sweep of an input that " + analysis_name(analysis) + " does not vary",
          sweeps == Axes::speed ? "one value of it, under " + axis.path + ", is required"
                                : "a case without this axis is required: " + users_text(in, input)}});
  } else if (axis.location.option) {
    warnings.push_back(path + ": has no effect on " + analysis_name(analysis) + "; used by sweep");
  }
}

// Requirement instead of a refused value; for a type of bearing, the type that every analysis models.
std::string required_instead(const Input& input) {
  return input.field->path == keys().bearing_type ? "cylindrical-roller is required" : "none is required";
}

}  // namespace

UseStatus use_status_in_row(const ResolvedCase& resolved, const Input& input, AnalysisId analysis) {
  const Use& use = use_of(resolved, input);
  if (is_behind_ratios(resolved, input, analysis)) return UseStatus::not_modelled;
  if (is_unknown_type(resolved, input, analysis)) return UseStatus::refused;
  if (use.by.has(analysis)) return UseStatus::used;
  if (way_that_holds(resolved, input, analysis) != nullptr) return UseStatus::used;
  if (is_used_through_another(resolved, input, analysis)) return UseStatus::used;
  if (use.not_modelled_by.has(analysis)) return UseStatus::not_modelled;
  return use.refused_by.has(analysis) ? UseStatus::refused : UseStatus::unused;
}

bool is_used(const ResolvedCase& resolved, const Input& input, AnalysisId analysis) {
  if (is_behind_ratios(resolved, input, analysis) || is_unknown_type(resolved, input, analysis)) return false;
  if (way_that_holds(resolved, input, analysis) != nullptr) return true;
  return use_status_in_row(resolved, input, analysis) == UseStatus::used &&
         first_unmet(resolved, input) == nullptr;
}

UseStatus use_status_of(const ResolvedCase& resolved, const Input& input, AnalysisId analysis) {
  const bool idle = first_unmet(resolved, input) != nullptr;
  if (is_neutral(resolved, input)) {
    // A value that an option of this command gives is reported to have no effect, whatever it is.
    const bool said = idle && resolved.location(input.path).option && !is_used(resolved, input, analysis) &&
                      use_status_in_row(resolved, input, analysis) == UseStatus::used;
    return said ? UseStatus::idle : UseStatus::neutral;
  }
  if (is_used(resolved, input, analysis)) return UseStatus::used;
  const UseStatus status = use_status_in_row(resolved, input, analysis);
  // A value that is not modelled in any case need not be refused.
  if (status == UseStatus::not_modelled) return status;
  return idle ? UseStatus::idle : status;
}

namespace {

// Without a bearing gears run alone, and in motion planets have one gear. What is missing then is the
// bearing.
void require_bearing(const ResolvedCase& in, AnalysisId analysis) {
  if (in.shape().bearing || in.shape().several || analysis != AnalysisId::gears) return;
  const std::string& stepped = keys().stepped_teeth;
  if (!in.has(stepped)) return;
  throw BadInput(in.file() +
                 ": bearing: missing; required: the bearing of the planets, as bearing.designation and "
                 "bearing.per_planet. Without one the gears move alone, which takes no " +
                 stepped + ". check computes ratio, speeds and mesh forces without it");
}

}  // namespace

std::vector<std::string> require_used(const ResolvedCase& resolved, AnalysisId analysis, Axes sweeps) {
  require_bearing(resolved, analysis);
  std::vector<Mistake> mistakes;
  std::vector<std::string> warnings = former_key_warnings(resolved);
  for (const Input& input : resolved.inputs()) {
    if (!resolved.has(input.path)) continue;
    const UseStatus status = use_status_of(resolved, input, analysis);
    const Location location = resolved.location(input.path);
    if (status == UseStatus::refused)
      mistakes.push_back(
          {location,
           input.path,
           {fmt::format("{}, which {} cannot take into account", quote(resolved.given(input.path)),
                        analysis_name(analysis)),
            required_instead(input) + ", or an analysis that includes it: " + users_text(resolved, input)}});
    else if (status == UseStatus::idle || status == UseStatus::unused ||
             (status == UseStatus::not_modelled && location.option))
      warnings.push_back(warning_of(resolved, input, analysis, status));
  }
  const std::vector<Input> inputs = resolved.inputs();
  if (std::any_of(inputs.begin(), inputs.end(), [&](const Input& input) {
        return input.field->path == keys().designation && resolved.has(input.path) &&
               use_status_in_row(resolved, input, analysis) == UseStatus::used;
      }))
    for (std::string& warning : inferred_warnings(resolved)) warnings.push_back(std::move(warning));
  for (const SweepAxis& axis : resolved.axes())
    if (goes_through(sweeps, axis) && resolved.has(axis.path) && resolved.location(axis.path).option)
      warnings.push_back(
          fmt::format("{}: {} has no effect together with sweep.{}, which sets it at each point", axis.path,
                      resolved.written(axis.path), axis.path));
  for (const SweepAxis& axis : resolved.axes())
    check_axis(resolved, axis, analysis, sweeps, mistakes, warnings);
  for (const StatedUncertain& one : resolved.uncertain().inputs)
    if (one.location.option)
      warnings.push_back(fmt::format("uncertain.{}: has no effect on {}; used by uncertainty and validate",
                                     one.path, analysis_name(analysis)));
  if (!mistakes.empty()) throw_mistakes(resolved.file(), std::move(mistakes));
  return warnings;
}

std::map<std::string, std::string> varied_without_effect(const ResolvedCase& resolved, AnalysisId analysis,
                                                         const std::vector<std::string>& varied) {
  std::vector<std::string> fields;
  for (const std::string& path : varied) fields.push_back(path.substr(0, path.find('[')));
  std::map<std::string, std::string> messages;
  for (std::size_t i = 0; i < varied.size(); ++i) {
    const Input input{fields[i], find_field(fields[i])};
    if (input.field == nullptr) continue;
    if (is_limit(*input.field) || is_one_of(fields[i], {"name", "source"})) {
      messages[varied[i]] = fmt::format(
          "{}: {}: found a varied input with which no result changes; required: an input that has an effect",
          resolved.file(), varied[i]);
      continue;
    }
    if (may_be_used(resolved, input, analysis, fields)) continue;
    const bool idle = use_status_in_row(resolved, input, analysis) == UseStatus::used;
    const std::string why = idle ? idle_text(resolved, input, analysis) : "";
    const std::string found =
        why.empty() ? fmt::format("no effect on {}; {}", analysis_name(analysis), users_text(resolved, input))
                    : "no effect: " + why;
    messages[varied[i]] =
        fmt::format("{}: {}: found a varied input that has {}; required: an input that has an effect",
                    resolved.file(), varied[i], found);
  }
  return messages;
}

void require_effect(const std::vector<ResolvedCase>& points, AnalysisId analysis,
                    const std::vector<std::string>& varied) {
  std::map<std::string, std::string> without;
  for (std::size_t i = 0; i < points.size() && (i == 0 || !without.empty()); ++i) {
    const std::map<std::string, std::string> here = varied_without_effect(points[i], analysis, varied);
    if (i == 0) without = here;
    std::erase_if(without, [&](const auto& one) { return !here.contains(one.first); });
  }
  std::vector<std::string> messages;
  for (const auto& [path, message] : without) messages.push_back(message);
  if (!messages.empty()) throw BadInput(messages);
}

std::vector<std::string> replaced_inputs(const ResolvedCase& resolved,
                                         const std::vector<std::string>& paths) {
  std::vector<std::string> messages;
  for (const std::string& path : paths) {
    if (!resolved.has(path) || !resolved.is_replaced(path)) continue;
    const Input input{path, find_field(path)};
    messages.push_back(fmt::format(
        "{}: {}: found '{}', which another input replaces: {}; required: one of both", resolved.file(), path,
        resolved.written(path), idle_text(resolved, input, AnalysisSet::all())));
  }
  return messages;
}

AnalysisId rung_of(const ResolvedCase& resolved, const std::string& fidelity) {
  if (fidelity == "dynamic")
    return resolved.shape().several ? AnalysisId::dynamic_of_sets : AnalysisId::dynamic;
  if (fidelity == "co-simulated") return AnalysisId::co_simulated;
  return fidelity == "monolithic" ? AnalysisId::monolithic : AnalysisId::quasi_static;
}

std::vector<std::string> former_key_warnings(const ResolvedCase& resolved) {
  std::vector<std::string> warnings;
  for (const FormerKey& key : resolved.former())
    warnings.push_back(fmt::format(
        "{}: former name of {}; write the present one. Versions 2 and later do not read the former name",
        key.former, key.present));
  return warnings;
}

std::vector<std::string> idle_inputs(const ResolvedCase& resolved) {
  std::vector<std::string> warnings;
  for (const Input& input : resolved.inputs())
    if (resolved.has(input.path) && !is_neutral(resolved, input) && !counts_itself(resolved, input))
      warnings.push_back(fmt::format("{}: {} has no effect: {}", input.path, resolved.written(input.path),
                                     idle_text(resolved, input, AnalysisSet::all())));
  return warnings;
}

std::vector<AnalysisId> analyses_of(const ResolvedCase& resolved) {
  const AnalysisSet allowed = analyses_that_fit(resolved);
  std::vector<AnalysisId> found;
  for (const AnalysisId analysis : every_analysis())
    if (allowed.has(analysis)) found.push_back(analysis);
  return found;
}

}  // namespace orbearing::app
