#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/case/case_file.hpp"
#include "app/commands/command_line.hpp"
#include "app/study/ledger.hpp"
#include "app/study/stage_ledger.hpp"

namespace orbearing::app {

namespace {

void append(const nlohmann::ordered_json& more, nlohmann::ordered_json& list) {
  for (const nlohmann::ordered_json& entry : more) list.push_back(entry);
}

}  // namespace

int validate_command(const Options& options) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  nlohmann::ordered_json worth = nlohmann::ordered_json::array();
  for (const std::string& file : case_files(options.cases)) {
    const Ledger ledger = ledger_of(read_case(file, options.settings), read_expected(expected_beside(file)));
    append(rows_json(ledger), rows);
    append(worth_json(ledger), worth);
    if (!options.json && !options.quiet) fmt::print("{}", ledger_text(ledger));
  }
  if (options.cases.empty()) {
    const Ledger stage = stage_ledger();
    append(rows_json(stage), rows);
    if (!options.json && !options.quiet) fmt::print("{}", ledger_text(stage));
  }
  if (options.json)
    fmt::print("{}\n", nlohmann::ordered_json{{"rows", rows}, {"assumptions", worth}}.dump(2));
  return 0;
}

}  // namespace orbearing::app
