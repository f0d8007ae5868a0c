// `orbearing check`: inputs and derived quantities of a case.
#pragma once

#include "app/commands/common_options.hpp"

namespace orbearing::app {

struct CheckOptions {
  static constexpr const char* command = "check";
  static constexpr const char* purpose = "print every input of a case with its value and source";
  Printing print;
  StatedCase stated;
};
inline void describe(OptionList& list, CheckOptions& m) {
  described::members(list, m, described::part(m.print), described::part(m.stated));
}

int execute(const CheckOptions& options);

}  // namespace orbearing::app
