// `orbearing new`: a case file to begin from.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/commands/common_options.hpp"
#include "orbearing/templates.hpp"

namespace orbearing::app {

struct NewOptions {
  static constexpr const char* command = "new";
  static constexpr const char* purpose = "write a commented case file as a start";
  Printing print;
  std::string template_name;
  std::string file;
};
inline void describe(OptionList& list, NewOptions& m) {
  described::members(list, m, described::part(m.print),
                     option(m.template_name, "TEMPLATE", fmt::format("{}", fmt::join(template_names(), ", ")),
                            {.required = true, .key = "template"}),
                     option(m.file, "FILE", "new case file; an existing file is not changed",
                            {.required = true, .key = "file"}));
}

int execute(const NewOptions& options);

}  // namespace orbearing::app
