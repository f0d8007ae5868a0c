// The validation table: every published number beside ours.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/case/uncertain_case.hpp"
#include "app/study/sensitivity.hpp"

namespace orbearing::app {

/// Distribution of our number when the case's uncertain inputs take their distributions.
struct ValidationBand {
  double low_90 = 0.0, low_50 = 0.0, high_50 = 0.0, high_90 = 0.0;  // ends of the middle 90 % and 50 %
  int samples = 0;                                                  // that gave a number
  int lost = 0;                                                     // that gave none
};

/// One comparison. `deviation` is relative.
struct ValidationRow {
  PublishedValue published;
  std::string reading;  // settings of the case; empty: the unchanged case
  std::optional<double> ours;
  std::optional<double> deviation;
  std::string unit{};   // of the numbers; empty: not known
  std::string verdict;  // reproduced, trend, missed, input missing
  std::optional<ValidationBand> band{};

  bool is_trend() const { return published.is_trend(); }
};

/// Results of `orbearing validate` for one case.
struct ValidationTable {
  std::string case_name;
  std::vector<ValidationRow> rows;            // each published value once
  std::vector<ValidationRow> other_readings;  // the same values again, the case under another of its readings
  std::vector<Sensitivity> sensitivities;
};

/// Number of values compared, whatever the number of rows and cases that contain them: rows of one source,
/// one value and one set of settings count once. Remembered values, formulas and recomputed values are none
/// of the published ones.
struct ValidationCount {
  std::map<std::string, std::map<std::string, int>>
      verdicts;  // of values read, by kind of evidence and verdict
  std::map<std::string, std::map<std::string, int>>
      missed;          // those that are missed, by kind of evidence and class of the quantity
  int published = 0;   // numbers and trends that a source prints
  int trends = 0;      // among them
  int fitted = 0;      // among them: from which constants of their case were identified
  int recomputed = 0;  // numbers that follow from a source's formulas or data
  int remembered = 0;
  int lines_of_one_formula = 0;  // of passing elements, besides the one that counts for each bearing
  int sources = 0;               // of `published`
  int comparisons_under_other_readings = 0;
};

/// Output of a command with --json for a case at a fidelity. Throws BadInput and ComputationFailed.
using ResultOf = std::function<nlohmann::ordered_json(const std::string& command, const std::string& fidelity,
                                                      const ResolvedCase& resolved)>;

struct ValidationOptions {
  int jobs = 0;          // threads for the other readings; 0: one for each core
  ResultOf result_of{};  // none: rows of the quantity COMMAND:/json/pointer are left out
  int samples = 0;       // of the uncertain inputs, for the bands of measured rows; 0: no bands
  std::uint64_t seed = 1;
};

/// A row with its deviation and verdict. `ours`: NaN where the project has no such number.
ValidationRow judged(PublishedValue published, double ours, std::string reading = "");

/// Throws BadInput where the case is of a model that the table cannot compute.
ValidationTable validation_table_of(const ResolvedCase& resolved, const ExpectedFile& expected,
                                    const ValidationOptions& options = {});

ValidationCount counted(const std::vector<ValidationTable>& tables);
std::string count_text(const std::vector<ValidationTable>& tables);

/// `rows`, `other_readings` and `assumptions`.
void describe(described::Record& record, const std::vector<ValidationTable>& tables);
std::string validation_text(const ValidationTable& table);

}  // namespace orbearing::app
