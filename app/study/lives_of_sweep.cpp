#include "app/study/lives_of_sweep.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/results/life_table.hpp"
#include "app/results/record_writers.hpp"
#include "app/results/result_row.hpp"

namespace orbearing::app {

namespace {

// The only row, or that with the longest of the lives that results go by; null where there is none.
const ResultRow* shown_row(const SweepOutcome& outcome) {
  const ResultRow* shown = nullptr;
  double longest = 0.0;
  for (const ResultRow& row : outcome.rows) {
    const double life = life_to_go_by(outcome.head, row);
    if (!row.ok() || !std::isfinite(life) || life <= longest) continue;
    longest = life;
    shown = &row;
  }
  return shown;
}

LifeWords words_of(const ResolvedCase& in) {
  return {bearing::rating::RollingElement::roller,
          in.has("life.reduction_factor") ? in.number("life.reduction_factor") : 0.0};
}

LifeTable table_at(const SweepOutcome& outcome, const ResultRow& row, const ResolvedCase& in) {
  return {[&](const std::string& name) { return value_of(outcome.head, row, name); }, words_of(in)};
}

}  // namespace

std::string lives_text_of(const ResolvedCase& resolved, const SweepOutcome& outcome) {
  const ResultRow* row = shown_row(outcome);
  if (row == nullptr) return "";
  const std::string table = lives_text(table_at(outcome, *row, resolved));
  if (outcome.rows.size() == 1) return table + "\n";
  return fmt::format("at {:.6g} rpm, where {} is longest:\n{}\n",
                     value_of(outcome.head, *row, "input_speed_rpm"), outcome.head.life, table);
}

nlohmann::ordered_json lives_record_of(const ResolvedCase& resolved, const SweepOutcome& outcome) {
  const ResultRow* row = shown_row(outcome);
  if (row == nullptr) return nullptr;
  Record record;
  describe(record, table_at(outcome, *row, resolved));
  record.value("speed_rpm", {}, "of the point", value_of(outcome.head, *row, "input_speed_rpm"));
  record.value("life_key", "life that results go by", outcome.head.life);
  return json_of(record);
}

}  // namespace orbearing::app
