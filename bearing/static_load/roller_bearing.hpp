// Cylindrical roller bearing cut into laminae under a static load, without inertia, [ISO16281].
#pragma once

#include <Eigen/Core>
#include <optional>

#include "bearing/parameters.hpp"
#include "bearing/profile/profile.hpp"
#include "bearing/static_load/convex_balance.hpp"

namespace orbearing::bearing::static_load {

/// A bearing and how finely its contacts are cut. The contact law of the bearing is taken for both contacts
/// of a roller in series.
struct LaminaBearing {
  CylindricalRollerBearing bearing;
  int laminae = 40;
  profile::Profile roller_profile;  // on both contacts of a roller
};

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

/// Middles of the laminae [m] (laminae): ((k - 1/2)/n - 1/2) l.
Eigen::ArrayXd lamina_places(int laminae, double length);

/// Throws std::invalid_argument where there are no laminae or a profile has no meaning.
RollerBearingState static_state(const LaminaBearing& bearing, const RollerBearingLoad& load);

/// Laminae of all rollers with what does not change with the load; for tests, and for many loads.
struct LaminaContacts {
  double constant = 0.0;  // [N/m^(10/9)]  c_L/n of one lamina
  double lever = 0.0;     // [m]  of the tilt: half the roller's length
  Eigen::ArrayXd gap;     // [m]  (laminae)  s/2 + 2 P
  Eigen::ArrayXd place;   // [-]  (laminae)  x over the lever
  Eigen::ArrayXd cosine;  // (rollers)
  Eigen::ArrayXd sine;    // (rollers)
};

LaminaContacts lamina_contacts(const LaminaBearing& bearing);

/// Load on the coordinates (radial, lateral, lever x tan tilt, lever x tan lateral tilt) at `place` [m], and
/// its stiffness; and the energy [J] they derive from.
RingForces<4> ring_forces(const LaminaContacts& contacts, const Eigen::Vector4d& place);
double stored_energy(const LaminaContacts& contacts, const Eigen::Vector4d& place);

}  // namespace orbearing::bearing::static_load
