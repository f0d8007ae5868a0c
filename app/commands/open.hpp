// `orbearing open`: the page in a browser.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/commands/common_options.hpp"
#include "orbearing/templates.hpp"

namespace orbearing::app {

struct OpenOptions {
  static constexpr const char* command = "open";
  static constexpr const char* purpose = "open the page with forms, figures and variants in a browser";
  Printing print;
  std::string opened;  // case, template or folder of results; empty: the page offers them
  bool no_browser = false;
  int port = 0;         // 0: one that is free
  int linger = 60;      // [s]  after the last page has gone
  bool worker = false;  // answers the requests of a page's server
};
inline void describe(OptionList& list, OpenOptions& m) {
  const described::Range seconds{1, 3600}, ports{1, 65535};
  described::members(
      list, m, described::part(m.print),
      option(m.opened, "WHAT",
             fmt::format("case file, folder of results, or template ({}); default: the page offers these",
                         fmt::join(template_names(), ", ")),
             {.type = "CASE|TEMPLATE|DIR"}),
      option(m.no_browser, "--no-browser", "print the address of the page and do not open a browser"),
      option(m.port, "--port", "port on the loopback address; default: any free port", {.range = ports}),
      option(m.linger, "--linger", "", {.range = seconds, .hidden = true}),
      option(m.worker, "--worker", "", {.hidden = true}));
}

int execute(const OpenOptions& options);

}  // namespace orbearing::app
