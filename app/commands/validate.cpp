#include "app/commands/validate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <map>
#include <set>
#include <string>

#include "app/case/case_file.hpp"
#include "app/commands/presentation.hpp"
#include "app/errors.hpp"
#include "app/results/record_writers.hpp"
#include "app/study/report_data.hpp"
#include "app/study/sensitivity.hpp"
#include "app/study/validation_table.hpp"
#include "gearset/drivetrain/power_flow.hpp"
#include "gearset/mean_loads.hpp"
#include "orbearing/request.hpp"

namespace orbearing::app {

namespace {

// A row that needs no case: the low-speed planetary stage of the gearbox of [Oyague2011], mean load of a
// planet bearing. The number it is compared with is not printed there but follows from its parameters, by
// T/(N n a).
ValidationTable stage_validation() {
  constexpr double torque = 325e3;           // [N m]  of the rotor, on the carrier
  constexpr double centre_distance = 0.308;  // [m]    of the helical gears, as stated
  constexpr int bearings_per_planet = 2;
  constexpr double recomputed = 175.9;                // [kN]
  constexpr double half_a_digit = 0.05 / recomputed;  // of the number it is compared with
  const gearset::PlanetarySet stage{.sun_teeth = 21,
                                    .planet_teeth = 39,
                                    .ring_teeth = 99,
                                    .planets = 3,
                                    .fixed_member = gearset::Member::ring};
  const gearset::PowerFlow flow =
      gearset::power_flow(gearset::arrangement_of(stage, gearset::Member::carrier, "stage"));
  const double load =
      gearset::planet_tangential_load(torque * flow.sets.front().torque.carrier, stage.planets,
                                      centre_distance) /
      bearings_per_planet;  // [N]  a helix adds axial forces and a tilting moment, none in this plane
  ValidationRow row = judged({.source = "[Oyague2011], recomputed",
                              .kind = EvidenceKind::recomputed,
                              .of = "bearing load",
                              .quantity = "mean_planet_bearing_load_kN",
                              .meaning = "mean load of a planet bearing at 325 kN.m on the rotor",
                              .value = recomputed,
                              .tolerance = half_a_digit},
                             1e-3 * load);
  row.unit = "kN";
  return {.case_name = "nrel_grc_750kW", .rows = {row}};
}

// Published numbers belong to the case as its file states it.
void add_changed_inputs(const std::string& file, const std::vector<std::string>& settings,
                        std::vector<std::string>& warnings) {
  if (settings.empty()) return;
  for (const std::string& changed : changed_inputs(read_case(file, settings), read_case(file)))
    warnings.push_back(
        fmt::format("{}: --set: {}: published numbers are of the case as its file states it", file, changed));
}

void describe_count(Record& record, const ValidationCount& count) {
  record.value("distinct_values", "published by sources", count.published);
  record.value("sources", "of them", count.sources);
  record.value("trends", "among them", count.trends);
  record.value("fitted_values", "among them, that constants of their case were identified from",
               count.fitted);
  record.value("recomputed_values", "that follow from formulas or data of a source", count.recomputed);
  record.value("remembered_values", "not read", count.remembered);
  record.value("further_lines", "of passing elements, beyond the one that counts of each bearing",
               count.lines_of_one_formula);
  record.child("verdicts", "by kind of evidence", count.verdicts, [](Record& kinds, const auto& of_kinds) {
    for (const auto& [kind, verdicts] : of_kinds) {
      std::vector<std::string> names;
      std::vector<int> values;
      for (const auto& [verdict, number] : verdicts) {
        names.push_back(verdict);
        values.push_back(number);
      }
      described::Entry& entry = kinds.array(kind, {}, "values by verdict", {{"verdict", names}}, values);
      std::get<described::Numbers>(entry.content).kind = described::NumberKind::whole;
    }
  });
}

// With the unit of each compared number.
void print_validation(const std::vector<ValidationTable>& tables, const std::vector<std::string>& warnings,
                      const Printing& print) {
  Record record;
  describe_count(record, counted(tables));
  describe(record, tables);
  nlohmann::ordered_json object = json_of(record);
  object["warnings"] = warnings;
  for (const ValidationTable& table : tables)
    for (const ValidationRow& row : table.rows)
      if (!row.unit.empty()) object["units"][row.published.quantity] = row.unit;
  print_result(std::move(object), record, print);
}

// Output of the command for the case with --json.
nlohmann::ordered_json command_result(const std::string& command, const std::string& fidelity,
                                      const ResolvedCase& resolved) {
  Request request{.command = command, .given = Case(resolved)};
  if (fidelity != kDefaultFidelity) request.options = fmt::format(R"({{"fidelity": "{}"}})", fidelity);
  const Answer found = answer(request);
  if (found.code != 0)
    throw ComputationFailed(fmt::format("{}: {}", command, fmt::join(found.failures, "; ")));
  return nlohmann::ordered_json::parse(found.result);
}

/// Warnings that a stated input has no effect: our number may then be of another machine than the published
/// one. An input that a row states counts there, one of the case where no result of the case depends on it.
class InputsWithoutEffect {
 public:
  InputsWithoutEffect(const ResolvedCase& stated, const ExpectedFile& expected) : stated_(stated) {
    for (const PublishedValue& row : expected.published) {
      for (const auto* settings : {&row.settings, &row.against})
        for (const std::string& setting : *settings) in_rows_.insert(setting.substr(0, setting.find('=')));
      has_life_curve_ = has_life_curve_ || !result_pointer(row.quantity);
    }
  }

  void note(const nlohmann::ordered_json& result, const ResolvedCase& variant) {
    ++results_;
    std::map<std::string, std::string> found;
    for (const auto& one : result.value("warnings", nlohmann::ordered_json::array()))
      if (const auto text = one.get<std::string>(); text.find(" has no effect") != std::string::npos)
        found.emplace(text.substr(0, text.find(':')), text);
    for (auto& [path, text] : found) {
      Seen& seen = seen_.try_emplace(path, Seen{std::move(text)}).first->second;
      ++seen.times;
      seen.by_row = seen.by_row || is_of_row(path, variant);
    }
  }

  std::vector<std::string> warnings() const {
    std::vector<std::string> found;
    for (const auto& [path, seen] : seen_) {
      const bool by_all = seen.times == results_ && !has_life_curve_;
      if (!is_of_a_study(path) && (seen.by_row || by_all))
        found.push_back(stated_.text("name") + ": " + seen.text);
    }
    return found;
  }

 private:
  struct Seen {
    std::string text;
    int times = 0;
    bool by_row = false;
  };
  bool is_of_row(const std::string& path, const ResolvedCase& variant) const {
    return in_rows_.contains(path) && variant.has(path) &&
           (!stated_.has(path) || stated_.written(path) != variant.written(path));
  }
  // These count in other commands.
  static bool is_of_a_study(const std::string& path) {
    return path.starts_with("uncertain.") || path.starts_with("sweep.");
  }

  const ResolvedCase& stated_;
  std::set<std::string> in_rows_;
  bool has_life_curve_ = false;  // whose inputs are not compared
  int results_ = 0;
  std::map<std::string, Seen> seen_;
};

int validate_motion(const ValidateOptions& options) {
  std::vector<Record> rows;
  for (const std::string& file : case_files(options.cases)) {
    const std::optional<MotionPlan> plan = read_expected(expected_beside(file)).motion;
    if (!plan) continue;
    const ResolvedCase resolved = read_case(file, options.settings);
    const std::string& name = resolved.text("name");
    const auto show = [&](const std::vector<ChangeResult>& results, std::size_t done) {
      if (options.print.json || options.print.quiet) return;
      if (done == 1) fmt::print("{}", motion_heading(name, *plan));
      fmt::print("{}", motion_line(*plan, results.front(), results[done - 1]));
      std::fflush(stdout);  // a line takes a minute
    };
    const std::vector<ChangeResult> results = results_of(resolved, with_reference(plan->alternatives),
                                                         study_of(resolved, *plan, options.jobs), show);
    for (const ChangeResult& result : results)
      describe_reading(rows.emplace_back(), name, *plan, results.front(), result);
  }
  if (rows.empty())
    throw BadInput(
        "--motion: found no expected.yaml with a block 'motion' in the folders of the cases; required: at "
        "least one");
  Record record;
  record.table("motion", "reading", "effect of each other reading in motion", rows,
               [](Record& row, const Record& of) { row = of; });
  if (options.print.json) print_result(json_of(record), record, options.print);
  return 0;
}

}  // namespace

int execute(const ValidateOptions& options) {
  if (options.motion) return validate_motion(options);
  const bool text = !options.print.json && !options.print.quiet;
  std::vector<ValidationTable> tables;
  const auto add = [&](ValidationTable table) {
    tables.push_back(std::move(table));
    if (text) fmt::print("{}", validation_text(tables.back()));
  };
  std::vector<std::string> warnings;
  for (const std::string& file : case_files(options.cases)) {
    add_changed_inputs(file, options.settings, warnings);
    const ResolvedCase resolved = read_case(file, options.settings);
    const ExpectedFile expected = read_expected(expected_beside(file));
    InputsWithoutEffect without_effect(resolved, expected);
    const auto result_of = [&](const std::string& command, const std::string& fidelity,
                               const ResolvedCase& variant) {
      nlohmann::ordered_json result = command_result(command, fidelity, variant);
      without_effect.note(result, variant);
      return result;
    };
    add(validation_table_of(resolved, expected,
                            {.jobs = options.jobs, .result_of = result_of, .samples = options.samples}));
    for (const std::string& warning : without_effect.warnings()) warnings.push_back(warning);
  }
  if (options.cases.empty()) add(stage_validation());
  if (text) fmt::print("{}", count_text(tables));
  if (text) print_warnings(warnings);
  if (options.print.json) print_validation(tables, warnings, options.print);
  return 0;
}

}  // namespace orbearing::app
