// Fatigue of the balls themselves, which the ratings of bearings leave out, Eq. (35) of [Chen2026].
#pragma once

#include "bearing/life/ball_capacity.hpp"

namespace orbearing::bearing::rating {

/// Equivalent loads [N] of the contacts of one ball with either race, as it goes round: the ball turns through
/// them, so their mean counts with the power 3.
struct BallContactLoads {
  double inner = 0.0;  // [N]
  double outer = 0.0;  // [N]
};

/// Life [rev] of all balls together, in revolutions of one race relative to the other; infinite at no load.
///
/// A race and a ball of the same steel in one contact differ by the length of their track alone. By Lundberg and
/// Palmgren's law, ln 1/S ~ N^e V, a ball bears (d_race/D)^(1/e) times the cycles N of the race, with d_race =
/// d_m (1 -+ gamma) and e = 10/9. In a million revolutions every point of the race is passed Z/2 (1 +- gamma)
/// times; a ball turns (1 - gamma^2)/(2 gamma) times in each of them, N_j, and meets each race once in a turn.
/// The track is taken to stay where it is on the ball: one that wanders lasts longer.
double life_of_balls(const Bearing& bearing, const ContactCapacities& capacities, const BallContactLoads& loads);

/// Life of two parts of which neither may fail, by Weibull's product law for point contacts. Any unit.
double life_of_both(double races, double balls);

}  // namespace orbearing::bearing::rating
