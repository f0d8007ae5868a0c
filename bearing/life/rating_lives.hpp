// Lives of one bearing by the standards, side by side, with what they rest on. One way for rollers and balls,
// for loads at rest and for means over a motion.
//
//   L10    (C/P)^p, p = 3 (balls) or 10/3 (rollers)                                             [ISO281]
//   L10r   from the load of every lamina, with its stress riser, or of every ball               [ISO16281]
//   L10m   a_1 a_ISO(e_C C_u/P, kappa) L10, P of the whole bearing                              [ISO281]
//   L10mr  rollers: L^(-9/8) = sum over laminae k of [a_1 a_ISO(e_C C_u/P_k, kappa)]^(-9/8) D_k,
//          balls: a_1 a_ISO(e_C C_u/P, kappa) L10r with P = C (L10r)^(-1/3)                     [ISO16281]
//
//   (1)  D_k = (f_k q_ik/q_ci)^(9/2) + (f_k q_ek/q_ce)^(9/2): part of lamina k in L10r^(-9/8)
//   (2)  P_k = 0.323 Z n cos(alpha) {[q_i^(9/2) + (1.038 q_ci/q_ce q_e)^(9/2)]/[1 + (1.038
//   q_ci/q_ce)^(9/2)]}^(2/9),
//        q_i, q_e the equivalent loads of lamina k with f_k, of n laminae
//
// By position (StressRiser) n is always kLeastRatedLaminae: the equivalent loads of a bearing with another
// number are those of the laminae that lie over each. By the standard's formula n is the bearing's own. A
// contact that is not cut carries evenly: it counts as kLeastRatedLaminae equal laminae, or as many as the
// bearing has. L10m and L10mr hold a_1; L10 and L10r are for a reliability of 90 %.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "bearing/life/lamina_life.hpp"
#include "bearing/life/life_modification.hpp"
#include "bearing/life/standard_life.hpp"

namespace orbearing::bearing::rating {

/// Method of the governing life.
enum class LifeMethod {
  lundberg_palmgren,  // of the loads of that fidelity, exponents 4 and 9/8 (rollers), 3 and 10/9 (balls)
  iso281,             // L10m where the oil is stated, else L10
  iso16281,           // L10mr where the oil is stated, else L10r
};

constexpr described::Names<LifeMethod, 3> names_of(LifeMethod) {
  return {{{LifeMethod::lundberg_palmgren, "lundberg-palmgren"},
           {LifeMethod::iso281, "iso-281"},
           {LifeMethod::iso16281, "iso-16281"}}};
}

inline constexpr double kNotRated = std::numeric_limits<double>::quiet_NaN();

/// A bearing as the standards rate it, whatever its load: laid out once.
struct BearingRating {
  Ratings ratings;
  RollingElement element = RollingElement::roller;
  int elements = 0;            // [-]
  double contact_angle = 0.0;  // [rad]  nominal
  RaceMotions motions;
  life::LaminaRating laminae;       // of rollers: contacts of C_r, with stress riser
  bool on_too_few_laminae = false;  // straight rollers on fewer than [ISO16281] allows: L10r, L10mr not rated
};

BearingRating bearing_rating(const Bearing& bearing, const StatedRatings& stated = {});

/// Whether straight rollers, whose stress riser depends on the position, are cut into fewer laminae than
/// [ISO16281] requires for lives.
bool has_too_few_laminae(const Bearing& bearing, StressRiser riser);

/// Laminae with stress riser of contacts of C_r: kLeastRatedLaminae, or by the standard's formula the
/// bearing's.
life::LaminaRating rated_laminae(const ContactCapacities& contacts, const Bearing& bearing,
                                 StressRiser riser);

/// Load of one bearing, its oil and the reliability.
struct RatingCondition {
  std::optional<double> dynamic_load;  // [N]  P; none: the standard's factors are not held
  std::optional<double> static_load;   // [N]  P_0; none: likewise
  std::optional<OilCondition> oil;     // none: nothing is said of the oil
  double reliability_factor = 1.0;     // [-]  a_1
};

/// kNotRated where the standards give no number: without oil, with kappa below 0.1, or without P.
struct RatingLives {
  double dynamic_capacity = kNotRated;                              // [N]  C
  double static_capacity = kNotRated;                               // [N]  C_0
  double fatigue_load_limit = kNotRated;                            // [N]  C_u
  double dynamic_load = kNotRated;                                  // [N]  P
  double static_load = kNotRated;                                   // [N]  P_0
  std::optional<OilCondition> oil;                                  // kappa, e_C
  double reliability_factor = 1.0;                                  // [-]  a_1
  double life_modification = kNotRated;                             // [-]  a_ISO from C_u/P
  double reference_modification = kNotRated;                        // [-]  a_ISO_r: L10mr/(a_1 L10r)
  double basic = kNotRated;                                         // [rev]  L10
  BearingLife reference{kNotRated, kNotRated, kNotRated};           // [rev]  L10r of races and bearing
  double modified = kNotRated;                                      // [rev]  L10m, with a_1
  BearingLife modified_reference{kNotRated, kNotRated, kNotRated};  // [rev]  L10mr, with a_1

  double load_ratio() const { return dynamic_capacity / dynamic_load; }   // [-]  C/P
  double static_safety() const { return static_capacity / static_load; }  // [-]  S_0
};

/// The same in hours, of one bearing or of several of which none may fail.
struct RatedHours {
  double basic = kNotRated;               // [h]  L10h
  double reference = kNotRated;           // [h]  L10rh
  double modified = kNotRated;            // [h]  L10mh, with a_1
  double modified_reference = kNotRated;  // [h]  L10mrh, with a_1
};

/// All of them, in this order.
inline constexpr std::array kRatedHours{&RatedHours::basic, &RatedHours::reference, &RatedHours::modified,
                                        &RatedHours::modified_reference};

/// At the speed of the race that rotates relative to the load [rad/s]; infinite at rest.
RatedHours rated_hours(const RatingLives& lives, double speed);
/// Life of a system of bearings of which none may fail: the product law with slope e, life by life.
RatedHours hours_together(const std::vector<RatedHours>& bearings, double slope);
/// Life of a system of `count` equal bearings.
RatedHours hours_of_equal(const RatedHours& one, int count, double slope);

/// Lives of roller bearings: means over the positions as in life::lamina_means(), for loads without stress
/// riser; one lamina: contacts that are not cut.
RatingLives rating_lives(const BearingRating& rating, const RatingCondition& condition,
                         const life::LaminaMeans& means);

/// Lives of ball bearings: equivalent loads over the positions, exponent 3 on the race that rotates relative
/// to the load, 10/3 on the stationary one.
RatingLives rating_lives(const BearingRating& rating, const RatingCondition& condition,
                         const EquivalentBallLoads& loads);

/// Lives of either type: loads of the elements on both races at one instant.
RatingLives rating_lives(const BearingRating& rating, const RatingCondition& condition,
                         const ElementLoads& inner, const ElementLoads& outer);

/// The lives of one bearing that results hold.
enum class Life { basic, reference, modified, modified_reference, lundberg_palmgren };

/// The governing life: requirements, peaks, spectra, crowns and sensitivities use it.
constexpr Life governing_life(LifeMethod method, bool oil_is_stated) {
  if (method == LifeMethod::lundberg_palmgren) return Life::lundberg_palmgren;
  if (method == LifeMethod::iso281) return oil_is_stated ? Life::modified : Life::basic;
  return oil_is_stated ? Life::modified_reference : Life::reference;
}

/// Its keys among the results, in hours and in million revolutions.
const char* hours_key(Life life);
const char* revolutions_key(Life life);

/// One of them [h]; kNotRated where the oil is stated and kappa is below 0.1.
double hours_of(Life life, double lundberg_palmgren, const RatedHours& hours);

}  // namespace orbearing::bearing::rating
