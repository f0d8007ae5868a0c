// Elastic line contact of a roller with one race: Q = K delta^(10/9).
#pragma once

#include "bearing/contact/line_law.hpp"
#include "bearing/parameters.hpp"

namespace orbearing::bearing {

/// One roller-to-race contact. Approaches are positive in contact; no tension.
class LineContact {
 public:
  static constexpr double kExponent = LineLaw::kExponent;  // of the load over the approach

  /// `stiffness` is K in [N/m^(10/9)].
  explicit LineContact(double stiffness);

  /// Load [N] at elastic approach `approach` [m].
  double load(double approach) const;
  /// Elastic approach [m] at load `load` [N] >= 0.
  double approach(double load) const;
  /// d(approach)/d(load) [m/N] at load > 0.
  double compliance(double load) const;
  /// The same at a load > 0 whose elastic approach [m] is known.
  static double compliance(double load, double approach) { return LineLaw::compliance(load, approach); }
  /// Tangent stiffness dQ/d(approach) [N/m].
  double stiffness(double approach) const;
  /// Stored energy [J].
  double energy(double approach) const;
  /// K [N/m^(10/9)].
  double constant() const { return stiffness_; }
  /// The same contact by `ratio` times its load and its approach over `ratio`.
  LineContact through_lever(double ratio) const;

 private:
  double stiffness_;      // [N/m^(10/9)]
  double inverse_power_;  // K^(-9/10)
};

/// Largest pressure [Pa] of a long roller on its race under `load` [N], after Hertz: sqrt(Q E' / (2 pi R l))
/// with the equivalent radius R [m], the effective length l [m] and E' = E / (1 - nu^2) [Pa]. [Harris2006]
double hertz_pressure(double load, double equivalent_radius, double length, const Material& material);

/// Contact of one roller of `length` [m] with one race: K = 8.06e4 l^(8/9) of Palmgren in N and mm, Eq. (13)
/// of [Gai2025], or 2^(10/9) times c_L = 35948 l^(8/9) of [ISO16281], which holds for both contacts in
/// series.
LineContact roller_race_contact(ContactLaw law, double length);

/// Both contacts of a roller, each `one` of them, as one between its races: each has half of the approach.
LineContact both_in_series(const LineContact& one);

}  // namespace orbearing::bearing
