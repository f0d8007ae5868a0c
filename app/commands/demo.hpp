// `orbearing demo`: a sweep and its report.
#pragma once

#include "app/commands/common_options.hpp"

namespace orbearing::app {

struct DemoOptions {
  static constexpr const char* command = "demo";
  static constexpr const char* purpose = "life over speed of a 150 kW reducer with its report, in about 10 s";
  Printing print;
  std::string output;  // folder; empty: one that does not exist yet
};
inline void describe(OptionList& list, DemoOptions& m) {
  described::members(list, m, described::part(m.print),
                     output_row(m.output,
                                "folder of the results; created if missing. Default: orbearing-demo, or "
                                "orbearing-demo-2, -3 ... if that exists"));
}

int execute(const DemoOptions& options);

}  // namespace orbearing::app
