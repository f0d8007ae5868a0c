// Laws of friction in a race contact, by name. No header of a library here: files compiled for special
// instruction sets include it.
#pragma once

namespace orbearing::bearing {

/// Friction in a race contact as a function of the sliding speed.
enum class TractionLaw {
  regularised_coulomb,  // mu Q s / sqrt(s^2 + s_0^2), Eq. (17) of [Gai2025]
  limiting_shear,       // mu Q (1 - exp(-|s| / s_c)) sign(s), film sheared up to its limiting stress
                        // [BairWiner1979]
  ree_eyring,           // film that thins by shear before its limit [JohnsonTevaarwerk1977]; of balls only
};
inline constexpr int kTractionLaws = 1 + static_cast<int>(TractionLaw::ree_eyring);

/// Nature of a traction model; the checks, the inputs used and the equations follow from it.
struct TractionNature {
  const char* name;  // in a case
  bool of_rollers;   // rollers have it; balls have all
  bool shears_oil;   // it needs oil and the limiting friction; else the friction of the surfaces
};

[[gnu::always_inline]] constexpr TractionNature nature_of(TractionLaw law) {
  switch (law) {
    case TractionLaw::regularised_coulomb:
      return {.name = "regularised-coulomb", .of_rollers = true, .shears_oil = false};
    case TractionLaw::limiting_shear:
      return {.name = "limiting-shear", .of_rollers = true, .shears_oil = true};
    case TractionLaw::ree_eyring:
      return {.name = "ree-eyring", .of_rollers = false, .shears_oil = true};
  }
  __builtin_trap();  // no law has another value
}

}  // namespace orbearing::bearing
