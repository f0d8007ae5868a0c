// Lives, ratings and loads of the standards as results.
#pragma once

#include <array>

#include "bearing/life/rating_lives.hpp"
#include "mechanics/columns.hpp"

namespace orbearing::bearing::rating {

struct RatedLife {
  const char* name;
  const char* meaning;
  double RatedHours::*hours;
};
inline constexpr std::array<RatedLife, 4> kRatedLives{
    {{"L10h", "basic rating life of ISO 281", &RatedHours::basic},
     {"L10rh", "basic reference rating life of ISO/TS 16281", &RatedHours::reference},
     {"L10mh", "modified rating life of ISO 281: a_1 a_ISO L10h", &RatedHours::modified},
     {"L10mrh", "modified reference rating life of ISO/TS 16281, a_ISO by lamina or ball",
      &RatedHours::modified_reference}}};

void list(described::Columns& columns, RatedHours& hours);
/// Ratings, equivalent loads and their ratios.
void list_loads(described::Columns& columns, RatingLives& lives);
/// Factors of film, cleanliness and fatigue limit.
void list_factors(described::Columns& columns, RatingLives& lives);

void describe(described::Record& record, const RatedHours& hours);
void describe_loads(described::Record& record, RatingLives lives);
void describe_factors(described::Record& record, RatingLives lives);

}  // namespace orbearing::bearing::rating
