// Both contacts of a roller cut into laminae, in motion. The roller's tilt is a variable of its motion: the
// unbalanced moment of both contacts turns it against a resistance, such as that of the oil squeezed out at
// its ends. Its inertia is left out, since its tilting vibration (some 100 kHz) is far above all others. The
// value of the resistance has little effect for the same reason: the roller reaches the equilibrium of both
// contacts within some microseconds.
//
// The film of the straight contact turns the approach into the elastic approach in the middle; the laminae
// take that, so that a straight roller that is not tilted has the loads of the line contact. The moment of a
// roller against the change of the races' tilt over its orbit, of the order of the tilt squared, is left out.
#pragma once

#include "bearing/contact/lamina_contact.hpp"
#include "bearing/plane.hpp"

namespace orbearing::bearing::motion {

/// Approaches of both contacts of a roller, which determine the loads of their laminae.
struct RollerApproaches {
  double inner_approach = 0.0;  // [m]  elastic, in the middle of the roller
  double outer_approach = 0.0;  // [m]
  double end_displacement =
      0.0;  // [m]  displacement of the roller at x = l/2 further outward than in the middle
};

/// Elastic loads of both contacts of a roller.
struct LaminaRaceLoads {
  double inner = 0.0;           // [N]
  double outer = 0.0;           // [N]
  double excess = 0.0;          // [N]  moment that turns the roller towards +end displacement, over l/2
  double outer_end_load = 0.0;  // [N]  moment of the outer contact about its middle, over l/2
};

class LaminaRaces {
 public:
  /// `bore_tilt` [rad]: the bore is further outward at +x along this direction, as in OperatingPoint.
  LaminaRaces(laminae::LaminaContact inner, laminae::LaminaContact outer, const Vector2& bore_tilt);

  /// Loads of a roller in direction `outward`.
  LaminaRaceLoads loads(const RollerApproaches& approaches, const Vector2& outward) const;
  /// Elastic energy [J]; its slopes by the approaches are the loads, that by the end displacement is -excess.
  double energy(const RollerApproaches& approaches, const Vector2& outward) const;
  /// The end displacement [m] of equilibrium of both contacts at the elastic approaches [m] in the middle of
  /// a roller; with one contact only, that of the race it touches.
  double balanced_end_displacement(double inner_approach, double outer_approach,
                                   const Vector2& outward) const;
  /// Resistance to tilting [N s/m]: rate of the end displacement = excess / resistance.
  double resistance() const { return resistance_; }

  const laminae::LaminaContact& inner() const { return inner_; }
  const laminae::LaminaContact& outer() const { return outer_; }
  /// Loads [N] of the laminae of one contact, into an array of that many, of a roller in direction `outward`.
  void put_loads(Race race, const RollerApproaches& approaches, const Vector2& outward, double* load) const;
  /// Whether all laminae of a contact carry alike, whatever the loads: nothing tilts and nothing falls away.
  bool even() const { return even_; }

  /// Displacement of the bore at x = l/2 further outward than in the middle, for each direction [m].
  const Vector2& bore_end_displacement() const { return bore_end_displacement_; }
  /// Whether no roller ever tilts: the bore is not tilted and the profiles are symmetric.
  bool upright() const { return upright_; }

 private:
  laminae::LaminaContact inner_;
  laminae::LaminaContact outer_;
  Vector2 bore_end_displacement_;  // [m]
  double resistance_;              // [N s/m]
  bool upright_;
  bool even_;
};

}  // namespace orbearing::bearing::motion
