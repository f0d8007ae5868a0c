#include "app/case/input_keys.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <span>
#include <string>
#include <vector>

#include "app/case/catalogue_fields.hpp"
#include "app/case/field_table.hpp"

namespace orbearing::app {
namespace {

// The structure has texts alone.
std::span<const std::string> all_keys() {
  static_assert(sizeof(InputKeys) % sizeof(std::string) == 0);
  return {reinterpret_cast<const std::string*>(&keys()), sizeof(InputKeys) / sizeof(std::string)};
}

std::vector<Condition> conditions_of(const std::string& path) {
  const Field* field = find_field(path);
  return field == nullptr ? std::vector<Condition>{} : field->use.conditions;
}

TEST(InputKeys, AreInputsEachOfItsOwn) {
  std::set<std::string> found;
  for (const std::string& key : all_keys()) {
    EXPECT_TRUE(found.insert(key).second) << "'" << key << "' twice";
    EXPECT_NE(find_field(key), nullptr) << "'" << key << "'";
  }
}

// A class of a seat replaces the interference of that seat alone.
TEST(CatalogueConditions, OfInterferencesNameTheirOwnClass) {
  const auto named = [](const std::string& path, const char* other) {
    for (const Condition& condition : conditions_of(path))
      if (condition.absent && condition.paths == std::vector<std::string>{other}) return true;
    return false;
  };
  const auto &inner = keys().inner_interference, &outer = keys().outer_interference;
  EXPECT_TRUE(named(inner, catalogue_keys::kPinClass));
  EXPECT_FALSE(named(inner, catalogue_keys::kPlanetClass));
  EXPECT_TRUE(named(outer, catalogue_keys::kPlanetClass));
  EXPECT_FALSE(named(outer, catalogue_keys::kPinClass));
}

// Temperatures and interferences of a ring count where the bearing has it.
TEST(CatalogueConditions, OfRingsNameTheRing) {
  const auto counts_with = [](const std::string& path) {
    for (const Condition& condition : conditions_of(path))
      if (condition.paths == std::vector<std::string>{keys().rings}) return condition.values;
    return std::vector<std::string>{};
  };
  using testing::ElementsAre;
  for (const std::string& path : {keys().inner_interference, keys().inner_ring_temperature, keys().bore})
    EXPECT_THAT(counts_with(path), ElementsAre("both")) << path;
  for (const std::string& path :
       {keys().outer_interference, keys().outer_ring_temperature, keys().outside_diameter})
    EXPECT_THAT(counts_with(path), ElementsAre("both", "outer")) << path;
}

}  // namespace
}  // namespace orbearing::app
