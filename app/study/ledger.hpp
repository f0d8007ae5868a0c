// The validation ledger: every published number beside ours.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/study/worth.hpp"

namespace orbearing::app {

/// One comparison. `deviation` is relative.
struct LedgerRow {
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
struct Ledger {
  std::string case_name;
  std::vector<LedgerRow> rows;            // each published value once
  std::vector<LedgerRow> other_readings;  // the same values again, the case under another of its readings
  std::vector<Worth> worth;
};

/// How many values were compared, however many rows they stand in.
struct LedgerCount {
  int published = 0;   // numbers and trends that a source prints
  int trends = 0;      // among them
  int recomputed = 0;  // numbers that follow from a source's data by scripts of others
  int comparisons_under_other_readings = 0;
};

/// A row with `published`, `ours` and `tolerance` filled in, with its deviation and verdict.
LedgerRow judged(LedgerRow row, bool trend);

/// Throws BadInput where the case is of a model that the ledger cannot compute.
Ledger ledger_of(const ResolvedCase& resolved, const ExpectedFile& expected);

/// Values that several ledgers share, as those of copies of a case, count once for each case's name.
LedgerCount counted(const std::vector<Ledger>& ledgers);
std::string count_text(const std::vector<Ledger>& ledgers);

nlohmann::ordered_json rows_json(const Ledger& ledger);
nlohmann::ordered_json other_readings_json(const Ledger& ledger);
nlohmann::ordered_json worth_json(const Ledger& ledger);
std::string ledger_text(const Ledger& ledger);

}  // namespace orbearing::app
