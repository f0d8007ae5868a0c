// Commands whose work, or a part of it, is done by the Python package.
#pragma once

#include <string>
#include <vector>

namespace orbearing::app {

/// Exit code of a child that did not start.
inline constexpr int not_started = 127;

/// Runs `python3 -m MODULE ARGUMENTS...` and waits for it; a signal to both is left to the child. Returns its
/// exit code, 128 + the signal that ended it, or `not_started`.
int run_python(const std::string& module, const std::vector<std::string>& arguments);

/// A command that the package has for itself.
struct PythonCommand {
  const char* name;
  const char* purpose;
  const char* module;
};
const std::vector<PythonCommand>& python_commands();

/// Runs Python in this process if the first argument names one of these, with the other arguments: signals to
/// the number of the process reach the computation. Throws ComputationFailed where it cannot be started;
/// returns for other commands.
/// for other commands.
void hand_over(int argc, char** argv);

}  // namespace orbearing::app
