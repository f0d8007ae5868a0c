// Lives, ratings and loads of the standards as results.
#pragma once

#include <array>

#include "bearing/life/rating_lives.hpp"
#include "mechanics/record.hpp"

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

void describe(described::Record& record, const RatedHours& hours);

/// Ratings, equivalent loads and their ratios.
void describe_loads(described::Record& record, const RatingLives& lives);
/// Factors of film, cleanliness and fatigue limit.
void describe_factors(described::Record& record, const RatingLives& lives);

}  // namespace orbearing::bearing::rating
