// Resonances: intersections of the harmonics of the mesh frequency with natural frequencies of a gear set.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "gearset/dynamics/modes.hpp"
#include "gearset/parameters.hpp"

namespace orbearing::diagnosis {

/// A vibrating mode by the name under which it is shown.
struct NamedFrequency {
  std::string name;  // "T1": the lowest translational pair of the set at rest; at speed a pair splits
  gearset::dynamics::ModeKind kind = gearset::dynamics::ModeKind::rotational;
  int rank = 0;            // among the vibrating modes of its kind
  double frequency = 0.0;  // [Hz]
};

/// Name of the mode with that rank in its kind.
std::string mode_name(gearset::dynamics::ModeKind kind, int rank, int planets);

/// The modes of a set less its free rotations, ascending as given.
std::vector<NamedFrequency> named_frequencies(const std::vector<gearset::dynamics::Mode>& modes, int planets);

/// Natural frequencies and mesh frequency at one speed.
struct ModesAtSpeed {
  double speed = 0.0;           // [rad/s]  of the driving member
  double mesh_frequency = 0.0;  // [Hz]
  std::vector<NamedFrequency> modes;
};

/// Modes of gears in the carrier's frame, whose driving member has that speed [rad/s].
ModesAtSpeed named_modes_at(double speed, const gearset::dynamics::SetModel& model);

/// A meeting of a harmonic and a mode.
struct Meeting {
  int order = 0;
  NamedFrequency mode;   // frequency: of the harmonic where they meet
  double speed = 0.0;    // [rad/s]
  double change = 0.0;   // [Hz]  of the mode from 0.01 % below that speed to 0.01 % above
  bool excited = false;  // whether the meshes can excite it; Eq. (14) of gearset/dynamics
};

/// Modes at a speed [rad/s]; throws std::runtime_error if the bearings have no equilibrium.
using ModesAt = std::function<ModesAtSpeed(double speed)>;

/// All meetings of harmonics 1 to 4 between the first and the last of `points`, by order, then by speed.
/// `points` say between which of them a meeting is; it is found by the modes at its own speed. Left out where
/// these cannot be computed.
/// @param set whose teeth and planet angles determine the excited modes
std::vector<Meeting> meetings(const std::vector<ModesAtSpeed>& points, const gearset::PlanetarySet& set,
                              const ModesAt& modes_at);

/// Meetings that the meshes excite between two speeds [rad/s] and half as much beyond, ascending. Speeds at
/// which the bearings have no equilibrium are left out.
std::vector<Meeting> resonances(double lowest, double highest, const gearset::PlanetarySet& set,
                                const ModesAt& modes_at);

/// Whether two speeds are within a factor of one and a half.
bool is_near(double one, double other);

}  // namespace orbearing::diagnosis
