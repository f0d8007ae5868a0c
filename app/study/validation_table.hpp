// The validation table: every published number beside ours.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/study/sensitivity.hpp"

namespace orbearing::app {

/// One comparison. `deviation` is relative.
struct ValidationRow {
  std::string source;
  std::string quantity;
  std::string reading;  // settings of the case; empty: the case as it stands
  std::optional<double> published;
  std::optional<double> ours;
  std::optional<double> deviation;
  double tolerance = 0.0;
  std::string verdict;  // reproduced, trend, missed, input missing
  Evidence evidence = Evidence::published;
  bool trend = false;  // only a direction is claimed
};

/// All that `orbearing validate` says about one case.
struct ValidationTable {
  std::string case_name;
  std::vector<ValidationRow> rows;            // each published value once
  std::vector<ValidationRow> other_readings;  // the same values again, the case under another of its readings
  std::vector<Sensitivity> sensitivities;
};

/// How many values were compared, however many rows they stand in.
struct ValidationCount {
  int published = 0;   // numbers and trends that a source prints
  int trends = 0;      // among them
  int recomputed = 0;  // numbers that follow from a source's data by scripts of others
  int comparisons_under_other_readings = 0;
};

/// A row with `published`, `ours` and `tolerance` filled in, with its deviation and verdict.
ValidationRow judged(ValidationRow row, bool trend);

/// Throws BadInput where the case is of a model that the table cannot compute.
/// @param jobs threads for the other readings; 0: one for each core
ValidationTable validation_table_of(const ResolvedCase& resolved, const ExpectedFile& expected, int jobs = 0);

/// Values that several tables share, as those of copies of a case, count once for each case's name.
ValidationCount counted(const std::vector<ValidationTable>& tables);
std::string count_text(const std::vector<ValidationTable>& tables);

nlohmann::ordered_json rows_json(const ValidationTable& table);
nlohmann::ordered_json other_readings_json(const ValidationTable& table);
nlohmann::ordered_json sensitivities_json(const ValidationTable& table);
std::string validation_text(const ValidationTable& table);

}  // namespace orbearing::app
