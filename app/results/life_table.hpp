// Lives of one bearing side by side, by the names that results have, and how they read.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "bearing/life/rating_lives.hpp"

namespace orbearing::app {

/// All lives of one bearing under one load, with what they rest on.
struct BearingLives {
  bearing::rating::RatingLives standard;
  double lundberg_palmgren = bearing::rating::kNotRated;  // [rev]
  double speed = 0.0;  // [rad/s]  of the race whose revolutions count against the load; 0: not known
  double pressure = bearing::rating::kNotRated;  // [Pa]  the largest, after Hertz
};

/// Name in results and value in the unit that the name ends in; infinite without load, not a number where there
/// is none.
using NamedValues = std::vector<std::pair<std::string, double>>;

/// L10_Mrev ... life_Mrev, L10h ... life_h, C_N, C0_N, Cu_N, P_N, P0_N, C_over_P, S0, contact_pressure_max_MPa,
/// kappa, e_C, a_ISO, a_ISO_r.
NamedValues life_values(const BearingLives& lives);

/// What the words of a table depend on.
struct LifeWords {
  bearing::rating::RollingElement element = bearing::rating::RollingElement::roller;
  double reduction_factor = 0.0;  // [-]  of the capacities of Lundberg and Palmgren; 0: not said
};

/// The number of a name of life_values(); not a number where there is none.
using LifeValue = std::function<double(const std::string&)>;
LifeValue value_by_name(NamedValues values);

/// The table of lives with the clause each is by, ratings and loads below it, and by which life to design and why
/// they differ.
std::string lives_text(const LifeValue& value, const LifeWords& words);
/// The same for reports: `lives` of {key, hours, Mrev, by}, `loads` of {key, symbol, value, unit}, `advice`.
nlohmann::ordered_json lives_record(const LifeValue& value, const LifeWords& words);

/// By which life to design, and why the lives differ. `oil`: there are lives with a_ISO.
std::string design_advice(bool oil, bearing::rating::RollingElement element);

}  // namespace orbearing::app
