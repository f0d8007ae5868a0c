// `orbearing signals`: labelled signals of scratched bearings.
#pragma once

#include "app/commands/common_options.hpp"

namespace orbearing::app {

struct SignalsOptions {
  static constexpr const char* command = "signals";
  static constexpr const char* purpose = "labelled vibration signals of scratched bearings";
  Printing print;
  StatedCase stated;
  std::string output;                       // folder; empty: nothing is written
  std::vector<std::string> varied;          // path=[value, value]
  std::string fidelity = kDefaultFidelity;  // or "dynamic"
  double noise = 0.0;                       // [m/s^2]  root mean square
  std::uint64_t seed = 1;                   // of the noise
  int jobs = 0;                             // 0: one for each core
  bool resume = false;
};
inline void describe(OptionList& list, SignalsOptions& m) {
  described::members(
      list, m, described::part(m.print), described::part(m.stated), output_or_json_row(m.output),
      option(m.varied, "--vary",
             "path=[value, value]: input that is varied from signal to signal; repeatable, all "
             "combinations; default: defect.race, all elements that can be scratched",
             {.type = "PATH=[...]"}),
      option(m.fidelity, "--fidelity",
             "quasi-static (default): the ring on balls without mass; dynamic: the whole bearing in motion",
             {.choices = {"quasi-static", "dynamic"}}),
      option(m.noise, "--noise", "noise of the instrument, root mean square [m/s2]; default: none"),
      option(m.seed, "--seed", "seed of the noise; default: 1", {.needs = "--noise"}), jobs_row(m.jobs),
      option(m.resume, "--resume", "continue in DIR with the missing signals"));
}
std::vector<std::string> problems(const SignalsOptions& options);

int execute(const SignalsOptions& options);

}  // namespace orbearing::app
