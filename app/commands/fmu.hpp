// `orbearing fmu`: the model for other simulation tools.
#pragma once

#include "app/commands/common_options.hpp"

namespace orbearing::app {

struct FmuOptions {
  static constexpr const char* command = "fmu";
  static constexpr const char* purpose =
      "export the planet bearing or the gear set for other simulation tools (FMI 2.0, 3.0)";
  Printing print;
  StatedCase stated;
  std::string output;             // file
  std::string fmi = "2";          // version of the interface
  std::string model = "bearing";  // or "gearset"
  bool windows = false;           // the library for Windows as well
};
inline void describe(OptionList& list, FmuOptions& m) {
  described::members(
      list, m, described::part(m.print), described::part(m.stated),
      option(m.output, "-o,--output",
             "file of the FMU; FILE.ssp: a package of gear set, bearings and parameters (SSP 1.0). An "
             "existing file is replaced",
             {.type = "FILE.fmu", .required = true}),
      option(m.fmi, "--fmi", "version of the interface: 2 (default) or 3", {.choices = {"2", "3"}}),
      option(m.model, "--model",
             "bearing (default): one bearing of one planet; gearset: the gears without their planet bearings",
             {.choices = {"bearing", "gearset"}}),
      option(m.windows, "--windows",
             "add the library for Windows to that for Linux. The first use builds it, which takes as long "
             "as a large part of the program: 5 to 20 minutes"));
}
std::vector<std::string> problems(const FmuOptions& options);

int execute(const FmuOptions& options);

}  // namespace orbearing::app
