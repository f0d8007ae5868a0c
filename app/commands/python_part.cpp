#include "app/commands/python_part.hpp"

#include <fmt/core.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "app/errors.hpp"
#include "app/resources.hpp"

namespace orbearing::app {

namespace {

// Signals from the terminal reach both; the child reports the result of its work.
class LeftToTheChild {
 public:
  LeftToTheChild() : interrupt_(std::signal(SIGINT, SIG_IGN)), terminate_(std::signal(SIGTERM, SIG_IGN)) {}
  LeftToTheChild(const LeftToTheChild&) = delete;
  LeftToTheChild& operator=(const LeftToTheChild&) = delete;
  ~LeftToTheChild() { give_back(); }
  void give_back() const {
    std::signal(SIGINT, interrupt_);
    std::signal(SIGTERM, terminate_);
  }

 private:
  void (*interrupt_)(int);
  void (*terminate_)(int);
};

// Runs the module that its first argument names as `python3 -m` does, yet without the working folder among
// the folders where Python finds modules: a file json.py in it must not be run. (The option -P does the same
// from Python 3.11 on.)
constexpr const char* start_isolated =
    "import sys\n"
    "sys.path[:] = [place for place in sys.path if place]\n"
    "import runpy\n"
    "sys.argv[:] = sys.argv[1:]\n"
    "runpy.run_module(sys.argv[0], run_name='__main__', alter_sys=True)\n";

// Puts the interpreter in this process's place; comes back only where it cannot be started.
void become_python(const std::string& module, const std::vector<std::string>& arguments) {
  const std::string interpreter = resources().interpreter.string(), package = resources().package.string();
  // By its first argument Python finds its packages: a bare name would lead to another on the PATH, as that
  // of a virtual environment.
  std::vector<std::string> words{interpreter, "-c", start_isolated, module};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  setenv("PYTHONPATH", package.c_str(), 1);
  setenv("PYTHONSAFEPATH", "1", 1);  // of interpreters that this one starts
  unsetenv("PYTHONHOME");
  execv(interpreter.c_str(), pointers.data());
}

}  // namespace

int run_python(const std::string& module, const std::vector<std::string>& arguments) {
  const LeftToTheChild signals;
  const pid_t child = fork();
  if (child == 0) {
    signals.give_back();
    become_python(module, arguments);
    _exit(not_started);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : 1;
}

const std::vector<PythonCommand>& python_commands() {
  static const std::vector<PythonCommand> all{
      {"study", "compute many variants of a case on one or several machines, into one file",
       "orbearing.studies"},
      {"uncertainty", "uncertainty of the life: its band, and which input to measure first",
       "orbearing.uncertainties"},
      {"convert", "convert a REXS file of another gearbox program to cases, and write results back into it",
       "orbearing.rexs"}};
  return all;
}

void hand_over(int argc, char** argv) {
  if (argc < 2) return;
  for (const PythonCommand& command : python_commands())
    if (command.name == std::string(argv[1])) {
      become_python(command.module, {argv + 2, argv + argc});
      throw ComputationFailed(fmt::format(
          "{}: {} is required, with numpy, xarray and netCDF4 (Debian: python3-numpy python3-xarray "
          "python3-netcdf4)",
          command.name, resources().interpreter.string()));
    }
}

}  // namespace orbearing::app
