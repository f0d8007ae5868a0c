#include "app/study/validation_table.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>
#include <utility>

#include "app/case/defect_case.hpp"
#include "app/errors.hpp"
#include "app/results/record_writers.hpp"
#include "app/study/uncertain_samples.hpp"

namespace orbearing::app {

namespace dimension = described::dimension;

namespace {

// Round-off of a printed decimal fraction, for a tolerance of zero.
constexpr double kRoundOff = 1e-9;

std::string verdict_of(const ValidationRow& row) {
  if (!row.published.value || !row.ours) return "input missing";
  if (std::abs(*row.deviation) > row.published.tolerance + kRoundOff) return "missed";
  return row.is_trend() ? "trend" : "reproduced";
}

std::string cell(const std::optional<double>& value) {
  return value ? fmt::format("{:.6g}", *value) : "-";
}

std::string deviation_cell(const std::optional<double>& value) {
  return value ? fmt::format("{:+.1f} %", 100.0 * *value) : "-";
}

std::string key_with_reading(const ValidationRow& row) {
  const std::string& quantity = row.published.quantity;
  return row.reading.empty() ? quantity : quantity + " | " + row.reading;
}

void describe_ends(Record& record, const ValidationBand& band) {
  record.value("low_90", {}, "lower end of the middle 90 %", band.low_90);
  record.value("low_50", {}, "lower end of the middle 50 %", band.low_50);
  record.value("high_50", {}, "upper end of the middle 50 %", band.high_50);
  record.value("high_90", {}, "upper end of the middle 90 %", band.high_90);
  record.value("samples", "that gave a number", band.samples);
  record.value("lost", "samples that gave none", band.lost);
}

/// A row, with the table that it is of.
template <class Row>
using RowOf = std::pair<const ValidationTable*, const Row*>;

template <class Row>
std::vector<RowOf<Row>> rows_of_all(const std::vector<ValidationTable>& tables,
                                    std::vector<Row> ValidationTable::*rows) {
  std::vector<RowOf<Row>> found;
  for (const ValidationTable& table : tables)
    for (const Row& row : table.*rows) found.emplace_back(&table, &row);
  return found;
}

void describe_comparison(Record& record, const RowOf<ValidationRow>& one) {
  const auto& [table, row] = one;
  const PublishedValue& published = row->published;
  record.value("source", "of the published number", published.source);
  record.value("quantity", "its name in units, which may be COMMAND:/json/pointer", published.quantity);
  record.value("published", {}, "number in the source", published.value);
  record.value("ours", {}, "the same by this program", row->ours);
  record.value("deviation", dimension::ratio, "computed value divided by published value, minus 1",
               row->deviation);
  record.value("tolerance", dimension::ratio, "largest deviation that is reproduced", published.tolerance);
  record.value("verdict", "reproduced, trend, missed or input missing", row->verdict);
  record.value("case", "name", table->case_name);
  record.value("reading", "settings; empty: the case unchanged", row->reading);
  record.value("evidence", "kind of the source", described::text_of(published.kind));
  record.value("of", "class of the quantity", published.of);
  record.value("meaning", "of the number", published.meaning);
  record.value("scatter", dimension::ratio, "standard deviation of the measurement", published.scatter);
  record.child("band", "of the computed value, by the uncertain inputs of the case", row->band,
               describe_ends);
  record.value("why", "it is missed", published.why);
  record.value("memory", "value from memory, not read in the source", published.memory);
  record.value("fitted", "whether constants of the case were identified from it", published.fitted);
}

void describe_assumption(Record& record, const RowOf<Sensitivity>& one) {
  const auto& [table, row] = one;
  const std::optional<Derivative>& by = row->derivative;
  record.value("case", "name", table->case_name);
  record.value("assumption", "key of the case", row->change.group);
  record.value("reading", "other interpretation", row->change.name);
  record.value("settings", "of the case", row->change.settings);
  record.value("peak_speed_rpm", in_rpm, "of the longest life under the other reading", row->peak_speed_rpm);
  record.value("peak_life_h", dimension::hours, "longest life under it", row->peak_life_h);
  record.value("life_change_h", dimension::hours, "change of the longest life", row->difference_h).former =
      "worth_h";
  record.value("derivative_h_per_unit", {}, "of the life by the assumed number",
               by ? by->derivative : described::kAbsent);
  if (by)
    record.value("unit", "of that number", by->unit);
  else
    record.nothing("unit", "of that number");
  record.value("elasticity", dimension::ratio, "d ln(life) / d ln(number)",
               by ? by->elasticity : std::nullopt);
}

// Whether the value is compared again under the other readings of the case.
bool has_other_readings(const PublishedValue& published) {
  return published.value && published.settings.empty() && !result_pointer(published.quantity);
}

// One line for each reading: our value of each quantity, marked where it misses the published one.
std::string other_readings_text(const ValidationTable& table) {
  if (table.other_readings.empty()) return "";
  std::vector<std::string> quantities;
  for (const ValidationRow& row : table.rows)
    if (has_other_readings(row.published)) quantities.push_back(row.published.quantity);
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

// Derivative for the unchanged case at its peak.
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
                        one.peak_speed_rpm, one.peak_life_h, one.difference_h, by_unit_text(one),
                        one.change.name);
  return text;
}

std::string reading_of(const PublishedValue& published) {
  const std::string reading = fmt::format("{}", fmt::join(published.settings, ", "));
  if (published.against.empty()) return reading;
  return fmt::format("{} against {}", reading, fmt::join(published.against, ", "));
}

using Rows = std::vector<const PublishedValue*>;

struct OurNumber {
  double value = described::kAbsent;
  std::string unit{};
};

bool has_life_curve(const ResolvedCase& resolved) {
  return resolved.model() == planetary_drivetrain && !is_planet_defect(resolved) && resolved.shape().teeth;
}

// The numbers of the life curve, as a command would print them.
nlohmann::ordered_json life_curve_json(const ResolvedCase& variant) {
  if (!has_life_curve(variant))
    throw BadInput(
        variant.origin("model") + ": model: found " + variant.choice("model") +
        "; quantities by name are those of planetary-drivetrain with teeth; required: this model, or "
        "quantities such as run:/json/pointer");
  const Record record = record_of(life_curve(variant));
  nlohmann::ordered_json object = json_of(record);
  object["units"] = units_of(record);
  return object;
}

double number_at(const nlohmann::ordered_json& object, const std::string& quantity,
                 const std::string& pointer) {
  nlohmann::ordered_json found;
  try {
    found = object.at(nlohmann::ordered_json::json_pointer(pointer));
  } catch (const nlohmann::ordered_json::exception& error) {
    throw BadInput(fmt::format("expected.yaml: quantity: found {} ({}); required: a number of that result",
                               quantity, error.what()));
  }
  if (found.is_null()) return std::numeric_limits<double>::quiet_NaN();
  if (found.is_boolean()) return found.get<bool>() ? 1.0 : 0.0;
  if (found.is_number()) return found.get<double>();
  throw BadInput(
      fmt::format("expected.yaml: quantity: {} is {}; required: a number", quantity, found.type_name()));
}

// The unit of the number there: by a key or by the path, both without the numbers of rows.
std::string unit_at(const nlohmann::ordered_json& units, const std::string& pointer) {
  std::string path, unit;
  for (std::size_t begin = 1, end = 0; end != std::string::npos; begin = end + 1) {
    end = pointer.find('/', begin);
    const std::string key = pointer.substr(begin, end - begin);
    if (key.find_first_not_of("0123456789") == std::string::npos) continue;
    path += (path.empty() ? "" : "/") + key;
    for (const std::string& name : {key, path})
      if (const auto found = units.find(name); found != units.end() && found->is_string()) unit = *found;
  }
  return unit;
}

// Our numbers for rows of one and the same variant of a case: by pointers into what a command prints, or by
// names of the life curve, where what it does not have is absent. Throws BadInput and ComputationFailed.
std::vector<OurNumber> values_of(const ResolvedCase& variant, const Rows& rows, const ResultOf& result_of) {
  std::map<std::pair<std::string, std::string>, nlohmann::ordered_json> results;
  std::vector<OurNumber> values;
  for (const PublishedValue* row : rows) {
    const std::optional<ResultPointer> at = result_pointer(row->quantity);
    const auto [result, is_new] = results.try_emplace({at ? at->command : "", row->fidelity});
    if (is_new)
      result->second = at ? result_of(at->command, row->fidelity, variant) : life_curve_json(variant);
    const nlohmann::ordered_json& object = result->second;
    const std::string pointer = at ? at->pointer : "/" + row->quantity;
    if (!at && !object.contains(row->quantity))
      values.emplace_back();
    else
      values.push_back({number_at(object, row->quantity, pointer),
                        unit_at(object.value("units", nlohmann::ordered_json::object()), pointer)});
  }
  return values;
}

bool needs_band(const PublishedValue& published) {
  return published.kind == EvidenceKind::measurement && published.value && published.against.empty();
}

// Linear between the sorted values.
double quantile_of(const std::vector<double>& sorted, double share) {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

// None where less than half of the samples gave a number.
std::optional<ValidationBand> band_of(std::vector<double> sampled, int lost) {
  if (sampled.empty() || static_cast<std::size_t>(lost) > sampled.size()) return std::nullopt;
  std::sort(sampled.begin(), sampled.end());
  return ValidationBand{.low_90 = quantile_of(sampled, 0.05),
                        .low_50 = quantile_of(sampled, 0.25),
                        .high_50 = quantile_of(sampled, 0.75),
                        .high_90 = quantile_of(sampled, 0.95),
                        .samples = static_cast<int>(sampled.size()),
                        .lost = lost};
}

// Values of `rows` at samples of the uncertain inputs of the variant: [row][sample]. A sample that
// contradicts the case or cannot be computed gives none.
std::vector<std::vector<double>> sampled_values(const ResolvedCase& variant, const Rows& rows,
                                                const ValidationOptions& options) {
  const UncertainInputs uncertain = uncertain_inputs(variant);
  for (const UncertainInput& one : uncertain.inputs)
    if (one.standard_deviation == 0.0)
      throw BadInput(fmt::format("{}: uncertain.{}: found a standard deviation of 0; required: one above 0",
                                 variant.text("name"), one.path));
  std::vector<std::vector<double>> sampled(rows.size());
  for (const std::vector<double>& sample : uncertain_samples(uncertain, options.samples, options.seed)) {
    std::vector<Setting> settings;
    for (std::size_t i = 0; i < sample.size(); ++i)
      settings.push_back({uncertain.inputs[i].path, "", sample[i]});
    std::vector<OurNumber> values(rows.size());
    try {
      values = values_of(variant.with(settings), rows, options.result_of);
    } catch (const BadInput&) {
    } catch (const ComputationFailed&) {
    }
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (std::isfinite(values[i].value)) sampled[i].push_back(values[i].value);
  }
  return sampled;
}

using Bands = std::map<const PublishedValue*, ValidationBand>;

void put_bands(const ResolvedCase& variant, const Rows& rows, const ValidationOptions& options,
               Bands& bands) {
  Rows measured;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(measured),
               [](const PublishedValue* row) { return needs_band(*row); });
  if (options.samples == 0 || measured.empty() || variant.uncertain().inputs.empty()) return;
  const std::vector<std::vector<double>> sampled = sampled_values(variant, measured, options);
  for (std::size_t i = 0; i < measured.size(); ++i)
    if (const auto band = band_of(sampled[i], options.samples - static_cast<int>(sampled[i].size())))
      bands.emplace(measured[i], *band);
}

// A variant that cannot be computed misses what is published of it.
ValidationRow failed(const PublishedValue& published, const std::string& reading, const std::string& reason) {
  ValidationRow row{.published = published, .reading = reading, .verdict = "missed"};
  row.published.why += (published.why.empty() ? "" : "; ") + ("not computed: " + reason);
  return row;
}

struct Variant {
  std::vector<std::string> settings;
  bool pointed = false;  // by pointers, else by names: one may fail without the other
  Rows rows{};
};

// Rows by the variant of the case to which they belong, in the order of its first.
std::vector<Variant> variants_of(const ExpectedFile& expected, bool with_pointers) {
  std::vector<Variant> variants;
  for (const PublishedValue& published : expected.published) {
    const bool pointed = result_pointer(published.quantity).has_value();
    if (pointed && !with_pointers) continue;
    auto variant = std::ranges::find_if(variants, [&](const Variant& one) {
      return one.settings == published.settings && one.pointed == pointed;
    });
    if (variant == variants.end()) variant = variants.insert(variants.end(), {published.settings, pointed});
    variant->rows.push_back(&published);
  }
  return variants;
}

// The rows of the table in the order of the file.
class RowsOfCase {
 public:
  RowsOfCase(const ResolvedCase& resolved, const ValidationOptions& options)
      : resolved_(resolved), options_(options) {}

  void compute(const Variant& variant) {
    const ResolvedCase changed = with_settings(resolved_, variant.settings);
    const Rows& rows = variant.rows;
    try {
      const std::vector<OurNumber> values = values_of(changed, rows, options_.result_of);
      for (std::size_t i = 0; i < rows.size(); ++i) {
        const OurNumber number = compared(*rows[i], values[i]);
        ValidationRow row = judged(*rows[i], number.value, reading_of(*rows[i]));
        row.unit = number.unit;
        rows_.emplace(rows[i], std::move(row));
      }
    } catch (const ComputationFailed& error) {
      for (const PublishedValue* row : rows) rows_.emplace(row, failed(*row, reading_of(*row), error.what()));
      return;
    }
    Bands bands;
    put_bands(changed, rows, options_, bands);
    for (const auto& [row, band] : bands) rows_.at(row).band = band;
  }

  std::vector<ValidationRow> in_order(const ExpectedFile& expected) const {
    std::vector<ValidationRow> rows;
    for (const PublishedValue& published : expected.published)
      if (const auto found = rows_.find(&published); found != rows_.end()) rows.push_back(found->second);
    return rows;
  }

 private:
  // Result of a row that compares two variants: their ratio, or whether the first is the larger one.
  OurNumber compared(const PublishedValue& row, const OurNumber& number) const {
    if (row.against.empty()) return number;
    const OurNumber other =
        values_of(with_settings(resolved_, row.against), {&row}, options_.result_of).front();
    const double ratio = number.value / other.value;
    if (!row.is_trend() || std::isnan(ratio)) return {ratio, "1"};
    return {number.value > other.value ? 1.0 : 0.0, "1"};
  }

  const ResolvedCase& resolved_;
  const ValidationOptions& options_;
  std::map<const PublishedValue*, ValidationRow> rows_;
};

// Effects of the other readings of a drivetrain's case on its life curve.
void put_other_readings(const ResolvedCase& resolved, const ExpectedFile& expected, int jobs,
                        ValidationTable& table) {
  const std::vector<ChangeResult> results =
      results_of(resolved, with_reference(expected.alternatives), {.jobs = jobs});
  table.sensitivities = sensitivities(results);
  put_derivatives(resolved, property(life_curve(results.front()), "peak_speed_rpm"), jobs,
                  table.sensitivities);
  for (const Sensitivity& one : table.sensitivities)
    for (const PublishedValue& published : expected.published)
      if (has_other_readings(published))
        table.other_readings.push_back(
            judged(published, property(one.curve, published.quantity), one.change.name));
}

std::vector<std::string> sorted(std::vector<std::string> texts) {
  std::sort(texts.begin(), texts.end());
  return texts;
}

// The key in REFERENCES.md with its brackets; the text itself where there is none.
std::string source_key(const std::string& source) {
  const std::size_t begin = source.find('['), end = source.find(']');
  return begin == std::string::npos || end == std::string::npos ? source
                                                                : source.substr(begin, end + 1 - begin);
}

}  // namespace

ValidationRow judged(PublishedValue published, double ours, std::string reading) {
  ValidationRow row{.published = std::move(published), .reading = std::move(reading)};
  if (std::isfinite(ours)) row.ours = ours;
  if (row.published.value && row.ours) row.deviation = *row.ours / *row.published.value - 1.0;
  row.verdict = verdict_of(row);
  return row;
}

ValidationTable validation_table_of(const ResolvedCase& resolved, const ExpectedFile& expected,
                                    const ValidationOptions& options) {
  ValidationTable table{.case_name = resolved.text("name")};
  RowsOfCase rows(resolved, options);
  for (const Variant& variant : variants_of(expected, static_cast<bool>(options.result_of)))
    rows.compute(variant);
  table.rows = rows.in_order(expected);
  if (!expected.alternatives.empty() && has_life_curve(resolved))
    put_other_readings(resolved, expected, options.jobs, table);
  return table;
}

namespace {

// Lines of rolling elements that pass follow from one formula: those of a bearing are one value, however many
// recordings show them.
constexpr const char* kPassingLines = "characteristic frequency";

double size_of_deviation(const ValidationRow* row) {
  return row->deviation ? std::abs(*row->deviation) : std::numeric_limits<double>::infinity();
}

// In place of the passing lines of a case, by kind of evidence, the one with the median deviation.
std::vector<const ValidationRow*> once_a_bearing(const std::vector<const ValidationRow*>& rows) {
  std::vector<const ValidationRow*> kept;
  std::map<EvidenceKind, std::vector<const ValidationRow*>> lines;
  for (const ValidationRow* row : rows) {
    if (row->published.of == kPassingLines)
      lines[row->published.kind].push_back(row);
    else
      kept.push_back(row);
  }
  for (auto& [kind, of_kind] : lines) {
    const auto middle = of_kind.begin() + static_cast<std::ptrdiff_t>((of_kind.size() - 1) / 2);
    std::ranges::stable_sort(of_kind, {}, size_of_deviation);
    kept.push_back(*middle);
  }
  return kept;
}

}  // namespace

ValidationCount counted(const std::vector<ValidationTable>& tables) {
  ValidationCount count;
  std::set<std::tuple<std::string, std::vector<std::string>, double>> seen;
  std::set<std::string> sources;
  for (const ValidationTable& table : tables) {
    count.comparisons_under_other_readings += static_cast<int>(table.other_readings.size());
    std::vector<const ValidationRow*> read;
    for (const ValidationRow& row : table.rows) {
      const PublishedValue& published = row.published;
      if (!published.value ||
          !seen.emplace(published.source, sorted(published.settings), *published.value).second)
        continue;
      if (published.memory)
        ++count.remembered;
      else
        read.push_back(&row);
    }
    const std::vector<const ValidationRow*> values = once_a_bearing(read);
    count.lines_of_one_formula += static_cast<int>(read.size() - values.size());
    for (const ValidationRow* row : values) {
      const PublishedValue& published = row->published;
      ++count.verdicts[std::string(described::text_of(published.kind))][row->verdict];
      if (row->verdict == "missed")
        ++count.missed[std::string(described::text_of(published.kind))][published.of];
      ++(counts(published.kind) ? count.published : count.recomputed);
      if (!counts(published.kind)) continue;
      count.trends += row->is_trend() ? 1 : 0;
      count.fitted += published.fitted ? 1 : 0;
      sources.insert(source_key(published.source));
    }
  }
  count.sources = static_cast<int>(sources.size());
  return count;
}

namespace {

// " (141 of friction)": the class of quantities with the most misses, where there are several.
std::string most_missed(const ValidationCount& count, std::string_view kind) {
  const auto missed = count.missed.find(std::string(kind));
  if (missed == count.missed.end()) return "";
  const auto most = std::ranges::max_element(missed->second, {}, [](const auto& one) { return one.second; });
  return fmt::format(" ({} of {})", most->second, most->first);
}

}  // namespace

std::string count_text(const std::vector<ValidationTable>& tables) {
  const ValidationCount count = counted(tables);
  std::string text = fmt::format(
      "\n{} distinct published values from {} sources ({} of them trends, {} that constants of their case "
      "were identified from)\n",
      count.published, count.sources, count.trends, count.fitted);
  for (const auto& [kind, name] : names_of(EvidenceKind{})) {
    const auto verdicts = count.verdicts.find(std::string(name));
    if (verdicts == count.verdicts.end()) continue;
    int all = 0;
    std::vector<std::string> parts;
    for (const char* verdict : {"reproduced", "trend", "missed", "input missing"}) {
      const auto values = verdicts->second.find(verdict);
      if (values == verdicts->second.end()) continue;
      all += values->second;
      parts.push_back(fmt::format("{} {}{}", values->second, verdict,
                                  verdict == std::string_view("missed") ? most_missed(count, name) : ""));
    }
    text += fmt::format("  {:<15} {:>4}: {}{}\n", name, all, fmt::join(parts, ", "),
                        counts(kind) ? "" : "; not counted");
  }
  if (count.remembered > 0)
    text += fmt::format("  remembered, not read: {}; not counted\n", count.remembered);
  if (count.lines_of_one_formula > 0)
    text += fmt::format("  further lines of passing elements of the same bearings: {}; not counted\n",
                        count.lines_of_one_formula);
  return text + fmt::format("{} comparisons of the same values under other readings\n",
                            count.comparisons_under_other_readings);
}

void describe(Record& record, const std::vector<ValidationTable>& tables) {
  record.table("rows", "row", "published and computed numbers", rows_of_all(tables, &ValidationTable::rows),
               describe_comparison);
  record.table("other_readings", "other_reading", "the same under other readings of the cases",
               rows_of_all(tables, &ValidationTable::other_readings), describe_comparison);
  record.table("assumptions", "assumption", "effect of each other reading",
               rows_of_all(tables, &ValidationTable::sensitivities), describe_assumption);
}

std::string validation_text(const ValidationTable& table) {
  std::string text = fmt::format("{}\n", table.case_name);
  for (const auto& [kind, name] : names_of(EvidenceKind{})) {
    bool first = true;
    for (const ValidationRow& row : table.rows) {
      const PublishedValue& published = row.published;
      if (published.kind != kind) continue;
      if (std::exchange(first, false))
        text += fmt::format("{:<24} {:>10} {:>10} {:>10} {:>10}  {:<13}  {}\n", name, "published", "ours",
                            "deviation", "tolerance", "verdict", "quantity");
      text += fmt::format("{:<24} {:>10} {:>10} {:>10} {:>10.3g}  {:<13}  {}{}\n", published.source,
                          cell(published.value), cell(row.ours), deviation_cell(row.deviation),
                          published.tolerance, row.verdict, key_with_reading(row),
                          published.memory   ? " (remembered)"
                          : published.fitted ? " (identified from)"
                                             : "");
      if (row.band)
        text += fmt::format("{:<24} inputs: {:.6g} to {:.6g} (50 %), {:.6g} to {:.6g} (90 %)\n", "",
                            row.band->low_50, row.band->high_50, row.band->low_90, row.band->high_90);
      if (row.verdict == "missed" && !published.why.empty())
        text += fmt::format("{:<24} missed: {}\n", "", published.why);
    }
  }
  return text + other_readings_text(table) + sensitivities_text(table);
}

}  // namespace orbearing::app
