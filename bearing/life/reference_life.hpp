// Basic reference rating life from the load of every lamina or ball, [ISO16281].
//
// Loads come as plain arrays, from a quasi-static bearing or from a motion in time. Unloaded contacts count.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "bearing/life/ball_capacity.hpp"
#include "bearing/life/roller_capacity.hpp"
#include "mechanics/described.hpp"

namespace orbearing::bearing::rating {

/// The least number of laminae for which [ISO16281] gives L10r.
inline constexpr int kLeastRatedLaminae = 30;

/// Treatment of the stress at the ends of a roller, beyond that of its laminae.
enum class StressRiser {
  position,  // a function of the position along the roller: that of the standard's least number of laminae
  standard,  // the standard's formula for the number at hand, on which lives of straight rollers then depend
};

constexpr described::Names<StressRiser, 2> names_of(StressRiser) {
  return {{{StressRiser::position, "position"}, {StressRiser::standard, "standard"}}};
}

/// Formula of [ISO16281], as a factor on the loads of laminae [-] (laminae):
/// 1 - 0.01/ln(1.985 |2k - n - 1|/(2n - 2)) for lamina k = 1 ... n, whatever the profile; 1 in the middle of
/// an odd n.
Eigen::ArrayXd stress_riser(Eigen::Index laminae);

/// Either of them [-] (laminae). By position: the formula for kLeastRatedLaminae, held over each of these;
/// (mean of its power 9/2 over a lamina)^(2/9), so that equal loads have the same life with any number.
Eigen::ArrayXd stress_riser(Eigen::Index laminae, StressRiser riser);

/// Loads [N] (laminae, rollers) with the stress riser on them.
Eigen::ArrayXXd with_stress_riser(const Eigen::Ref<const Eigen::ArrayXXd>& loads, StressRiser riser);

/// Loads [N] (laminae) of a roller on `count` equal laminae of the same length: each takes what lies over it.
Eigen::ArrayXd on_equal_laminae(const Eigen::ArrayXd& loads, Eigen::Index count);

/// Lamina loads [N] (laminae, rollers) that would press as hard, as line contacts of Hertz, as the largest
/// pressures `pressure` [Pa] found in the laminae by a finer model do: q = p^2 pi D (1 -+ gamma) l (1 -
/// nu^2)/ (E n), upper sign inner race. (In N and mm [ISO16281] writes (p/271)^2 D (1 -+ gamma) l/n, the same
/// for E = 210 GPa, nu = 0.3.) They replace loads with the stress riser.
Eigen::ArrayXXd loads_of_pressures(const Eigen::Ref<const Eigen::ArrayXXd>& pressure, const RollerSet& set,
                                   Race race, const Material& material);

/// Equivalent load [N] (laminae) of each lamina over the rollers: power mean with exponent 4 on the race that
/// rotates relative to the load, 4.5 on the stationary one. `loads` [N] (laminae, rollers) hold the riser.
Eigen::ArrayXd equivalent_lamina_loads(const Eigen::Ref<const Eigen::ArrayXXd>& loads, RaceMotion motion);

/// A number of each lamina on both races.
struct ByLamina {
  Eigen::ArrayXd inner, outer;  // (laminae)
};

/// Equivalent ball load [N]: power mean over all balls, exponent 3 (turning) or 10/3 (standing).
double equivalent_ball_load(const Eigen::Ref<const Eigen::ArrayXd>& loads, RaceMotion motion);

/// L10r [rev] of a ball bearing, for equivalent ball loads [N] of both races.
BearingLife ball_reference_life(const ContactCapacities& capacities, double inner_load, double outer_load);

}  // namespace orbearing::bearing::rating
