#include "app/study/validation_table.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "app/case/defect_case.hpp"
#include "app/errors.hpp"
#include "app/study/defect_study.hpp"
#include "app/study/planet_defect.hpp"
#include "app/study/duplex_study.hpp"
#include "app/study/film_study.hpp"
#include "app/study/gear_case.hpp"
#include "app/study/gear_output.hpp"
#include "app/study/mesh_study.hpp"
#include "app/study/static_study.hpp"

namespace orbearing::app {

namespace {

// Where a tolerance is zero, a number printed to a few digits still is a decimal fraction.
constexpr double kRoundOff = 1e-9;

std::string verdict_of(const ValidationRow& row, bool trend) {
  if (!row.published || !row.ours) return "input missing";
  if (std::abs(*row.deviation) > row.tolerance + kRoundOff) return "missed";
  return trend ? "trend" : "reproduced";
}

ValidationRow compare(const PublishedValue& published, double ours, const std::string& reading) {
  ValidationRow row{.source = published.source,
                    .quantity = published.quantity,
                    .reading = reading,
                    .published = published.value,
                    .tolerance = published.tolerance,
                    .evidence = published.evidence};
  if (std::isfinite(ours)) row.ours = ours;
  return judged(std::move(row), published.trend);
}

std::string cell(const std::optional<double>& value) {
  return value ? fmt::format("{:.6g}", *value) : "-";
}

std::string deviation_cell(const std::optional<double>& value) {
  return value ? fmt::format("{:+.1f} %", 100.0 * *value) : "-";
}

std::string key_with_reading(const ValidationRow& row) {
  return row.reading.empty() ? row.quantity : row.quantity + " | " + row.reading;
}

nlohmann::ordered_json number(const std::optional<double>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json comparisons_json(const std::string& case_name,
                                        const std::vector<ValidationRow>& rows) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ValidationRow& row : rows)
    list.push_back({{"source", row.source},
                    {"quantity", row.quantity},
                    {"published", number(row.published)},
                    {"ours", number(row.ours)},
                    {"deviation", number(row.deviation)},
                    {"tolerance", row.tolerance},
                    {"verdict", row.verdict},
                    {"case", case_name},
                    {"reading", row.reading},
                    {"evidence", row.evidence == Evidence::published ? "published" : "recomputed"}});
  return list;
}

// One line for each reading: our value of each quantity, marked where it misses the published one.
std::string other_readings_text(const ValidationTable& table) {
  if (table.other_readings.empty()) return "";
  std::vector<std::string> quantities;
  for (const ValidationRow& row : table.rows)
    if (row.published) quantities.push_back(row.quantity);
  std::string text = "\nThe same values under other readings (* where a published one is missed)\n";
  for (const std::string& quantity : quantities) text += fmt::format("{:>{}}", quantity, quantity.size() + 2);
  text += "  reading\n";
  const ValidationRow* row = table.other_readings.data();
  for (std::size_t left = table.other_readings.size(); left >= quantities.size(); left -= quantities.size()) {
    std::string line;
    for (const std::string& quantity : quantities) {
      const std::string shown = cell(row->ours) + (row->verdict == "missed" ? "*" : " ");
      line += fmt::format("{:>{}}", shown, quantity.size() + 2);
      ++row;
    }
    text += line + "  " + (row - 1)->reading + "\n";
  }
  return text;
}

// Of the case as it stands, at its peak.
std::string by_unit_text(const Sensitivity& one) {
  if (!one.derivative) return "-";
  const std::string unit = one.derivative->unit == "1" ? "" : "/" + one.derivative->unit;
  return fmt::format("{:+.4g} h{}", one.derivative->derivative, unit);
}

std::string sensitivities_text(const ValidationTable& table) {
  if (table.sensitivities.empty()) return "";
  std::string text = "\nWhat each assumption is worth\n";
  text += fmt::format("{:<44} {:>14} {:>12} {:>11} {:>17}  {}\n", "assumption", "peak [rpm]", "life [h]",
                      "worth [h]", "by each unit", "other reading");
  for (const Sensitivity& one : table.sensitivities)
    text += fmt::format("{:<44} {:>14.0f} {:>12.0f} {:>+11.0f} {:>17}  {}\n", one.change.group,
                        one.peak_speed_rpm, one.peak_life_h, one.difference_h, by_unit_text(one), one.change.name);
  return text;
}

std::string reading_of(const std::vector<std::string>& settings) {
  return fmt::format("{}", fmt::join(settings, ", "));
}

// Numbers that one study of the case answers all at once; each may belong to a variant of the case.
template <typename StudyOf, typename Property>
ValidationTable study_table(const ResolvedCase& resolved, const ExpectedFile& expected,
                            const StudyOf& study_of, const Property& property_of) {
  ValidationTable table{.case_name = resolved.text("name")};
  std::map<std::string, decltype(study_of(resolved))> studies;  // by reading; most belong to one of few
  for (const PublishedValue& published : expected.published) {
    const std::string reading = reading_of(published.settings);
    auto study = studies.find(reading);
    if (study == studies.end())
      study = studies.emplace(reading, study_of(with_settings(resolved, published.settings))).first;
    table.rows.push_back(compare(published, property_of(study->second, published.quantity), reading));
  }
  return table;
}

ModeStudy modes_of(const ResolvedCase& resolved) {
  return mode_study(gear_model_of(resolved));
}

}  // namespace

ValidationRow judged(ValidationRow row, bool trend) {
  if (row.published && row.ours) row.deviation = *row.ours / *row.published - 1.0;
  row.trend = trend;
  row.verdict = verdict_of(row, trend);
  return row;
}

ValidationTable validation_table_of(const ResolvedCase& resolved, const ExpectedFile& expected, int jobs) {
  if (resolved.model() == gear_pair) return study_table(resolved, expected, mesh_study, mesh_property);
  if (is_static_bearing(resolved)) return study_table(resolved, expected, static_study, static_property);
  if (is_defect(resolved))
    return study_table(
        resolved, expected, [](const ResolvedCase& in) { return defect_study(in); }, defect_property);
  if (is_duplex(resolved)) return study_table(resolved, expected, duplex_study, duplex_property);
  if (is_spin_film(resolved)) return study_table(resolved, expected, film_study, film_property);
  if (resolved.model() != planetary_drivetrain)
    throw BadInput(resolved.origin("model") + ": model: found " + resolved.choice("model") +
                   "; the validation table requires planetary-drivetrain, gear-pair, roller-bearing, "
                   "ball-bearing, raceway-defect, duplex-pair or spin-film");
  if (is_planet_defect(resolved))
    return study_table(
        resolved, expected, [](const ResolvedCase& in) { return planet_defect_study(in); }, planet_defect_property);
  if (!resolved.shape().teeth) return study_table(resolved, expected, modes_of, mode_property);
  const std::vector<ChangeResult> results =
      results_of(resolved, with_reference(expected.alternatives), {.jobs = jobs});
  const LifeCurve base = life_curve(results.front());
  ValidationTable table{.case_name = resolved.text("name"), .sensitivities = sensitivities(results)};
  put_derivatives(resolved, property(base, "peak_speed_rpm"), table.sensitivities);
  for (const PublishedValue& published : expected.published)
    table.rows.push_back(compare(published, property(base, published.quantity), ""));
  for (const Sensitivity& one : table.sensitivities)
    for (const PublishedValue& published : expected.published)
      if (published.value)
        table.other_readings.push_back(
            compare(published, property(one.curve, published.quantity), one.change.name));
  return table;
}

ValidationCount counted(const std::vector<ValidationTable>& tables) {
  ValidationCount count;
  std::set<std::tuple<std::string, std::string, std::string, std::string, double>> seen;
  for (const ValidationTable& table : tables) {
    count.comparisons_under_other_readings += static_cast<int>(table.other_readings.size());
    for (const ValidationRow& row : table.rows) {
      if (!row.published ||
          !seen.emplace(table.case_name, row.source, row.quantity, row.reading, *row.published).second)
        continue;
      ++(row.evidence == Evidence::recomputed ? count.recomputed : count.published);
      count.trends += row.trend ? 1 : 0;
    }
  }
  return count;
}

std::string count_text(const std::vector<ValidationTable>& tables) {
  const ValidationCount count = counted(tables);
  std::map<std::string, int> verdicts;
  for (const ValidationTable& table : tables)
    for (const ValidationRow& row : table.rows)
      if (row.evidence == Evidence::published) ++verdicts[row.verdict];
  std::string text =
      fmt::format("\n{} distinct published values ({} of them trends):", count.published, count.trends);
  for (const auto& [verdict, number] : verdicts) text += fmt::format(" {} {},", number, verdict);
  text.back() = '\n';
  return text +
         fmt::format(
             "{} values recomputed from their sources' data; {} comparisons of the same values under other "
             "readings\n",
             count.recomputed, count.comparisons_under_other_readings);
}

nlohmann::ordered_json rows_json(const ValidationTable& table) {
  return comparisons_json(table.case_name, table.rows);
}

nlohmann::ordered_json other_readings_json(const ValidationTable& table) {
  return comparisons_json(table.case_name, table.other_readings);
}
nlohmann::ordered_json sensitivities_json(const ValidationTable& table) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Sensitivity& one : table.sensitivities) {
    const std::optional<LifeDerivative>& by = one.derivative;
    list.push_back({{"case", table.case_name},
                    {"assumption", one.change.group},
                    {"reading", one.change.name},
                    {"settings", one.change.settings},
                    {"peak_speed_rpm", one.peak_speed_rpm},
                    {"peak_life_h", one.peak_life_h},
                    {"worth_h", one.difference_h},
                    {"derivative_h_per_unit", by ? nlohmann::ordered_json(by->derivative) : nullptr},
                    {"unit", by ? nlohmann::ordered_json(by->unit) : nullptr},
                    {"elasticity", by && by->elasticity ? nlohmann::ordered_json(*by->elasticity) : nullptr}});
  }
  return list;
}

std::string validation_text(const ValidationTable& table) {
  std::string text =
      fmt::format("{}\n{:<24} {:>10} {:>10} {:>10} {:>10}  {:<13}  {}\n", table.case_name, "source",
                  "published", "ours", "deviation", "tolerance", "verdict", "quantity");
  for (const ValidationRow& row : table.rows)
    text += fmt::format("{:<24} {:>10} {:>10} {:>10} {:>10.3g}  {:<13}  {}\n", row.source,
                        cell(row.published), cell(row.ours), deviation_cell(row.deviation), row.tolerance,
                        row.verdict, key_with_reading(row));
  return text + other_readings_text(table) + sensitivities_text(table);
}

}  // namespace orbearing::app
