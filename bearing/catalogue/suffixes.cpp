#include "bearing/catalogue/suffixes.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace orbearing::bearing::catalogue {

namespace {

constexpr const char *kInside = "reinforced inside", *kShield = "shield on one side",
                     *kShields = "shields on both sides", *kSeal = "seal on one side",
                     *kSeals = "seals on both sides", *kAccuracy = "class of accuracy",
                     *kClearance = "class of clearance";

constexpr Suffix caged(std::string_view letters, std::string_view meaning, std::string_view material) {
  return {letters, meaning, false, material};
}
constexpr Suffix of_polyamide(std::string_view letters) {
  return caged(letters, "cage of polyamide", "polyamide");
}
constexpr Suffix of_brass(std::string_view letters) {
  return caged(letters, "cage of brass", "brass");
}
constexpr Suffix of_steel(std::string_view letters) {
  return caged(letters, "cage of sheet steel", "steel");
}

// As SKF, FAG, NSK and NTN print them in their lists of suffixes.
constexpr std::array kSuffixes{Suffix{"EC", kInside},
                               Suffix{"E", kInside},
                               caged("ET", "reinforced inside, cage of polyamide", "polyamide"),
                               caged("EW", "reinforced inside, cage of sheet steel", "steel"),
                               caged("EM", "reinforced inside, cage of brass", "brass"),
                               of_polyamide("P"),
                               of_polyamide("TN"),
                               of_polyamide("TN9"),
                               of_polyamide("TVP"),
                               of_polyamide("TVP2"),
                               of_polyamide("TVH"),
                               of_polyamide("T2X"),
                               of_brass("M"),
                               of_brass("MA"),
                               of_brass("MB"),
                               of_brass("ML"),
                               of_brass("MP"),
                               of_brass("M1"),
                               of_steel("J"),
                               of_steel("JP1"),
                               of_steel("JP3"),
                               caged("Y", "cage of sheet brass", "brass"),
                               Suffix{"Z", kShield},
                               Suffix{"2Z", kShields},
                               Suffix{"ZZ", kShields},
                               Suffix{"RS", kSeal},
                               Suffix{"RS1", kSeal},
                               Suffix{"RSH", kSeal},
                               Suffix{"RZ", kSeal},
                               Suffix{"2RS", kSeals},
                               Suffix{"2RS1", kSeals},
                               Suffix{"2RSR", kSeals},
                               Suffix{"2RSH", kSeals},
                               Suffix{"2RSL", kSeals},
                               Suffix{"2RZ", kSeals},
                               Suffix{"LLU", kSeals},
                               Suffix{"LLB", kSeals},
                               Suffix{"LLH", kSeals},
                               Suffix{"DDU", kSeals},
                               Suffix{"VV", kSeals},
                               Suffix{"P6", kAccuracy},
                               Suffix{"P5", kAccuracy},
                               Suffix{"P4", kAccuracy},
                               Suffix{"C2", kClearance, true},
                               Suffix{"CN", kClearance, true},
                               Suffix{"C3", kClearance, true},
                               Suffix{"C4", kClearance, true},
                               Suffix{"C5", kClearance, true}};

bool separates(char c) {
  return c == ' ' || c == '-' || c == '/' || c == '.';
}

// The tail as suffixes one behind the other, the longest first; none where a part of it is unknown.
std::optional<std::vector<const Suffix*>> suffixes_in(std::string_view tail) {
  while (!tail.empty() && separates(tail.front())) tail.remove_prefix(1);
  if (tail.empty()) return std::vector<const Suffix*>{};
  std::vector<const Suffix*> fitting;
  for (const Suffix& one : kSuffixes)
    if (tail.starts_with(one.letters)) fitting.push_back(&one);
  std::ranges::stable_sort(fitting, std::ranges::greater{},
                           [](const Suffix* one) { return one->letters.size(); });
  for (const Suffix* first : fitting)
    if (auto rest = suffixes_in(tail.substr(first->letters.size()))) {
      rest->insert(rest->begin(), first);
      return rest;
    }
  return std::nullopt;
}

}  // namespace

std::vector<SuffixedName> suffixed_readings(std::string_view designation) {
  std::vector<SuffixedName> readings;
  for (std::size_t length = designation.size(); length-- > 1;) {
    std::string_view base = designation.substr(0, length);
    if (separates(base.back())) continue;
    auto suffixes = suffixes_in(designation.substr(length));
    if (suffixes && !suffixes->empty()) readings.push_back({std::string(base), std::move(*suffixes)});
  }
  return readings;
}

const Suffix* suffix_named(std::string_view letters) {
  const auto found = std::ranges::find(kSuffixes, letters, &Suffix::letters);
  return found == kSuffixes.end() ? nullptr : &*found;
}

}  // namespace orbearing::bearing::catalogue
