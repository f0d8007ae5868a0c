// Lives of one bearing side by side, by the names that results have, and how they read.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "bearing/life/bearing_lives.hpp"
#include "mechanics/record.hpp"

namespace orbearing::analysis {

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

/// One line of the table: names of its numbers, and the standard or method.
struct LifeLine {
  const char* hours;
  const char* revolutions;
  std::string by;
};
std::array<LifeLine, 5> life_lines(const LifeWords& words);
/// Ratings, loads and factors of all bearings: those with a symbol.
std::vector<described::Entry> load_entries();
/// Which life governs, and why the lives differ.
std::string design_advice(const LifeTable& table);

}  // namespace orbearing::analysis
