// A planetary drivetrain as participants: its gear set, and every bearing of every planet.
//
// Each mass and spring once: the gear set has the planets with the outer rings of their bearings and all
// their inertial loads; a bearing has rollers, cage, pin ring and the support of its pin.
#pragma once

#include <memory>
#include <vector>

#include "coupling/cosim/bearing_participant.hpp"
#include "coupling/cosim/coupled_run.hpp"
#include "coupling/cosim/gears_participant.hpp"
#include "coupling/study/drivetrain.hpp"

namespace orbearing::cosim {

struct PlanetaryCouplingOptions {
  double allowed_share = 1e-4;          // [-]    error of a step of the gears over the mean mesh deflection
  double allowed_length_error = 2e-10;  // [m]    of a step of a bearing
  bool gears_on_springs = false;        // for a one-way exchange: the gears hold themselves
};

struct PlanetaryCoupling {
  std::unique_ptr<GearsParticipant> gears;
  std::vector<std::unique_ptr<BearingParticipant>> bearings;  // those of planet 1, then of planet 2, ...

  /// Gears first.
  Participants participants() const;
};

/// Operation of the gear set, the run-up of the drivetrain included.
gearset::dynamics::Operation operation_of(const study::PlanetaryDrivetrain& drivetrain);

/// What the participants are made of. Bearings of one planet are a share of a roller pitch apart: half of it
/// where there are two. Throws std::invalid_argument where the drivetrain has no `gear_set`, or is one of
/// several sets.
DrivenGearsSetup gears_setup(const study::PlanetaryDrivetrain& drivetrain,
                             const PlanetaryCouplingOptions& options);
DrivenBearingSetup bearing_setup(const study::PlanetaryDrivetrain& drivetrain,
                                 const study::DrivetrainGeometry& geometry, int bearing_of_planet,
                                 const PlanetaryCouplingOptions& options);

PlanetaryCoupling planetary_coupling(const study::PlanetaryDrivetrain& drivetrain,
                                     const study::DrivetrainGeometry& geometry,
                                     const PlanetaryCouplingOptions& options);

}  // namespace orbearing::cosim
