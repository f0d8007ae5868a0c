// Lives of one bearing side by side (coupling/analysis/life_table.hpp) as terminals show them.
#pragma once

#include <string>

#include "coupling/analysis/life_table.hpp"

namespace orbearing::app {

using analysis::BearingLives;
using analysis::LifeTable;
using analysis::LifeValue;
using analysis::LifeWords;

/// Text for terminals, whose output begins with it.
std::string lives_text(const LifeTable& table);

}  // namespace orbearing::app
