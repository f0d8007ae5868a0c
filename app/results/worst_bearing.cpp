#include "app/results/worst_bearing.hpp"

#include <cmath>

namespace orbearing::app {

namespace {

bool is_worse_where_larger(const std::string& key) {
  return key == "contact_pressure_max_MPa" || key == "P0_N" || key == "largest_load_share";
}

WorstBearing worst_of_set(const std::string& key, const std::string& set, const LifeValue& value) {
  WorstBearing worst{.key = key, .set = set};
  for (const std::string& name : keys_of_worst_bearing(key)) {
    worst.key = name;
    worst.value = value(worst.column());
    if (std::isfinite(worst.value)) return worst;
  }
  return worst;
}

}  // namespace

std::string column_prefix(const std::string& set) {
  return set.empty() ? "" : "sets." + set + ".";
}

std::string WorstBearing::column() const {
  return column_prefix(set) + key;
}

bool is_life(const std::string& key) {
  return key == "life_h" || (key.starts_with("L10") && key.ends_with("h"));
}

std::vector<std::string> keys_of_worst_bearing(const std::string& key) {
  if (key == "largest_load_share") return {"carrier_K_gamma", key};
  if (key == "P0_N" || key == "S0" || key == "contact_pressure_max_MPa") return {"carrier_" + key, key};
  return is_life(key) ? std::vector{"carrier_" + key, "shortest_" + key, key} : std::vector{key};
}

WorstBearing worst_bearing(const std::string& key, const std::vector<std::string>& sets,
                           const LifeValue& value) {
  if (sets.empty()) return worst_of_set(key, "", value);
  const bool sharing = key == "largest_load_share";  // none in a set whose planets carry equal loads
  WorstBearing worst;
  for (const std::string& set : sets) {
    WorstBearing one = worst_of_set(key, set, value);
    if (std::isnan(one.value) && !sharing) return one;
    const bool worse = is_worse_where_larger(key) ? one.value > worst.value : one.value < worst.value;
    if (worst.key.empty() || worse || std::isnan(worst.value)) worst = std::move(one);
  }
  return worst;
}

}  // namespace orbearing::app
