// Letters and digits behind a designation that say how a bearing is made: 6210-2Z, NU 2207 ECP, 7208 BEP.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace orbearing::bearing::catalogue {

/// A suffix as several makers use it.
struct Suffix {
  std::string_view letters;
  std::string_view meaning;
  bool clearance = false;   // a class of ISO 5753
  std::string_view cage{};  // material as cage_material() names it; empty: not a suffix of cages
};

/// A designation without suffixes, and its suffixes in their order.
struct SuffixedName {
  std::string base;  // "NU 2207"
  std::vector<const Suffix*> suffixes;
};

/// All readings of a designation as a base and known suffixes, the longest base first. One without a suffix
/// is none of them.
std::vector<SuffixedName> suffixed_readings(std::string_view designation);

/// The suffix of a text that is nothing else, as "ET": those of a line of a catalogue. Null for others.
const Suffix* suffix_named(std::string_view letters);

}  // namespace orbearing::bearing::catalogue
