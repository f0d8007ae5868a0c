// What one effect is worth: the same drivetrain with it switched off, or with another clearance.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "coupling/study/operating_point.hpp"

namespace orbearing::study {

/// A change to the drivetrain, named for people.
struct Ablation {
  std::string name;
  std::string group;  // which picture shows it, and beside which others it stands
  std::function<void(PlanetaryDrivetrain&)> change;
};

/// The drivetrain as it stands, then each effect switched in turn.
std::vector<Ablation> ablations();

/// The few that matter most and cost little: inertial terms, teeth, film, law of traction.
std::vector<Ablation> chief_dynamic_ablations(const PlanetaryDrivetrain& base);

/// All that the motion in time is asked: `base` as it stands, then each effect in turn, off where `base` has
/// it and on where it has not; forms of races and rollers that it lacks; what a source prints otherwise. A
/// constant speed has no Euler terms.
std::vector<Ablation> dynamic_ablations(const PlanetaryDrivetrain& base);

/// One point for each ablation and input speed [rad/s], ablation by ablation; computed in parallel. A point
/// that fails holds its reason in `status`.
std::vector<PointResult> evaluate_all(const PlanetaryDrivetrain& drivetrain,
                                      const std::vector<Ablation>& ablations,
                                      const std::vector<double>& speeds, Fidelity fidelity);

/// Life [h] of one bearing over input speeds [rad/s] with `ablation` in force.
std::vector<double> life_over_speed(const PlanetaryDrivetrain& drivetrain, const Ablation& ablation,
                                    const std::vector<double>& speeds);

}  // namespace orbearing::study
