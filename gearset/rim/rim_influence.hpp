// Compliance of a planet's rim: from the forces of rollers and teeth to the form of the race and the
// displacement of the teeth.
#pragma once

#include <Eigen/Core>

#include "gearset/mean_loads.hpp"
#include "gearset/rim/sector_body.hpp"
#include "gearset/working_geometry.hpp"
#include "mechanics/material.hpp"

namespace orbearing::gearset::rim {

/// Displacement of the race along its radius, w(phi) = sum over n of cosine_n cos(n phi) + sine_n sin(n phi);
/// phi from the outward direction towards the carrier's rotation. Waves of order 1 are displacements of the
/// planet and stay zero.
struct RaceForm {
  Eigen::ArrayXd cosine;  // [m/N]  (orders 0, 1, ...)
  Eigen::ArrayXd sine;    // [m/N]
};

/// Influence functions of a planet's rim, as means over the positions of its teeth. Eqs. (1) to (5) of
/// gearset/rim/README.md.
struct RimInfluence {
  /// [m/N]  (orders)  c_n: a radial force at phi' displaces the race at phi by sum c_n cos(n (phi - phi')).
  /// Without the deflection of a half-space under the force, which belongs to the contact.
  Eigen::ArrayXd race;
  RaceForm by_sun;   // by 1 N of the sun mesh along its line of action; the sun drives the carrier on
  RaceForm by_ring;  // by 1 N of the ring mesh
  /// [m/N]  displacements of the teeth along both lines of action (sun, ring) by the forces of both meshes,
  /// beyond those on a race that is held rigidly.
  Eigen::Matrix2d meshes = Eigen::Matrix2d::Zero();
};

/// The section of a planet. `race_radius`, `ring_width` as in RimSection.
RimSection rim_section(const PlanetarySet& set, const WorkingGeometry& geometry, double race_radius,
                       double ring_width);

/// Waves up to order `most_order` of the race, teeth loaded at their pitch points.
RimInfluence rim_influence(const RimSection& section, const WorkingGeometry& geometry,
                           const mechanics::Material& material, int most_order = 12,
                           const Fineness& fineness = {});

}  // namespace orbearing::gearset::rim
