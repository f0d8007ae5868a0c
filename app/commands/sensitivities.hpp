// `orbearing sensitivities`: derivatives of a result by the numbers of the case.
#pragma once

#include "app/commands/common_options.hpp"

namespace orbearing::app {

struct SensitivitiesOptions {
  static constexpr const char* command = "sensitivities";
  static constexpr const char* purpose = "sensitivity of the life to every number of the case";
  Printing print;
  StatedCase stated;
  std::string output;           // folder; empty: nothing is written
  std::string fidelity;         // empty: that of the case's analysis
  std::string result;           // its key; empty: the governing life
  std::vector<std::string> by;  // inputs; none: all
  int jobs = 0;                 // 0: one for each core
  bool resume = false;
};
inline void describe(OptionList& list, SensitivitiesOptions& m) {
  described::members(
      list, m, described::part(m.print), described::part(m.stated),
      output_row(m.output,
                 "folder for sensitivities.csv and sensitivities.json; nothing is written without it"),
      fidelity_row(m.fidelity),
      option(m.result, "--result",
             "key of another number that run --json prints; a number within another one as "
             "displacement/radial_um; default: the life selected by life.method",
             {.type = "KEY"}),
      option(m.by, "--by",
             "only this input, repeatable: two runs for each of its numbers; default: all inputs; "
             "required in motion",
             {.type = "PATH"}),
      jobs_row(m.jobs), option(m.resume, "--resume", "if DIR holds exactly this table, show it again"));
}
std::vector<std::string> problems(const SensitivitiesOptions& options);

int execute(const SensitivitiesOptions& options);

}  // namespace orbearing::app
