#include "app/options/option_words.hpp"

#include <nlohmann/json.hpp>

namespace orbearing::app {

namespace {

CLI::Option& add_option(CLI::App& command, const Option& option) {
  if (is_switch(option))
    return *command.add_flag(option.name, *std::get<bool*>(option.member), option.meaning);
  CLI::Option& added = *command.add_option(option.name, CLI::callback_t{}, option.meaning);
  added.type_name(type_text(option));
  if (!is_list(option)) return added;
  if (is_positional(option)) return *added.expected(CLI::detail::expected_max_vector_size);
  // May be repeated, with one value each time.
  added.allow_extra_args(false)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  return added;
}

}  // namespace

void add_options(CLI::App& command, const OptionList& options) {
  for (const Option& option : options) {
    CLI::Option& added = add_option(command, option);
    added.required(option.details.required);
    if (option.details.hidden) added.group("");
  }
  for (const Option& option : options)
    if (!option.details.needs.empty())
      command.get_option(long_name(option))->needs(command.get_option(option.details.needs));
}

void put_words(const CLI::App& command, const OptionList& options) {
  for (const Option& option : options) {
    if (is_switch(option)) continue;  // CLI11 has set it
    for (const std::string& word : command.get_option(long_name(option))->results())
      if (const std::string fault = put_value(option, word); !fault.empty())
        throw CLI::ValidationError(long_name(option), fault);
  }
}

}  // namespace orbearing::app
