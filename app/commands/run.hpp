// `orbearing run`: one operating point.
#pragma once

#include "app/commands/common_options.hpp"

namespace orbearing::app {

struct RunOptions {
  static constexpr const char* command = "run";
  static constexpr const char* purpose = "compute the case at its operating point";
  Printing print;
  StatedCase stated;
  std::string output;    // folder; empty: nothing is written
  std::string fidelity;  // empty: that of the case's analysis
  bool resume = false;
  std::string budget;  // processor time; empty: any
  bool gears = false;  // without the dynamics of bearings
};
inline void describe(OptionList& list, RunOptions& m) {
  described::members(
      list, m, described::part(m.print), described::part(m.stated), output_or_json_row(m.output),
      fidelity_row(m.fidelity), option(m.resume, "--resume", "continue in DIR with the missing points"),
      budget_row(m.budget),
      option(m.gears, "--gears",
             "vibration of the gears only, with bearings as springs; default for a case without a bearing"));
}
std::vector<std::string> problems(const RunOptions& options);

int execute(const RunOptions& options);

}  // namespace orbearing::app
