// The waves of an elastic outer race as bodies of the motion, equation (16) of bearing/motion/README.md.
#pragma once

#include <Eigen/Core>

#include "bearing/elastic_race.hpp"
#include "bearing/motion/parameters.hpp"

namespace orbearing::bearing::motion {

/// Arrays are over waves, in the order of equilibrium/elastic_waves.hpp; empty: a rigid race.
struct RimModel {
  Eigen::VectorXd stiffness;  // [N/m]
  Eigen::VectorXd mass;       // [kg]
  Eigen::VectorXd damping;    // [N s/m]
  Eigen::VectorXd at_rest;    // [m]    without rollers, under the mean forces of the teeth
};

/// `race` without the waves of a higher order than those that move.
ElasticRace moving_waves(ElasticRace race, const RimParameters& parameters);

/// Throws std::invalid_argument, with what was found and what is required, where a wave has no mass.
RimModel rim_model(const ElasticRace& race, const RimParameters& parameters);

}  // namespace orbearing::bearing::motion
