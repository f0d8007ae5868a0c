// Laws of friction in a race contact, by name. No header of a library here: files compiled for special
// instruction sets include it.
#pragma once

namespace orbearing::bearing {

/// Friction in a race contact as a function of the sliding speed. A new law is put before the last one.
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
  bool thins_oil;    // it has the stress at which the oil begins to thin
};

[[gnu::always_inline]] constexpr TractionNature nature_of(TractionLaw law) {
  switch (law) {
    case TractionLaw::regularised_coulomb:
      return {.name = "regularised-coulomb", .of_rollers = true, .shears_oil = false, .thins_oil = false};
    case TractionLaw::limiting_shear:
      return {.name = "limiting-shear", .of_rollers = true, .shears_oil = true, .thins_oil = false};
    case TractionLaw::ree_eyring:
      return {.name = "ree-eyring", .of_rollers = false, .shears_oil = true, .thins_oil = true};
  }
  __builtin_trap();  // no law has another value
}

/// Names of laws of one nature, as a condition on other inputs has them: "a|b".
struct LawNames {
  char text[128]{};
};
constexpr LawNames law_names(bool TractionNature::*nature, bool has_it = true, const char* between = "|") {
  LawNames names;
  int end = 0;
  const auto add = [&](const char* text) {
    for (; *text != 0; ++text) names.text[end++] = *text;
  };
  for (int i = 0; i < kTractionLaws; ++i) {
    const TractionNature one = nature_of(static_cast<TractionLaw>(i));
    if (one.*nature != has_it) continue;
    if (end > 0) add(between);
    add(one.name);
  }
  return names;
}
inline constexpr LawNames kLawsOfOil = law_names(&TractionNature::shears_oil),
                          kLawsOfSurfaces = law_names(&TractionNature::shears_oil, false),
                          kLawsOfThinnedOil = law_names(&TractionNature::thins_oil),
                          kRollerLaws = law_names(&TractionNature::of_rollers, true, " or ");

}  // namespace orbearing::bearing
