// Where harmonics of the mesh frequency meet natural frequencies of a gear set.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/results/result_row.hpp"
#include "gearset/dynamics/modes.hpp"

namespace orbearing::app {

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
  double rpm = 0.0;             // [rpm]  of the driving member
  double mesh_frequency = 0.0;  // [Hz]
  std::vector<NamedFrequency> modes;
};

/// The modes of a case of one set with teeth, in the carrier's frame at that speed [rpm].
ModesAtSpeed modes_at_rpm(const ResolvedCase& resolved, double rpm);

/// A meeting of a harmonic and a mode.
struct Meeting {
  int order = 0;
  NamedFrequency mode;   // frequency: where they meet
  double rpm = 0.0;      // [rpm]
  bool excited = false;  // whether the meshes can excite it; Eq. (14) of gearset/dynamics
};

/// Modes at a speed [rpm]; throws std::runtime_error where the bearings find no balance.
using ModesAt = std::function<ModesAtSpeed(double rpm)>;

/// All meetings of harmonics 1 to 4 between the first and the last of `points`, by order, then by speed. `points`
/// say between which of them a meeting is; it is found by the modes at its own speed. Left out where these cannot
/// be computed.
/// @param set whose teeth and places of planets decide what is excited
std::vector<Meeting> meetings(const std::vector<ModesAtSpeed>& points, const gearset::PlanetarySet& set,
                              const ModesAt& modes_at);

/// Whether the motion of a case's bearings feels resonances of its gears: one set with bearings, whose meshes
/// vary. Several sets have no gear dynamics yet.
bool has_resonances(const ResolvedCase& resolved);

/// Resonances that the meshes excite between two speeds [rpm] and half as much beyond, ascending. Found by
/// the modes at fixed speeds, of which those are left out at which the bearings find no balance. The case
/// without its sweep.
std::vector<Resonance> resonances(const ResolvedCase& resolved, double lowest_rpm, double highest_rpm);

/// The one nearest to a speed [rad/s]; none where none is within a factor of one and a half.
std::optional<Resonance> nearest(const std::vector<Resonance>& resonances, double speed);

}  // namespace orbearing::app
