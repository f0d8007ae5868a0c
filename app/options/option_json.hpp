// Options from a JSON object, by their keys.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>

#include "app/options/option.hpp"

namespace orbearing::app {

/// Puts the values of the object into the members; null and false leave the default. `given`: names of
/// options that have their value already. Throws BadInput with every mistake at once.
void put_json(const nlohmann::ordered_json& object, const OptionList& options,
              std::set<std::string> given = {});

/// The present values by their keys.
nlohmann::ordered_json json_of(const OptionList& options);

}  // namespace orbearing::app
