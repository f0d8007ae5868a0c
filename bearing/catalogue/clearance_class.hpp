// Clearance of a bearing on the shelf by its class, [ISO5753].
#pragma once

#include "bearing/catalogue/entries.hpp"
#include "mechanics/described.hpp"

namespace orbearing::bearing::catalogue {

/// CN is the normal one; C2 is smaller, C3 to C5 are larger.
enum class ClearanceClass { c2, cn, c3, c4, c5 };

constexpr described::Names<ClearanceClass, 5> names_of(ClearanceClass) {
  return {{{ClearanceClass::c2, "C2"},
           {ClearanceClass::cn, "CN"},
           {ClearanceClass::c3, "C3"},
           {ClearanceClass::c4, "C4"},
           {ClearanceClass::c5, "C5"}}};
}

/// Both ends [m], of diameters.
struct ClearanceRange {
  double least = 0.0;
  double most = 0.0;

  double middle() const { return 0.5 * (least + most); }
};

/// Range of `which` in a bearing of this bore [m]: of deep-groove balls, or of cylindrical rollers with a
/// cylindrical bore. The tables are read in [NSKE1102], 9.9 and 9.14. Throws std::invalid_argument for a bore
/// outside (10, 200] mm, and for angular contact, which has no such classes.
ClearanceRange clearance_range(Family family, ClearanceClass which, double bore);

}  // namespace orbearing::bearing::catalogue
