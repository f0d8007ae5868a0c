#include "app/commands/commands.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/errors.hpp"

namespace orbearing::app {

namespace {

template <class... Options>
std::vector<CommandRequest> each_of(const std::variant<Options...>&) {
  return {Options{}...};
}

}  // namespace

std::vector<CommandRequest> all_commands() {
  return each_of(CommandRequest());
}

CommandRequest command_called(const std::string& name) {
  std::vector<std::string> names;
  for (CommandRequest& request : all_commands()) {
    names.push_back(name_of(request));
    if (names.back() == name) return std::move(request);
  }
  refuse_command(name, names);
}

void refuse_command(const std::string& name, const std::vector<std::string>& commands) {
  throw BadInput(
      fmt::format("orbearing: found the command {}; required: {}", name, fmt::join(commands, ", ")));
}

std::string name_of(const CommandRequest& request) {
  return std::visit([](const auto& options) { return options.command; }, request);
}

std::string purpose_of(const CommandRequest& request) {
  return std::visit([](const auto& options) { return options.purpose; }, request);
}

OptionList option_list(CommandRequest& request) {
  return std::visit([](auto& options) { return option_list(options); }, request);
}

Printing& printing_of(CommandRequest& request) {
  return std::visit([](auto& options) -> Printing& { return options.print; }, request);
}

StatedCase* stated_case(CommandRequest& request) {
  return std::visit(
      [](auto& options) -> StatedCase* {
        if constexpr (requires { options.stated; })
          return &options.stated;
        else
          return nullptr;
      },
      request);
}

int execute(const CommandRequest& request) {
  return std::visit(
      [](const auto& options) {
        if constexpr (requires { problems(options); })
          if (std::vector<std::string> found = problems(options); !found.empty()) throw BadInput(found);
        return execute(options);
      },
      request);
}

}  // namespace orbearing::app
