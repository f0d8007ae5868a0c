// Options that commands share, and rows of those that several have.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/options/option.hpp"
#include "mechanics/record.hpp"

namespace orbearing::app {

/// Functions of a caller in the same process, instead of the standard streams.
struct Receiver {
  std::function<void(const nlohmann::ordered_json& object)> result{};
  std::function<void(const std::string& line)> failures{};         // the line about points that failed
  std::function<void(const nlohmann::ordered_json& row)> point{};  // each point of a sweep as it ends
  std::function<void(const described::Record& record)> record{};   // of the result
};

/// How a result is printed, and to whom.
struct Printing {
  bool json = false;   // as one object
  bool quiet = false;  // errors only
  Receiver to{};
};
inline void describe(OptionList& list, Printing& m) {
  described::members(list, m, option(m.json, "--json", "print only the result, as one JSON object"),
                     option(m.quiet, "--quiet", "print errors only"), described::apart(m.to));
}

/// A case with changes of its inputs.
struct StatedCase {
  std::string file;
  std::vector<std::string> settings;    // path=value
  std::optional<ResolvedCase> given{};  // by a caller in the same process, instead of file and settings
};
Option settings_row(std::vector<std::string>& settings, const std::string& needs = {});
inline void describe(OptionList& list, StatedCase& m) {
  described::members(list, m, option(m.file, "CASE", "case file", {.required = true}),
                     settings_row(m.settings), described::apart(m.given));
}

/// Folder of the results.
struct ResultPlace {
  std::string folder;   // empty: nothing is written
  bool resume = false;  // continues in that folder
};
Option output_row(std::string& folder, const char* meaning = "folder of the results; created if missing",
                  bool required = false);
/// The same where --json does without.
Option output_or_json_row(std::string& folder);
/// Mistakes of a place where a result is printed alone with --json only.
std::vector<std::string> problems(const ResultPlace& place, const Printing& print);

/// Fidelity of analyses that distinguish it, where none is named.
inline constexpr const char* kDefaultFidelity = "quasi-static";
inline std::string fidelity_or_default(const std::string& named) {
  return named.empty() ? kDefaultFidelity : named;
}
Option fidelity_row(std::string& fidelity, const std::string& needs = {});

Option jobs_row(int& jobs, const std::string& needs = {});
Option budget_row(std::string& budget);
Option grid_only_row(bool& grid_only);

}  // namespace orbearing::app
