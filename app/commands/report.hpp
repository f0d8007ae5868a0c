// `orbearing report`: the page of a folder of results.
#pragma once

#include "app/commands/common_options.hpp"

namespace orbearing::app {

struct ReportOptions {
  static constexpr const char* command = "report";
  static constexpr const char* purpose = "write DIR/report.html, and DIR/report.pdf with --pdf";
  Printing print;
  bool pdf = false;            // the assessor's page as well
  bool data_only = false;      // the result is the data of the page, and no page is drawn
  std::string bearing_points;  // instead of that, these points of the bearing, as the page requests them
  std::vector<std::string> settings;  // none are permitted
  std::string folder;                 // of a run or sweep
  std::string other;                  // of the branch to draw as well
  bool every_effect = false;          // of the motion in time
};
inline void describe(OptionList& list, ReportOptions& m) {
  described::members(
      list, m, described::part(m.print),
      option(m.pdf, "--pdf",
             "also write DIR/report.pdf: at most 8 pages of ratings, lives and verdicts for an assessor"),
      option(m.data_only, "--data-only", "what the page is made of, and no page", {.hidden = true}),
      option(m.bearing_points, "--bearing-points", "points that the page requests", {.hidden = true}),
      settings_row(m.settings), option(m.folder, "DIR", "folder of a run or sweep", {.required = true}),
      option(m.other, "--with",
             "folder of the same sweep, continued in the other direction: both branches are drawn",
             {.type = "DIR2"}),
      option(m.every_effect, "--every-effect",
             "of a dynamic sweep: effect of every model term, not only of the main ones; takes minutes"));
}
std::vector<std::string> problems(const ReportOptions& options);

int execute(const ReportOptions& options);

}  // namespace orbearing::app
