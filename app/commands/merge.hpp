// `orbearing merge`: shards of a sweep become one.
#pragma once

#include "app/commands/common_options.hpp"

namespace orbearing::app {

struct MergeOptions {
  static constexpr const char* command = "merge";
  static constexpr const char* purpose = "join the shards of a sweep";
  Printing print;
  std::vector<std::string> settings;  // none are permitted
  std::vector<std::string> shards;    // folders
  std::string output;                 // folder
  int jobs = 0;                       // 0: one for each core
  bool grid_only = false;             // no points are added around the peak
};
inline void describe(OptionList& list, MergeOptions& m) {
  described::members(list, m, described::part(m.print), settings_row(m.settings),
                     option(m.shards, "DIR", "folders of the shards", {.required = true}),
                     output_row(m.output, "folder of the results; created if missing", true),
                     jobs_row(m.jobs), grid_only_row(m.grid_only));
}
std::vector<std::string> problems(const MergeOptions& options);

int execute(const MergeOptions& options);

}  // namespace orbearing::app
