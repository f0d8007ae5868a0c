#include "bearing/life/rating_record.hpp"

#include <initializer_list>

namespace orbearing::bearing::rating {

namespace {

using described::kAbsent;
namespace dimension = described::dimension;

struct RatingEntry {
  const char* name;
  const described::Dimension& of;
  const char* symbol;
  const char* meaning;
  double value;
};

void add_entries(described::Record& record, std::initializer_list<RatingEntry> all) {
  for (const RatingEntry& one : all) {
    described::Entry& entry = record.value(one.name, one.of, one.meaning, one.value);
    entry.symbol = one.symbol;
    entry.detail = true;
  }
}

}  // namespace

void describe(described::Record& record, const RatedHours& hours) {
  for (const RatedLife& life : kRatedLives)
    record.value(life.name, dimension::hours, life.meaning, hours.*life.hours);
}

void describe_loads(described::Record& record, const RatingLives& lives) {
  add_entries(record, {{"C_N", dimension::force, "C", "basic dynamic load rating", lives.dynamic_capacity},
                       {"C0_N", dimension::force, "C0", "basic static load rating", lives.static_capacity},
                       {"Cu_N", dimension::force, "C_u", "fatigue load limit", lives.fatigue_load_limit},
                       {"P_N", dimension::force, "P", "dynamic equivalent load", lives.dynamic_load},
                       {"P0_N", dimension::force, "P0", "static equivalent load", lives.static_load},
                       {"C_over_P", dimension::ratio, "C/P", "basic dynamic load rating over equivalent load",
                        lives.load_ratio()},
                       {"S0", dimension::ratio, "S0", "basic static load rating over static equivalent load",
                        lives.static_safety()}});
}

void describe_factors(described::Record& record, const RatingLives& lives) {
  add_entries(record, {{"kappa", dimension::ratio, "kappa", "viscosity ratio; a_ISO takes at most 4",
                        lives.oil ? lives.oil->viscosity_ratio : kAbsent},
                       {"e_C", dimension::ratio, "e_C", "contamination factor of ISO 281",
                        lives.oil ? lives.oil->contamination_factor : kAbsent},
                       {"a_ISO", dimension::ratio, "a_ISO", "life modification factor of ISO 281, from C_u/P",
                        lives.life_modification},
                       {"a_ISO_r", dimension::ratio, "a_ISO_r", "L10mrh over L10rh at a reliability of 90 %",
                        lives.reference_modification}});
}

}  // namespace orbearing::bearing::rating
