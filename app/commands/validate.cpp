#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <cstdio>

#include "app/case/case_file.hpp"
#include "app/commands/command_line.hpp"
#include "app/errors.hpp"
#include "app/study/ledger.hpp"
#include "app/study/motion_worth.hpp"
#include "app/study/stage_ledger.hpp"

namespace orbearing::app {

namespace {

nlohmann::ordered_json validation_json(const std::vector<Ledger>& ledgers) {
  const LedgerCount count = counted(ledgers);
  const auto all = [&ledgers](nlohmann::ordered_json (*part)(const Ledger&)) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Ledger& ledger : ledgers)
      for (const nlohmann::ordered_json& entry : part(ledger)) list.push_back(entry);
    return list;
  };
  return {{"distinct_values", count.published},         {"trends", count.trends},
          {"recomputed_values", count.recomputed},      {"rows", all(rows_json)},
          {"other_readings", all(other_readings_json)}, {"assumptions", all(worth_json)}};
}

int validate_motion(const Options& options) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const std::string& file : case_files(options.cases)) {
    const std::optional<MotionPlan> plan = read_expected(expected_beside(file)).motion;
    if (!plan) continue;
    const auto show = [&options](const MotionWorth& so_far) {
      if (options.json || options.quiet) return;
      if (so_far.curves.size() == 1) fmt::print("{}", motion_heading(so_far));
      fmt::print("{}", motion_line(so_far));
      std::fflush(stdout);  // a line takes a minute
    };
    const MotionWorth worth =
        motion_worth(read_case(file, options.settings), *plan, options.jobs, evaluated_motion, show);
    for (const nlohmann::ordered_json& entry : motion_json(worth)) list.push_back(entry);
  }
  if (list.empty())
    throw BadInput(
        "--motion: found no expected.yaml with a block 'motion' beside the cases; required: at least one");
  if (options.json) fmt::print("{}\n", nlohmann::ordered_json{{"motion", list}}.dump(2));
  return 0;
}

}  // namespace

int validate_command(const Options& options) {
  if (options.motion) return validate_motion(options);
  const bool text = !options.json && !options.quiet;
  std::vector<Ledger> ledgers;
  const auto add = [&](Ledger ledger) {
    ledgers.push_back(std::move(ledger));
    if (text) fmt::print("{}", ledger_text(ledgers.back()));
  };
  for (const std::string& file : case_files(options.cases))
    add(ledger_of(read_case(file, options.settings), read_expected(expected_beside(file))));
  if (options.cases.empty()) add(stage_ledger());
  if (text) fmt::print("{}", count_text(ledgers));
  if (options.json) fmt::print("{}\n", validation_json(ledgers).dump(2));
  return 0;
}

}  // namespace orbearing::app
