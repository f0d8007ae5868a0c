// Cylindrical roller bearing cut into laminae under a static load, without inertia, [ISO16281]. The contact
// law of the bearing is taken for both contacts of a roller in series; its cage, rings and forms play no
// part.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "bearing/laminae/lamina_contact.hpp"
#include "bearing/parameters.hpp"
#include "bearing/static_load/convex_balance.hpp"

namespace orbearing::bearing::static_load {

/// Load on the inner ring. The radial load points to the first roller; a positive tilt presses the rollers
/// there at negative x.
struct RollerBearingLoad {
  double radial = 0.0;         // [N]
  double moment = 0.0;         // [N m]  in the plane of the radial load
  std::optional<double> tilt;  // [rad]  given in place of the moment; none: free
};

/// Displacement of the inner ring from the concentric position, and lamina loads, the same on both races.
struct RollerBearingState {
  double radial = 0.0;          // [m]    along the radial load
  double lateral = 0.0;         // [m]    across it
  double tilt = 0.0;            // [rad]  in the plane of the radial load
  double lateral_tilt = 0.0;    // [rad]
  double moment = 0.0;          // [N m]  on the ring in that plane: given, or holding the given tilt
  Eigen::ArrayXXd lamina_load;  // [N]    (laminae, rollers)
  Eigen::ArrayXd roller_load;   // [N]    (rollers)
  BalanceReport report;
};

/// Throws std::invalid_argument where there are no laminae or a profile has no meaning.
RollerBearingState static_state(const CylindricalRollerBearing& bearing, const RollerBearingLoad& load);

/// What does not change with the load: both contacts of a roller as one, and where the rollers stand.
struct StaticRollers {
  laminae::LaminaContact contact;  // c_L in all, drops of both contacts
  double clearance = 0.0;          // [m]  diametral
  Eigen::ArrayXd cosine;           // (rollers)
  Eigen::ArrayXd sine;             // (rollers)
};

StaticRollers static_rollers(const CylindricalRollerBearing& bearing);

/// Load on the coordinates (radial, lateral, l/2 tan tilt, l/2 tan lateral tilt) at `place` [m], and its
/// stiffness; and the energy [J] they derive from.
RingForces<4> ring_forces(const StaticRollers& rollers, const Eigen::Vector4d& place);
double stored_energy(const StaticRollers& rollers, const Eigen::Vector4d& place);

}  // namespace orbearing::bearing::static_load
