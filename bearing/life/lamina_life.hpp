// Life of a roller bearing from the loads of its laminae: the one life of sweeps, runs, crowns and motions. A
// contact that is not cut is one lamina.
//
// Every lamina is an independent part of a race [ISO16281]; with loads even along the roller the
// lives of Lundberg and Palmgren come out, whatever the number of laminae:
//
//   (1)  L^(-9/8) = sum over races and laminae of (f_k q_ek/q_c)^(9/2),  q_c = Q_c n^(-7/9)
//   (2)  q_ek: power mean over the positions, exponent 4 (rotating relative to the load) or 4.5 (stationary)
//   (3)  from a motion, with <> over the passages at a position:  rotating <q_k^4>^(1/4) over all positions,
//        stationary [mean over the positions of <q_k^4>^(4.5/4)]^(1/4.5)
#pragma once

#include <Eigen/Core>

#include "bearing/life/reference_life.hpp"

namespace orbearing::bearing::life {

/// Weights of lamina loads for the life, derived once for a bearing.
struct LaminaRating {
  Eigen::ArrayXd inner_weight;  // [1/N^4.5]  (laminae)  (f_k/q_c)^4.5
  Eigen::ArrayXd outer_weight;  // [1/N^4.5]  (laminae)
  RaceMotions motions;
};

/// By the capacities of Lundberg and Palmgren [Gai2025] with `reduction_factor` [-], without stress riser:
/// straight and untilted it is that of whole contacts. A bearing without laminae has one.
LaminaRating lamina_rating(const Bearing& bearing, double reduction_factor);

/// The same for stated capacities [N] of a whole contact, without stress riser.
LaminaRating lamina_rating(const rating::ContactCapacities& capacities, int laminae,
                           const RaceMotions& motions);
/// With a stress riser [-] (laminae).
LaminaRating lamina_rating(const rating::ContactCapacities& capacities, const Eigen::ArrayXd& riser,
                           const RaceMotions& motions);

using LaminaLoads = Eigen::Ref<const Eigen::ArrayXXd>;  // [N]  (laminae, places)

/// Life [rev] for loads at evenly spaced positions; infinite at no load.
BearingLife lamina_life(const LaminaRating& rating, const LaminaLoads& inner, const LaminaLoads& outer);

/// Means over the positions by (3), [N^4] of a rotating race, [N^4.5] of a stationary one.
using LaminaMeans = rating::ByLamina;

/// From fourth powers [N^4] (laminae, positions).
LaminaMeans lamina_means(const RaceMotions& motions, const Eigen::Ref<const Eigen::ArrayXXd>& inner,
                         const Eigen::Ref<const Eigen::ArrayXXd>& outer);

/// From loads at evenly spaced positions, by (2).
LaminaMeans means_of_loads(const RaceMotions& motions, const LaminaLoads& inner, const LaminaLoads& outer);

/// Life [rev] under them; infinite at no load.
BearingLife life_of_means(const LaminaRating& rating, const LaminaMeans& means);

/// Terms of the sum in (1) [-]. For one mean of many laminae, each has an equal share.
rating::ByLamina lamina_damage(const LaminaRating& rating, const LaminaMeans& means);

}  // namespace orbearing::bearing::life
