// Friction torque of a rolling bearing by formulas of others: each law once. They need no motion, no contact
// and no load of an element, and are listed next to the program's results from all three.
//
// Constants hold in N, N mm, mm, mm^2/s and rpm; arguments and results are SI. d_m = (d + D)/2, nu kinematic
// viscosity, n speed.
//
//   Palmgren [Palmgren1959], and ISO/TR 14179-2 [ISOTR14179] with factors of its own
//     (1)  M_0 = 1e-7 f_0 (nu n)^(2/3) d_m^3, 160e-7 f_0 d_m^3 where nu n < 2000
//     (2)  M_1 = f_1 P_1 d_m;   balls f_1 = z (P_0/C_0)^y
//   SKF [SKF6000]
//     (3)  M_rr = phi_ish phi_rs G_rr (nu n)^0.6
//     (4)  M_sl = G_sl mu_sl,   mu_sl = phi_bl 0.15 + (1 - phi_bl) mu_EHL
//     (5)  phi_ish = 1/(1 + 1.84e-9 (n d_m)^1.28 nu^0.64)
//     (6)  phi_rs = exp(-K_rs nu n (d + D) sqrt(K_Z/(2 (D - d)))),  K_rs = 3e-8: oil jet, low oil bath
//     (7)  phi_bl = exp(-2.6e-8 (n nu)^1.4 d_m)
//     deep groove      G_rr = R_1 d_m^1.96 (F_r + R_2 F_a/sin a_F)^0.54,  a_F = 24.6 deg (F_a/C_0)^0.24
//                      G_sl = S_1 d_m^-0.145 (F_r^5 + S_2 d_m^1.5 F_a^4/sin a_F)^(1/3);
//                      F_a = 0: S_1 d_m^-0.26 F_r^(5/3)
//     angular contact  G_rr = R_1 d_m^1.97 (F_r + F_g + R_2 F_a)^0.54,  F_g = R_3 d_m^4 n^2
//                      G_sl = S_1 d_m^0.26 ((F_r + F_g)^(4/3) + S_2 F_a^(4/3))
//     cylindrical      G_rr = R_1 d_m^2.41 F_r^0.31,  G_sl = S_2 d_m F_r
//
// Drag of an oil bath by SKF is given in a diagram only and is left out.
#pragma once

#include "bearing/life/basic_life.hpp"

namespace orbearing::bearing::friction {

/// Families of which the formulas have constants.
enum class TorqueFamily { deep_groove, angular_contact, cylindrical, full_complement };

/// A bearing by its boundary dimensions and its series.
struct BearingSize {
  TorqueFamily family = TorqueFamily::deep_groove;
  double bore = 0.0;             // [m]  d
  double outside = 0.0;          // [m]  D
  double width = 0.0;            // [m]  B
  double static_capacity = 0.0;  // [N]  C_0
  int diameter_series = 2;       // [-]  of ISO 15
  bool wide = false;             // of width series 2 and above: 20, 22, 23

  double mean_diameter() const { return 0.5 * (bore + outside); }  // [m]  d_m

  bool operator==(const BearingSize&) const = default;
};

/// Operating condition in the formulas.
struct TorqueCondition {
  double speed = 0.0;      // [rad/s]  of the rings against each other
  double viscosity = 0.0;  // [m^2/s]  kinematic, at running temperature
  double radial = 0.0;     // [N]
  double axial = 0.0;      // [N]
};

/// Torque by its load-free and its load-dependent part.
struct TorqueParts {
  double load_free = 0.0;       // [N m]  M_0
  double load_dependent = 0.0;  // [N m]  M_1

  double total() const { return load_free + load_dependent; }
};

/// Factors of Eqs. (1) and (2).
struct TorqueFactors {
  double load_free = 0.0;       // [-]  f_0
  double load_dependent = 0.0;  // [-]  f_1, at the load
  double load = 0.0;            // [N]  P_1
};

/// Factors for an oil bath, by series, as in a catalogue [Schaeffler2012].
TorqueFactors palmgren_factors(const BearingSize& size, const TorqueCondition& at);
/// By type only [ISOTR14179].
TorqueFactors gear_unit_factors(const BearingSize& size, const TorqueCondition& at);
/// Eqs. (1) and (2).
TorqueParts torque_parts(const TorqueFactors& factors, double mean_diameter, const TorqueCondition& at);

struct SkfTorque {
  double rolling = 0.0;         // [N m]  M_rr, both factors in it
  double sliding = 0.0;         // [N m]  M_sl
  double inlet_heating = 1.0;   // [-]    phi_ish
  double starvation = 1.0;      // [-]    phi_rs
  double boundary_share = 0.0;  // [-]    phi_bl

  double total() const { return rolling + sliding; }
};

/// Eq. (5). `mean_diameter` [m]
double inlet_heating_factor(double mean_diameter, const TorqueCondition& at);
/// K_Z [-] of Eq. (6).
double type_constant(TorqueFamily family);
/// Eq. (6), of a constant K_Z [-] of the type of bearing.
double starvation_factor(double bore, double outside, double type_constant, const TorqueCondition& at);
/// Eqs. (3) to (7). Series above 3 have the constants of 4.
SkfTorque skf_torque(const BearingSize& size, const TorqueCondition& at);

}  // namespace orbearing::bearing::friction
