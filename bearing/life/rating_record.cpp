#include "bearing/life/rating_record.hpp"

namespace orbearing::bearing::rating {

namespace {

using described::Columns;
namespace dimension = described::dimension;

void mark(described::Entry& entry, const char* symbol) {
  entry.symbol = symbol;
  entry.detail = true;
}

}  // namespace

void list(Columns& columns, RatedHours& hours) {
  for (const RatedLife& life : kRatedLives)
    columns.value(life.name, dimension::hours, life.meaning, hours.*life.hours);
}

void list_loads(Columns& columns, RatingLives& lives) {
  const auto load = [&](const char* name, const char* symbol, const char* meaning, double& value) {
    mark(columns.value(name, dimension::force, meaning, value), symbol);
  };
  load("C_N", "C", "basic dynamic load rating", lives.dynamic_capacity);
  load("C0_N", "C0", "basic static load rating", lives.static_capacity);
  load("Cu_N", "C_u", "fatigue load limit", lives.fatigue_load_limit);
  load("P_N", "P", "dynamic equivalent load", lives.dynamic_load);
  load("P0_N", "P0", "static equivalent load", lives.static_load);
  mark(columns.derived("C_over_P", dimension::ratio, "basic dynamic load rating over equivalent load",
                       lives.load_ratio()),
       "C/P");
  mark(columns.derived("S0", dimension::ratio, "basic static load rating over static equivalent load",
                       lives.static_safety()),
       "S0");
}

void list_factors(Columns& columns, RatingLives& lives) {
  const auto factor = [&](const char* name, const char* symbol, const char* meaning, double& value) {
    mark(columns.value(name, dimension::ratio, meaning, value), symbol);
  };
  columns.part(lives.oil, [&](OilCondition& oil) {
    factor("kappa", "kappa", "viscosity ratio; a_ISO takes at most 4", oil.viscosity_ratio);
    factor("e_C", "e_C", "contamination factor of ISO 281", oil.contamination_factor);
  });
  factor("a_ISO", "a_ISO", "life modification factor of ISO 281, from C_u/P", lives.life_modification);
  factor("a_ISO_r", "a_ISO_r", "L10mrh over L10rh at a reliability of 90 %", lives.reference_modification);
}

void describe(described::Record& record, const RatedHours& hours) {
  described::describe_listed(record, hours);
}

void describe_loads(described::Record& record, RatingLives lives) {
  Columns columns(record);
  list_loads(columns, lives);
}

void describe_factors(described::Record& record, RatingLives lives) {
  Columns columns(record);
  list_factors(columns, lives);
}

}  // namespace orbearing::bearing::rating
