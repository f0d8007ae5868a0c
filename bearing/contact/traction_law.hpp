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

/// Nature of a traction model; the checks, the inputs used and the equations follow from it.
struct TractionNature {
  const char* name;  // in a case
  bool of_rollers;   // rollers have it; balls have all
  bool shears_oil;   // it needs oil and is led to the limiting friction; else the friction of the surfaces
  bool thins_oil;    // it has the stress at which the oil begins to thin
};

/// Without a name for a value that is no law.
[[gnu::always_inline]] constexpr TractionNature nature_or_none(TractionLaw law) {
  switch (law) {
    case TractionLaw::regularised_coulomb:
      return {.name = "regularised-coulomb", .of_rollers = true, .shears_oil = false, .thins_oil = false};
    case TractionLaw::limiting_shear:
      return {.name = "limiting-shear", .of_rollers = true, .shears_oil = true, .thins_oil = false};
    case TractionLaw::ree_eyring:
      return {.name = "ree-eyring", .of_rollers = false, .shears_oil = true, .thins_oil = true};
  }
  return {};
}

[[gnu::always_inline]] constexpr TractionNature nature_of(TractionLaw law) {
  const TractionNature nature = nature_or_none(law);
  if (nature.name == nullptr) __builtin_trap();  // no law has another value
  return nature;
}

inline constexpr int kTractionLaws = [] {
  int laws = 0;
  while (nature_or_none(static_cast<TractionLaw>(laws)).name != nullptr) ++laws;
  return laws;
}();

constexpr bool have_unlike_names() {
  const auto equal = [](const char* one, const char* other) {
    while (*one != 0 && *one == *other) ++one, ++other;
    return *one == *other;
  };
  for (int i = 0; i < kTractionLaws; ++i)
    for (int j = 0; j < i; ++j)
      if (equal(nature_of(static_cast<TractionLaw>(i)).name, nature_of(static_cast<TractionLaw>(j)).name))
        return false;
  return true;
}
static_assert(have_unlike_names());

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
