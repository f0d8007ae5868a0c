// `orbearing stiffness`: matrices for rotor dynamics.
#pragma once

#include "app/commands/common_options.hpp"

namespace orbearing::app {

struct StiffnessOptions {
  static constexpr const char* command = "stiffness";
  static constexpr const char* purpose =
      "5 x 5 stiffness of a bearing over speed and load, for rotor dynamics";
  Printing print;
  StatedCase stated;
  std::string output;  // folder; empty: nothing is written
  bool resume = false;
};
inline void describe(OptionList& list, StiffnessOptions& m) {
  described::members(list, m, described::part(m.print), described::part(m.stated),
                     output_or_json_row(m.output),
                     option(m.resume, "--resume", "if DIR holds exactly this table, show it again"));
}
std::vector<std::string> problems(const StiffnessOptions& options);

int execute(const StiffnessOptions& options);

}  // namespace orbearing::app
