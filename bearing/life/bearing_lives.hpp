// Lives of one bearing under one load, by the names that results have.
#pragma once

#include "bearing/life/rating_lives.hpp"
#include "mechanics/record.hpp"

namespace orbearing::bearing::rating {

/// All lives of one bearing under one load, with what they rest on.
struct BearingLives {
  RatingLives standard;
  double lundberg_palmgren = kNotRated;  // [rev]
  double speed = 0.0;                    // [rad/s]  of the race relative to the load; 0: not known
  double pressure = kNotRated;           // [Pa]  the largest, after Hertz
};

/// L10_Mrev ... life_Mrev, L10h ... life_h, C_N, C0_N, Cu_N, P_N, P0_N, C_over_P, S0,
/// contact_pressure_max_MPa, kappa, e_C, a_ISO, a_ISO_r.
void describe(described::Record& record, const BearingLives& lives);

}  // namespace orbearing::bearing::rating
