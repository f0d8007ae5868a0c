#include "app/commands/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <optional>
#include <sstream>
#include <system_error>

#include "app/commands/python_part.hpp"
#include "app/errors.hpp"
#include "app/options/option_words.hpp"
#include "app/results/durable_file.hpp"
#include "app/results/progress.hpp"
#include "app/standard_error.hpp"
#include "app/version.hpp"
#include "mechanics/cancellation.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

constexpr int kDone = 0;
constexpr int kFailed = 1;
constexpr int kBadInput = 2;

// Named here so that the help lists them; what follows their names is theirs to read.
void add_python_commands(CLI::App& program) {
  for (const PythonCommand& command : python_commands())
    program.add_subcommand(command.name, command.purpose)->prefix_command();
}

// The name of a command that does not exist is reported as such and not as a missing command.
void require_known_command(const CLI::App& program, const std::string& word) {
  if (word.empty() || word.front() == '-') return;
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
  if (std::ranges::find(names, word) == names.end()) refuse_command(word, names);
}

// Names and values of the user's go into JSON, CSV and messages, all of them UTF-8.
void require_utf8(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    const std::size_t byte = first_byte_not_utf8(word);
    if (byte == word.size()) continue;
    const bool setting = std::string_view(argv[i - 1]) == "--set" || word.starts_with("--set=");
    throw BadInput(fmt::format("{}: found {}, whose byte {} is not UTF-8; required: text in UTF-8",
                               setting ? "--set" : fmt::format("argument {}", i), quote(word), byte + 1));
  }
}

// Line by line, so that text from the user in a message cannot move the cursor.
void print_error(std::string_view text) {
  for (bool more = true; more;) {
    const std::size_t end = text.find('\n');
    more = end != std::string_view::npos;
    print_to_standard_error("{}\n", printable(text.substr(0, end)));
    if (more) text.remove_prefix(end + 1);
  }
}

// The program of all commands, each with options of its own.
class Reader {
 public:
  Reader() : requests_(all_commands()) {
    program_.set_version_flag("--version", std::string(program_version));
    program_.require_subcommand(1);
    for (CommandRequest& request : requests_)
      add_options(*program_.add_subcommand(name_of(request), purpose_of(request)), option_list(request));
    program_.failure_message([this](const CLI::App*, const CLI::Error& error) {
      return error.what() + proposals() + "\nRun with --help for more information.\n";
    });
  }

  CLI::App& program() { return program_; }

  /// A line for each option that was not expected and resembles one of its command.
  std::string proposals() {
    std::string lines;
    for (const CLI::App* command : program_.get_subcommands())
      for (const std::string& word : command->remaining())
        lines += proposal(word, option_list(request_of(*command)));
    return lines;
  }

  /// Command and options of the words that the program has parsed.
  CommandRequest request() {
    const CLI::App& command = *program_.get_subcommands().front();
    CommandRequest& request = request_of(command);
    put_words(command, option_list(request));
    return request;
  }

 private:
  CommandRequest& request_of(const CLI::App& command) {
    return *std::ranges::find(requests_, command.get_name(), name_of);
  }

  std::vector<CommandRequest> requests_;
  CLI::App program_{"Orbearing: planet bearings inside planetary drivetrains", "orbearing"};
};

// Help, the version, or what is wrong with the words. Returns the exit code.
int print_answer(const CLI::App& program, const CLI::ParseError& error) {
  // Not into the streams themselves: they flush, and the reason of a full disk would be lost.
  std::ostringstream answer;
  if (program.exit(error, answer, answer) != 0) {
    const std::string text = answer.str();
    print_error(text.substr(0, text.find_last_not_of('\n') + 1));
    return kBadInput;
  }
  fmt::print("{}", answer.str());
  return kDone;
}

int parse_and_run(int argc, char** argv) {
  require_utf8(argc, argv);
  Reader reader;
  add_python_commands(reader.program());
  require_known_command(reader.program(), argc > 1 ? argv[1] : "");
  hand_over(argc, argv);
  std::optional<CommandRequest> request;
  try {
    reader.program().parse(argc, argv);
    request = reader.request();
  } catch (const CLI::ParseError& error) {
    return print_answer(reader.program(), error);
  }
  return execute(*request);
}

// Flushes the output: a full disk is reported here and not by the print functions.
void require_printed() {
  // First of all, since the stream of the standard library flushes it too and gives no reason.
  errno = 0;
  const bool whole = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  const int error = whole ? 0 : errno;
  if (whole && std::cout.flush()) return;
  std::clearerr(stdout);
  std::cout.clear();
  throw WriteFailed(fmt::format("standard output: cannot be written{}{}", error == 0 ? "" : ": ",
                                error == 0 ? "" : std::strerror(error)),
                    remedy_of(error));
}

}  // namespace

CommandRequest request_of_words(const std::vector<std::string>& words) {
  Reader reader;
  require_known_command(reader.program(), words.empty() ? "" : words.front());
  try {
    reader.program().parse(std::vector<std::string>(words.rbegin(), words.rend()));
    return reader.request();
  } catch (const CLI::ParseError& error) {
    throw BadInput(error.what() + reader.proposals());
  }
}

int run_command_line(int argc, char** argv) {
  const Interruption interruption;
  // A file grown beyond the user's limit is an error of the write then, which cleans up, not the end.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    const int code = parse_and_run(argc, argv);
    require_printed();
    return code;
  } catch (const BadInput& error) {
    for (const std::string& line : error.messages) print_error(line);
    return kBadInput;
  } catch (const ComputationFailed& error) {
    print_error(error.what());
    return kFailed;
  } catch (const std::system_error& error) {
    if (std::ferror(stdout) != 0)
      print_to_standard_error("standard output: {}; {}, then give the command again\n", error.what(),
                              remedy_of(error.code().value()));
    else
      print_to_standard_error("orbearing: {}\n", error.what());
    return kFailed;
  } catch (const std::exception& error) {
    print_error(std::string("orbearing: ") + error.what());
    return kFailed;
  } catch (const Cancelled& wish) {
    print_to_standard_error("orbearing: {}\n", wish.what());
    return kFailed;
  }
}

}  // namespace orbearing::app
