// A planetary drivetrain as participants: its gear set, and every bearing of every planet.
//
// Each mass and spring once: the gear set has the planets with the outer rings of their bearings and all
// their inertial loads; a bearing has rollers, cage, pin ring and the support of its pin.
#pragma once

#include <memory>
#include <vector>

#include "coupling/cosim/bearing_participant.hpp"
#include "coupling/cosim/coupled_model.hpp"
#include "coupling/cosim/coupled_run.hpp"
#include "coupling/cosim/gears_participant.hpp"

namespace orbearing::cosim {

struct PlanetaryCoupling {
  std::unique_ptr<GearsParticipant> gears;
  std::vector<std::unique_ptr<BearingParticipant>> bearings;  // those of planet 1, then of planet 2, ...

  /// Gears first.
  Participants participants() const;
};

/// For a one-way exchange the gears of `setup` are on springs (not coupled). Throws std::invalid_argument,
/// with what was found and what is required, as the machines do.
PlanetaryCoupling planetary_coupling(const CoupledSetup& setup);

}  // namespace orbearing::cosim
