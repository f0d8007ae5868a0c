// Capacities of radial roller bearings, [ISO281] and [ISO16281].
#pragma once

#include "bearing/life/ball_capacity.hpp"

namespace orbearing::bearing::rating {

/// Data of a radial roller bearing for its ratings.
struct RollerSet {
  int rows = 1;                  // [-]
  int rollers = 0;               // [-]    in one row
  double diameter = 0.0;         // [m]    of a roller
  double length = 0.0;           // [m]    effective contact length
  double pitch_diameter = 0.0;   // [m]
  double contact_angle = 0.0;    // [rad]
  double material_factor = 1.1;  // [-]   b_m: 1.1 for cylindrical rollers of today's steel
  double reduction_factor = 0.83;  // [-]   product lambda nu: load not shared evenly along the roller
};

/// The rating's view of a cylindrical roller bearing of one row.
RollerSet roller_set(const Bearing& bearing);

/// D cos(alpha)/d_m [-].
double gamma(const RollerSet& set);

/// Factor f_c of [ISO281] [N, mm], of which the standard prints a table over `gamma` in (0, 1).
double roller_capacity_factor(double gamma, double reduction_factor = 0.83);

/// Basic dynamic radial load rating C_r [N].
double dynamic_capacity(const RollerSet& set);

/// Basic static radial load rating C_0r [N], [ISO76].
double static_capacity(const RollerSet& set);

/// Capacities [N] of one roller on either race, of a bearing whose load rating is `dynamic_capacity` [N].
/// The reduction factor is taken out of it again: laminae see for themselves how the load lies along the
/// roller.
ContactCapacities contact_capacities(const RollerSet& set, double dynamic_capacity);

/// Capacity [N] of one of `laminae` laminae of a contact.
double lamina_capacity(double contact_capacity, int laminae);

}  // namespace orbearing::bearing::rating
