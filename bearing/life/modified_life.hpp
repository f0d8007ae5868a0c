// Modified life of a roller bearing in any fidelity: Lundberg and Palmgren's, each lamina by its own a_ISO of
// [ISO281].
//
//   (1)  L_m^(-9/8) = sum over laminae k of a_k^(-9/8) D_k,  D_k = (q_ki/q_ci)^(9/2) + (q_ke/q_ce)^(9/2)
//   (2)  a_k = a_ISO(e_C C_u/P_k, kappa)
//   (3)  P_k = C_r/(lambda nu) (n D'_k)^(2/9): the radial load of a bearing without clearance that all
//   laminae would
//        show if they were loaded as this one; D' with the contact capacities of [ISO16281] that belong to
//        C_r, which do not hold the reduction factor lambda nu = 0.83
//
// so that without laminae, or with equal ones, L_m = a_ISO(e_C C_u/P, kappa) L, and P is the load on the
// bearing where the rollers carry it as without clearance and inertia. (1) is the form of [ISO16281]; (3) is
// derived here, since the standard's own wording of P_k was not at hand. Its reference load C_r L^(-3/10) is
// smaller, 0.6 to 0.8 of the load on the bearing, since lives of laminae fall with the fourth power.
#pragma once

#include <optional>

#include "bearing/life/damage.hpp"
#include "bearing/life/lamina_life.hpp"
#include "bearing/life/life_modification.hpp"
#include "bearing/life/standard_life.hpp"

namespace orbearing::bearing::rating {

/// Lives of races and bearing with a_ISO.
struct ModifiedLife {
  BearingLife life;   // [rev]
  double load = 0.0;  // [N]  P of all laminae together
  double factor =
      1.0;  // [-]  a_ISO of the whole bearing: life.bearing over that of the same loads without it
};

/// None where kappa is below 0.1, where [ISO281] gives no a_ISO. `inner` and `outer` as in
/// motion::life_under(), `reduction_factor` [-] likewise.
std::optional<ModifiedLife> modified_life(const Bearing& bearing, double reduction_factor,
                                          const Ratings& ratings, const OilCondition& oil,
                                          const motion::RaceDamageView& inner,
                                          const motion::RaceDamageView& outer);
/// The same from means over the places; a contact that is not cut is one lamina.
std::optional<ModifiedLife> modified_life(const Bearing& bearing, double reduction_factor,
                                          const Ratings& ratings, const OilCondition& oil,
                                          const life::LaminaMeans& means);

}  // namespace orbearing::bearing::rating
