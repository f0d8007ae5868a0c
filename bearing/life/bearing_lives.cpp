#include "bearing/life/bearing_lives.hpp"

#include <array>

#include "bearing/life/basic_life.hpp"
#include "bearing/life/rating_record.hpp"

namespace orbearing::bearing::rating {

void describe(described::Record& record, const BearingLives& lives) {
  using namespace described;
  const RatingLives& standard = lives.standard;
  struct NamedLife {
    const char* revolutions;
    const char* hours;
    const char* meaning;
    double value;  // [rev]
  };
  const std::array<NamedLife, 5> all{
      {{"L10_Mrev", "L10h", "basic rating life of ISO 281", standard.basic},
       {"L10r_Mrev", "L10rh", "basic reference rating life of ISO/TS 16281", standard.reference.bearing},
       {"L10m_Mrev", "L10mh", "modified rating life of ISO 281", standard.modified},
       {"L10mr_Mrev", "L10mrh", "modified reference rating life of ISO/TS 16281",
        standard.modified_reference.bearing},
       {"life_Mrev", "life_h", "by Lundberg and Palmgren, of the loads of this analysis",
        lives.lundberg_palmgren}}};
  for (const NamedLife& life : all)
    record.value(life.revolutions, dimension::revolutions, life.meaning, life.value).detail = true;
  record.entry("life_Mrev").variable = "life_revolutions";
  for (const NamedLife& life : all)
    record
        .value(life.hours, dimension::hours, life.meaning,
               lives.speed != 0.0 ? hours(life.value, lives.speed) : kAbsent)
        .detail = true;
  describe_loads(record, standard);
  Entry& pressure =
      record.value("contact_pressure_max_MPa", dimension::pressure, "largest, after Hertz", lives.pressure);
  pressure.symbol = "contact pressure";
  pressure.detail = true;
  describe_factors(record, standard);
}

}  // namespace orbearing::bearing::rating
