// Options from the words of a command line, which CLI11 takes apart.
#pragma once

#include <CLI/CLI.hpp>

#include "app/options/option.hpp"

namespace orbearing::app {

/// Lets a command take these options, and tell of them in its help.
void add_options(CLI::App& command, const OptionList& options);

/// Puts the words that the command was given into the members. Throws CLI::ValidationError.
void put_words(const CLI::App& command, const OptionList& options);

}  // namespace orbearing::app
