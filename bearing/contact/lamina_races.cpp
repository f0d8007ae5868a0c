#include "bearing/contact/lamina_races.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace orbearing::bearing::motion {

namespace {

constexpr double kBalance = 1e-14;  // of both end loads, where round-off begins
constexpr int kMostTiltSteps = 100;

// Time constant with which a roller under some load tilts to the equilibrium of both contacts [s]. A rigid
// film of a quarter of a micrometre between roller and race resists tilting so that it takes 4 us. A quarter
// of it and four times as much change lives by at most 0.5 % (bearing/motion/README.md).
constexpr double kRelaxation = 2e-6;
constexpr double kTypicalLoad = 10.0;  // [N]

bool symmetric(const laminae::LaminaContact& contact) {
  const auto drops = contact.drops();
  return (drops - drops.reverse()).abs().maxCoeff() <= 1e-15 * drops.abs().maxCoeff();
}

// Slope of the end load by the end displacement [N/m], of a contact that carries on its whole
// length.
double tilting_stiffness(const laminae::LaminaContact& contact) {
  double approach = contact.greatest_drop() + 1e-8;
  while (contact.evaluate(approach, 0.0).load < kTypicalLoad) approach *= 1.1;
  return contact.evaluate(approach, 0.0).by_end_displacement;
}

bool flat(const laminae::LaminaContact& contact) {
  return contact.greatest_drop() == contact.least_drop();
}

}  // namespace

LaminaRaces::LaminaRaces(laminae::LaminaContact inner, laminae::LaminaContact outer, const Vector2& bore_tilt)
    : inner_(std::move(inner)),
      outer_(std::move(outer)),
      bore_end_displacement_(bore_tilt * outer_.half_length()),
      resistance_(kRelaxation * (tilting_stiffness(inner_) + tilting_stiffness(outer_))),
      upright_(bore_tilt == Vector2::Zero() && symmetric(inner_) && symmetric(outer_)),
      even_(upright_ && flat(inner_) && flat(outer_)) {}

// The elastic energy is convex in the end displacement, so that the unbalanced moment falls with it:
// Newton's method within a bracket.
double LaminaRaces::balanced_end_displacement(double inner_approach, double outer_approach,
                                              const Vector2& outward) const {
  if (upright_) return 0.0;
  const double outer_end_displacement = bore_end_displacement_.dot(outward);
  const double reach = std::abs(outer_end_displacement) + std::max(inner_approach, 0.0) +
                       std::max(outer_approach, 0.0) +
                       std::max(inner_.greatest_drop(), outer_.greatest_drop());
  double low = -reach, high = reach;
  double end_displacement = inner_approach <= inner_.least_drop()   ? outer_end_displacement
                            : outer_approach <= outer_.least_drop() ? 0.0
                                                                    : 0.5 * outer_end_displacement;
  for (int i = 0; i < kMostTiltSteps; ++i) {
    const laminae::LaminaForce in = inner_.evaluate(inner_approach, -end_displacement);
    const laminae::LaminaForce out =
        outer_.evaluate(outer_approach, end_displacement - outer_end_displacement);
    const double excess = in.end_load - out.end_load;
    if (std::abs(excess) <= kBalance * (in.load + out.load)) break;
    (excess > 0.0 ? low : high) = end_displacement;
    const double stiffness = in.by_end_displacement + out.by_end_displacement;
    double next = stiffness > 0.0 ? end_displacement + excess / stiffness : low;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (next == end_displacement) break;
    end_displacement = next;
  }
  return end_displacement;
}

LaminaRaceLoads LaminaRaces::loads(const RollerApproaches& approaches, const Vector2& outward) const {
  const laminae::LaminaForce in = inner_.evaluate(approaches.inner_approach, -approaches.end_displacement);
  const laminae::LaminaForce out = outer_.evaluate(
      approaches.outer_approach, approaches.end_displacement - bore_end_displacement_.dot(outward));
  return {in.load, out.load, in.end_load - out.end_load, out.end_load};
}

void LaminaRaces::put_loads(Race race, const RollerApproaches& approaches, const Vector2& outward,
                            double* load) const {
  if (race == Race::inner)
    inner_.put_loads(approaches.inner_approach, -approaches.end_displacement, load);
  else
    outer_.put_loads(approaches.outer_approach,
                     approaches.end_displacement - bore_end_displacement_.dot(outward), load);
}

double LaminaRaces::energy(const RollerApproaches& approaches, const Vector2& outward) const {
  return inner_.energy(approaches.inner_approach, -approaches.end_displacement) +
         outer_.energy(approaches.outer_approach,
                       approaches.end_displacement - bore_end_displacement_.dot(outward));
}

}  // namespace orbearing::bearing::motion
