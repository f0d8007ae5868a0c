// Stiffness of a bearing of rollers on laminae in the frame of its carrier: bore against pin.
#pragma once

#include <Eigen/Core>

#include "bearing/equilibrium/lamina_bearing.hpp"
#include "bearing/equilibrium/quasi_static.hpp"

namespace orbearing::bearing::laminae {

/// Slope of the load on the bore and of the moment that holds its tilt by its displacement (x, y) and tilt
/// (along x, along y): [N/m], [N/rad], [N m/m], [N m/rad]. Exact at the equilibrium `state`:
/// each is two springs in series, with its films, README.md (13); an outer race that bends follows.
/// Symmetric.
Eigen::Matrix4d stiffness_at(const LaminaBearing& bearing, const QuasiStaticState& state,
                             const ElasticRace& outer_race = {});

/// The same of the means over the cage angles of `result`, under a load and a tilt that do not change with
/// the cage: the slope of what quasi_static_bearing() gives. Throws std::domain_error where the bearing bears
/// nothing in some direction.
Eigen::Matrix4d mean_stiffness(const LaminaBearing& bearing, const QuasiStaticResult& result,
                               const ElasticRace& outer_race = {});

/// By x, y, z, tilt about x and about y; along z nothing is borne.
Eigen::Matrix<double, 5, 5> about_axes(const Eigen::Matrix4d& stiffness);

}  // namespace orbearing::bearing::laminae
