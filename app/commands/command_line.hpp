// The command line: which command, with which options, and how it ended.
#pragma once

#include <string>
#include <vector>

#include "app/commands/commands.hpp"

namespace orbearing::app {

/// Command and options of the words behind the program's name. Throws BadInput where no command takes them.
CommandRequest request_of_words(const std::vector<std::string>& words);

/// Exit code: 0 done; 1 the computation failed, wholly or at some points; 2 bad input or usage.
int run_command_line(int argc, char** argv);

}  // namespace orbearing::app
