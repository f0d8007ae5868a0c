// The bearing that requirements are judged by: its results among those of a row or of a spectrum.
#pragma once

#include <string>
#include <vector>

#include "app/results/life_table.hpp"
#include "mechanics/record.hpp"

namespace orbearing::app {

/// A result of the worst bearing.
struct WorstBearing {
  double value = described::kAbsent;  // infinite: a life without load
  std::string key;                    // its name among the results of one set: shortest_L10mrh
  std::string set{};                  // of several sets, the one with that value, or with none

  /// Name of its column: sets.first.shortest_L10mrh.
  std::string column() const;
};

/// Prefix of the columns of one of several sets; empty for a single set.
std::string column_prefix(const std::string& set);

/// A life of one bearing in hours: L10h, L10rh, L10mh, L10mrh or life_h.
bool is_life(const std::string& key);

/// Names under which a row has the result `key` of the worst bearing, the first that has a number before the
/// others: over a revolution of the carrier where that is a body, of the shortest life where bearings carry
/// unequal loads, else of any bearing. The load sharing of planets is K_gamma of their meshes.
std::vector<std::string> keys_of_worst_bearing(const std::string& key);

/// The result `key` of the worst bearing of all `sets`, or of the one set where there are none; `value` gives
/// a column by its name. Not a number where one set has none.
WorstBearing worst_bearing(const std::string& key, const std::vector<std::string>& sets,
                           const LifeValue& value);

}  // namespace orbearing::app
