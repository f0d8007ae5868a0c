// `orbearing table`: results over several inputs.
#pragma once

#include "app/commands/common_options.hpp"

namespace orbearing::app {

struct TableOptions {
  static constexpr const char* command = "table";
  static constexpr const char* purpose =
      "results over up to 6 inputs as a table with its error, for queries in microseconds";
  Printing print;
  StatedCase stated;
  std::string output;  // folder; empty: nothing is written
  std::string fidelity;
  bool resume = false;
  std::vector<std::string> over;     // PATH=FROM..TO
  std::vector<std::string> results;  // columns
  double bound = 0.01;               // error at which a cell is finished
  int points = 0;                    // at most; 0: the quasi-static default
  int jobs = 0;                      // 0: one for each core
};
inline void describe(OptionList& list, TableOptions& m) {
  const described::Range bounds{1e-9, 1.0}, points{1, 100000};
  described::members(
      list, m, described::part(m.print), described::part(m.stated), output_or_json_row(m.output),
      fidelity_row(m.fidelity), option(m.resume, "--resume", "continue in DIR with the missing points"),
      option(m.over, "--over",
             "input and its range, e.g. --over \"input.speed=1000 rpm..6000 rpm\"; repeatable, at most 6 "
             "inputs; default: the ranges of the case's sweep",
             {.type = "PATH=FROM..TO"}),
      option(m.results, "--result",
             "column of a sweep's table, repeatable; default: the life selected by life.method",
             {.type = "KEY"}),
      option(m.bound, "--bound", "largest error of an answer from the table; default: 0.01 (1 %)",
             {.range = bounds}),
      option(m.points, "--points",
             "largest number of computed points; default: 50000 quasi-static, required in motion",
             {.range = points}),
      jobs_row(m.jobs));
}
std::vector<std::string> problems(const TableOptions& options);

int execute(const TableOptions& options);

}  // namespace orbearing::app
