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
  std::string reading;  // of the assumptions; empty: the case as it stands
  std::optional<double> published;
  std::optional<double> ours;
  std::optional<double> deviation;
  double tolerance = 0.0;
  std::string verdict;  // reproduced, trend, missed, input missing
};

/// All that `orbearing validate` says about one case.
struct Ledger {
  std::string case_name;
  std::vector<LedgerRow> rows;
  std::vector<Worth> worth;
};

/// A row with `published`, `ours` and `tolerance` filled in, with its deviation and verdict.
LedgerRow judged(LedgerRow row, bool trend);

/// Throws BadInput where the case is of a model that the ledger cannot compute.
Ledger ledger_of(const ResolvedCase& resolved, const ExpectedFile& expected);

nlohmann::ordered_json rows_json(const Ledger& ledger);
nlohmann::ordered_json worth_json(const Ledger& ledger);
std::string ledger_text(const Ledger& ledger);

}  // namespace orbearing::app
