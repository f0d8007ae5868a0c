// Quasi-static bearing of cylindrical rollers in the frame of the carrier: the races settle where the roller
// loads, with all inertial loads of rollers and cage, balance the load on the bore. Contacts are whole, or
// cut into laminae: profiles, a bore that is tilted on its pin, and rollers that tilt between both.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "bearing/equilibrium/loads_by_position.hpp"
#include "bearing/equilibrium/quasi_static_state.hpp"
#include "bearing/equilibrium/race_equilibrium.hpp"
#include "bearing/geometry.hpp"
#include "bearing/operating_point.hpp"
#include "bearing/parameters.hpp"

namespace orbearing::bearing {

/// Settings of the method and selection of effects.
struct QuasiStaticOptions {
  InertiaSwitches inertia;
  std::optional<Lubricant> film;  // lubricant whose film enters the approach; none: dry
  int cage_positions = 16;        // cage angles over one roller pitch that are averaged
  double first_roller = 0.0;      // [rad]  position of the first roller at the first cage angle
};

/// Equilibria over one roller pitch of cage angles, gathered by position on the races. Arrays are over
/// positions, evenly spaced from first_roller on.
struct QuasiStaticResult : LoadsByPosition {
  Eigen::ArrayXd angle;                                    // [rad]
  Eigen::Vector2d displacement = Eigen::Vector2d::Zero();  // [m]    mean over the cage angles
  Eigen::ArrayXd race_form;                          // [m]  outward displacement of an elastic outer race,
                                                     //      mean over the cage angles
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();  // [N m]  that holds the tilt, mean
  Eigen::Vector2d total_bore_load = Eigen::Vector2d::Zero();  // [N]    with what cage and rollers add
  SolverReport report;                                        // the worst over the cage angles
  std::vector<QuasiStaticState> states;                       // (cage angles)
};

/// Throws std::invalid_argument where a load, a tilt or a speed is not finite.
void require_finite(const OperatingPoint& point);

/// Load [N] that cage and rollers add to the ring that guides the cage: the cage's inertial load and the
/// tangential halves of the rollers', which reach it through the pockets.
Eigen::Vector2d load_through_cage(const Bearing& bearing, const BearingGeometry& geometry,
                                  const CarrierMotion& carrier, const InertiaSwitches& inertia);

/// Load [N] on the outer ring with what reaches it through the cage, where it guides the cage.
Eigen::Vector2d total_bore_load(const Bearing& bearing, const BearingGeometry& geometry,
                                const OperatingPoint& point, const InertiaSwitches& inertia);

/// Equilibrium problem with the first roller at `first_roller` [rad]. Throws std::invalid_argument where a
/// load, a tilt or a speed is not finite.
RaceEquilibrium quasi_static_problem(const Bearing& bearing, const BearingGeometry& geometry,
                                     const OperatingPoint& point, const QuasiStaticOptions& options,
                                     double first_roller);

/// Throws std::invalid_argument where rollers are unequal or waves turn with a race.
void require_equal_pitches(const Bearing& bearing);

/// `all` becomes the worse of both.
void keep_worst(const SolverReport& one, SolverReport& all);

/// The same on the laminae of a bearing, which outlives the problem, its tilt that of the point.
RaceEquilibrium quasi_static_problem(const laminae::LaminaBearing& bearing, const OperatingPoint& point,
                                     const QuasiStaticOptions& options, double first_roller);

/// Equilibrium with the first roller at `first_roller` [rad]; the search starts from `near` where one is
/// given. The tilt of the bore is that of the point: forces are in equilibrium, the moment that holds the
/// tilt is a result. Races that are not round have their position at t = 0; the small tangential part of
/// their contact forces, of the order amplitude * order / radius, is left out.
QuasiStaticState quasi_static_state(const laminae::LaminaBearing& bearing, const OperatingPoint& point,
                                    const QuasiStaticOptions& options, double first_roller,
                                    const QuasiStaticState* near = nullptr);

/// The same on whole contacts, whatever laminae are stated.
QuasiStaticState quasi_static_state(const Bearing& bearing, const OperatingPoint& point,
                                    const QuasiStaticOptions& options, double first_roller);

/// A result over one roller pitch without loads yet, and what the balance at cage angle `position` of
/// `positions` adds to it: loads by position, means, the worst report, the state itself.
QuasiStaticResult empty_result(const laminae::LaminaBearing& bearing, const OperatingPoint& point,
                               const QuasiStaticOptions& options);
void put_position(const laminae::LaminaBearing& bearing, QuasiStaticState state, Eigen::Index position,
                  Eigen::Index positions, QuasiStaticResult& result);

/// Equilibria over one roller pitch. Throws std::invalid_argument where a load or speed is not finite, and
/// where rollers are unequal or waves turn with a race: then no pitch is like the next.
QuasiStaticResult quasi_static_bearing(const laminae::LaminaBearing& bearing, const OperatingPoint& point,
                                       const QuasiStaticOptions& options);

/// The same on whole contacts, whatever laminae are stated.
QuasiStaticResult quasi_static_bearing(const Bearing& bearing, const OperatingPoint& point,
                                       const QuasiStaticOptions& options);

}  // namespace orbearing::bearing
