// `orbearing validate`: published numbers beside those of the program.
#pragma once

#include "app/commands/common_options.hpp"

namespace orbearing::app {

struct ValidateOptions {
  static constexpr const char* command = "validate";
  static constexpr const char* purpose = "compare published numbers with those of the program";
  Printing print;
  std::vector<std::string> settings;  // path=value
  std::vector<std::string> cases;     // none: all that ship
  bool motion = false;                // only the effects of assumptions in motion
  int samples = 0;                    // of uncertain inputs, for the bands of measured rows
  int jobs = 0;                       // 0: one for each core
};
inline void describe(OptionList& list, ValidateOptions& m) {
  described::members(
      list, m, described::part(m.print), settings_row(m.settings),
      option(m.cases, "CASE", "case files or folders; default: all cases supplied with the program"),
      option(m.motion, "--motion",
             "instead of published numbers: change of life at the peak by the assumptions that affect "
             "only motion; takes minutes"),
      option(m.samples, "--samples",
             "samples of each case's uncertain inputs for the bands of measured rows; default: 0, no bands",
             {.range = described::Range{0, 1000000}}),
      jobs_row(m.jobs));
}

int execute(const ValidateOptions& options);

}  // namespace orbearing::app
