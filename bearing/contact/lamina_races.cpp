#include "bearing/contact/lamina_races.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace orbearing::bearing::motion {

namespace {

constexpr double kBalance = 1e-14;  // of both tip loads, where round-off begins
constexpr int kMostTiltSteps = 100;

bool symmetric(const laminae::LaminaContact& contact) {
  const auto drops = contact.drops();
  return (drops - drops.reverse()).abs().maxCoeff() <= 1e-15 * drops.abs().maxCoeff();
}

bool flat(const laminae::LaminaContact& contact) {
  return contact.greatest_drop() == contact.least_drop();
}

}  // namespace

LaminaRaces::LaminaRaces(laminae::LaminaContact inner, laminae::LaminaContact outer, const Vector2& bore_tilt)
    : inner_(std::move(inner)),
      outer_(std::move(outer)),
      bore_tip_(bore_tilt * outer_.half_length()),
      upright_(bore_tilt == Vector2::Zero() && symmetric(inner_) && symmetric(outer_)),
      even_(upright_ && flat(inner_) && flat(outer_)) {}

// The elastic energy is convex in the tip, so that the moment out of balance falls with it: Newton's method
// within a bracket.
double LaminaRaces::roller_tip(double inner_approach, double outer_approach, double outer_tip) const {
  const double reach = std::abs(outer_tip) + std::max(inner_approach, 0.0) + std::max(outer_approach, 0.0) +
                       std::max(inner_.greatest_drop(), outer_.greatest_drop());
  double low = -reach, high = reach;
  double tip = inner_approach <= inner_.least_drop()   ? outer_tip
               : outer_approach <= outer_.least_drop() ? 0.0
                                                       : 0.5 * outer_tip;
  for (int i = 0; i < kMostTiltSteps; ++i) {
    const laminae::LaminaForce in = inner_.evaluate(inner_approach, -tip);
    const laminae::LaminaForce out = outer_.evaluate(outer_approach, tip - outer_tip);
    const double excess = in.tip_load - out.tip_load;
    if (std::abs(excess) <= kBalance * (in.load + out.load)) break;
    (excess > 0.0 ? low : high) = tip;
    const double stiffness = in.by_tip + out.by_tip;
    double next = stiffness > 0.0 ? tip + excess / stiffness : low;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (next == tip) break;
    tip = next;
  }
  return tip;
}

LaminaRaceLoads LaminaRaces::loads(double inner_approach, double outer_approach,
                                   const Vector2& outward) const {
  const double outer_tip = bore_tip_.dot(outward);
  const double tip = upright_ ? 0.0 : roller_tip(inner_approach, outer_approach, outer_tip);
  return {inner_.evaluate(inner_approach, -tip).load, outer_.evaluate(outer_approach, tip - outer_tip).load,
          tip};
}

void LaminaRaces::put_loads(Race race, const LaminaStand& stand, const Vector2& outward, double* load) const {
  if (race == Race::inner)
    inner_.put_loads(stand.inner_approach, -stand.tip, load);
  else
    outer_.put_loads(stand.outer_approach, stand.tip - bore_tip_.dot(outward), load);
}

double LaminaRaces::energy(double inner_approach, double outer_approach, const Vector2& outward) const {
  const double outer_tip = bore_tip_.dot(outward);
  const double tip = loads(inner_approach, outer_approach, outward).tip;
  return inner_.energy(inner_approach, -tip) + outer_.energy(outer_approach, tip - outer_tip);
}

}  // namespace orbearing::bearing::motion
