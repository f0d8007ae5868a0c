// Rows as text: lines of sweep.csv, JSON objects. Numbers are the shortest that read back to the same bits.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/results/result_row.hpp"

namespace orbearing::app {

/// Lines of RFC 4180, ended by "\n". A missing value is an empty field.
std::string csv_head(const TableHead& head);
std::string csv_line(const TableHead& head, const ResultRow& row);

/// The row as part of a record; a missing value is absent.
void describe_row(described::Record& record, const TableHead& head, const ResultRow& row);

/// Object with a key per column; a missing value is null.
nlohmann::ordered_json row_json(const TableHead& head, const ResultRow& row);

/// The row that `row_json` wrote. Throws nlohmann::json::exception where a key is missing or of another type.
ResultRow row_from_json(const TableHead& head, const nlohmann::ordered_json& object);

}  // namespace orbearing::app
