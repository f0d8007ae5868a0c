// Lives of one bearing side by side, by the names that results have, and how they read.
#pragma once

#include <functional>
#include <string>

#include "bearing/life/bearing_lives.hpp"
#include "mechanics/record.hpp"

namespace orbearing::app {

using bearing::rating::BearingLives;

/// Properties of the bearing and of the case that the words of a table depend on.
struct LifeWords {
  bearing::rating::RollingElement element = bearing::rating::RollingElement::roller;
  double reduction_factor = 0.0;  // [-]  of the capacities of Lundberg and Palmgren; 0: not shown
  bearing::rating::Life governing = bearing::rating::Life::lundberg_palmgren;
};

/// The number of one of those names in the unit that it ends in, infinite without load; not a number where
/// there is none.
using LifeValue = std::function<double(const std::string&)>;
LifeValue value_by_name(const BearingLives& lives);

/// Lives with the clause each is by, ratings and loads, and which of them governs and why they differ.
struct LifeTable {
  LifeValue value;
  LifeWords words;
};
void describe(described::Record& record, const LifeTable& table);
/// Text for terminals, whose output begins with it.
std::string lives_text(const LifeTable& table);

}  // namespace orbearing::app
