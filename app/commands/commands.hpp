// The commands of the program: each is a structure of its options and a function that takes it.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "app/commands/check.hpp"
#include "app/commands/crown.hpp"
#include "app/commands/demo.hpp"
#include "app/commands/fmu.hpp"
#include "app/commands/merge.hpp"
#include "app/commands/modes.hpp"
#include "app/commands/new_case.hpp"
#include "app/commands/open.hpp"
#include "app/commands/plain_commands.hpp"
#include "app/commands/report.hpp"
#include "app/commands/run.hpp"
#include "app/commands/sensitivities.hpp"
#include "app/commands/signals.hpp"
#include "app/commands/spectrum.hpp"
#include "app/commands/stiffness.hpp"
#include "app/commands/sweep.hpp"
#include "app/commands/table.hpp"
#include "app/commands/validate.hpp"

namespace orbearing::app {

/// One variant of the alternatives of several.
template <class... Variants>
struct Joined;
template <class... Some>
struct Joined<std::variant<Some...>> {
  using Type = std::variant<Some...>;
};
template <class... Some, class... Others, class... More>
struct Joined<std::variant<Some...>, std::variant<Others...>, More...>
    : Joined<std::variant<Some..., Others...>, More...> {};

/// A command with its options. Alternatives are in the order of the help.
using CommandRequest =
    Joined<std::variant<DemoOptions, NewOptions, OpenOptions, CheckOptions, RunOptions, SweepOptions,
                        MergeOptions, CrownOptions>,
           PlainCommands,
           std::variant<ModesOptions, StiffnessOptions, SensitivitiesOptions, TableOptions, FmuOptions,
                        SignalsOptions, SpectrumOptions, ValidateOptions, ReportOptions>>::Type;

/// Every command, with no option given.
std::vector<CommandRequest> all_commands();
/// The command of that name. Throws BadInput where there is none.
CommandRequest command_called(const std::string& name);
[[noreturn]] void refuse_command(const std::string& name, const std::vector<std::string>& commands);

std::string name_of(const CommandRequest& request);
std::string purpose_of(const CommandRequest& request);
OptionList option_list(CommandRequest& request);
Printing& printing_of(CommandRequest& request);
/// The case that the command takes; null: none.
StatedCase* stated_case(CommandRequest& request);

/// Computes and prints. Returns the exit code: 0 done, 1 failed at some points. Throws BadInput, first of all
/// for options that do not go together, and ComputationFailed.
int execute(const CommandRequest& request);

}  // namespace orbearing::app
