#include "bearing/catalogue/suffixes.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace orbearing::bearing::catalogue {

namespace {

constexpr const char *kInside = "reinforced inside", *kPolyamide = "cage of polyamide",
                     *kBrass = "cage of brass", *kSteel = "cage of sheet steel",
                     *kShield = "shield on one side", *kShields = "shields on both sides",
                     *kSeal = "seal on one side", *kSeals = "seals on both sides",
                     *kAccuracy = "class of accuracy", *kClearance = "class of clearance";

// As SKF, FAG, NSK and NTN print them in their lists of suffixes.
constexpr std::array kSuffixes{Suffix{"EC", kInside},
                               Suffix{"E", kInside},
                               Suffix{"ET", "reinforced inside, cage of polyamide"},
                               Suffix{"EW", "reinforced inside, cage of sheet steel"},
                               Suffix{"EM", "reinforced inside, cage of brass"},
                               Suffix{"P", kPolyamide},
                               Suffix{"TN", kPolyamide},
                               Suffix{"TN9", kPolyamide},
                               Suffix{"TVP", kPolyamide},
                               Suffix{"TVP2", kPolyamide},
                               Suffix{"TVH", kPolyamide},
                               Suffix{"T2X", kPolyamide},
                               Suffix{"M", kBrass},
                               Suffix{"MA", kBrass},
                               Suffix{"MB", kBrass},
                               Suffix{"ML", kBrass},
                               Suffix{"MP", kBrass},
                               Suffix{"M1", kBrass},
                               Suffix{"J", kSteel},
                               Suffix{"JP1", kSteel},
                               Suffix{"JP3", kSteel},
                               Suffix{"Y", "cage of sheet brass"},
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

}  // namespace orbearing::bearing::catalogue
