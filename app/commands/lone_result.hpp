// What the analyses of a single part, which give one result and no sweep, compute, write and print alike.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/commands/command_line.hpp"
#include "app/results/manifest.hpp"
#include "app/results/point_content.hpp"
#include "app/results/record_writers.hpp"

namespace orbearing::app {

/// How results of an analysis are named.
struct LoneAnalysis {
  const char* fidelity;             // in the manifest
  const char* title;                // of the netCDF file
  const char* json_file = nullptr;  // of the folder, which holds what --json prints; null: none
};

struct LoneResult {
  nlohmann::ordered_json json;  // of the analysis itself
  std::string text;             // the same for terminals
  PointContent content;         // the same as arrays
  std::vector<std::string> warnings;
  std::vector<std::pair<std::string, double>> row{};         // what the table of a sweep has columns for
  std::vector<std::pair<std::string, std::string>> files{};  // of the folder besides: name, content
  std::string status = "ok";                                 // that the netCDF file gives
  bool failed = false;                                       // in parts
  nlohmann::ordered_json units{};                            // by key
};

/// The forms of a record: what the table of a sweep has columns for, and tables with files of their own.
LoneResult recorded_result(const Record& record, std::vector<std::string> warnings);
template <class Result>
LoneResult described_result(const Result& result, std::vector<std::string> warnings) {
  return recorded_result(record_of(result), std::move(warnings));
}

/// Opens the folder that the options name, computes, keeps what is not kept yet and prints. Returns the exit
/// code.
int run_alone(const ResolvedCase& resolved, const Options& options, const LoneAnalysis& analysis,
              const std::function<LoneResult()>& compute);

/// Bytes of the netCDF file of a result called `what`.
std::string lone_result_file(const ManifestHeader& header, const char* what, PointContent content,
                             const std::string& status = "ok");

/// Prints `object`, or `text` with the object's warnings, as the options ask.
void present_lone_result(const nlohmann::ordered_json& object, const std::string& text,
                         const Options& options);

/// The same of a record by itself, with the case's name and the units; `more` follows its text.
void present_record(const ResolvedCase& resolved, const Record& record,
                    const std::vector<std::string>& warnings, const Options& options,
                    const std::string& more = "");

/// A row of the table of a sweep that has these values [in the columns' units]; all else stays empty.
ResultRow lone_row(const TableHead& head, const std::vector<std::pair<std::string, double>>& values = {});

/// The warnings of one and then of the other.
std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& second);

}  // namespace orbearing::app
