// Folders of results, as commands with --output write them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "orbearing/errors.hpp"

namespace orbearing {

/// Names of files in each: the points that are done, line by line, and the case that was run.
inline constexpr const char* manifest_name = "manifest.jsonl";
inline constexpr const char* resolved_case_name = "case.resolved.yaml";

struct ResultsInBrief {
  std::string case_name;
  std::string fidelity;    // of a sweep; else the name of the analysis
  std::size_t points = 0;  // that are done
  std::size_t of = 0;      // points in all; of a sweep that refines its peak those known so far
};

/// Throws BadInput where the folder holds no results.
ResultsInBrief results_in_brief(const std::filesystem::path& folder);

/// Throws BadInput where the case in the folder is not the one that was run.
void require_case_of_results(const std::filesystem::path& folder);

/// All that the folder holds as a JSON object: "fidelity", "finished", and of a sweep "missing", the "points"
/// as in `sweep --json`, where all are there the "result" as --json prints it, else the "options" that
/// continue it; of another analysis the "result", null where the folder does not hold it. Throws as
/// require_case_of_results().
std::string results_json(const std::filesystem::path& folder);

}  // namespace orbearing
