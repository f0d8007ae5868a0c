// Mistakes in a case file or in --set: collected, sorted by place and reported all at once.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/errors.hpp"

namespace orbearing::app {

/// Location of a text: in the file, or in the n-th --set option.
struct Location {
  bool option = false;
  int line = 1;             // counted from 1; for an option, its number
  int column = 1;           // counted from 1, in characters
  std::string_view file{};  // where it is not the case's: one that the case names, whose name lasts
};

struct ConsistencyMessage {
  std::string found;
  std::string required;
};

struct Mistake {
  Location location;
  std::string path;  // "input.power"; "(file)" where no key is to blame
  ConsistencyMessage message;
};

/// One line: `FILE:LINE:COLUMN: key.path: found; required`, or `--set: key.path: found; required`. Text from
/// the user is made printable; the path is shortened.
std::string describe(const Mistake& mistake, const std::string& file);

/// Result of `change`. The lines with which it refuses a changed case name --set. Those that begin with the
/// first text of a pair, as {"--set: input.speed: ", "--speed: "}, begin with the second text instead.
template <class Change>
auto named_by_option(const std::vector<std::pair<std::string, std::string>>& names, const Change& change) {
  try {
    return change();
  } catch (const BadInput& error) {
    std::vector<std::string> lines = error.messages;
    for (std::string& line : lines)
      for (const auto& [setting, option] : names)
        if (line.starts_with(setting)) {
          line.replace(0, setting.size(), option);
          break;
        }
    throw BadInput(std::move(lines));
  }
}

/// Throws BadInput (app/errors.hpp) with one line for each mistake, in the order of the file, options last.
[[noreturn]] void throw_mistakes(const std::string& file, std::vector<Mistake> mistakes);

}  // namespace orbearing::app
