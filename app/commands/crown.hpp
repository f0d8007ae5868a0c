// `orbearing crown`: the crowning study of a planet bearing.
#pragma once

#include "app/commands/common_options.hpp"
#include "app/study/crown/crown_options.hpp"

namespace orbearing::app {

struct CrownOptions {
  static constexpr const char* command = "crown";
  static constexpr const char* purpose =
      "roller crowning study: life and pressure over the crown drop, recommended drop";
  Printing print;
  StatedCase stated;
  std::string output;  // folder; empty: nothing is written
  CrownChoices choices;
  int jobs = 0;  // 0: one for each core
  bool resume = false;
};
inline void describe(OptionList& list, CrownOptions& m) {
  described::members(list, m, described::part(m.print), described::part(m.stated),
                     output_or_json_row(m.output), described::part(m.choices), jobs_row(m.jobs),
                     option(m.resume, "--resume", "if DIR holds exactly this study, show its results again"));
}
std::vector<std::string> problems(const CrownOptions& options);

int execute(const CrownOptions& options);

}  // namespace orbearing::app
