// Clearance of a bearing on the shelf by its class, [ISO5753].
#pragma once

#include <string>
#include <string_view>
#include <vector>

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

// Seats of bearings by their tolerance classes [ISO286], and the interference of bearings of normal accuracy
// on them.

/// Both ends [m], of diameters.
struct Deviations {
  double least = 0.0;
  double most = 0.0;

  double middle() const { return 0.5 * (least + most); }
};

/// Classes of shafts ("k5") and of holes ("N6") that are known here: g h js k m n p in grades 5 to 7, and
/// their capitals in grades 6 and 7; besides j5, j6, F7, H8, J6 and J7.
std::vector<std::string> shaft_classes();
std::vector<std::string> hole_classes();

/// By how much a shaft or a hole of that class may differ from its nominal diameter [m].
/// Throws std::invalid_argument for a diameter outside (3, 400] mm.
Deviations shaft_deviations(std::string_view shaft, double diameter);
Deviations hole_deviations(std::string_view hole, double diameter);

/// By how much the pin may be larger than the bore of an inner ring, or an outer ring larger than the bore it
/// sits in, [m] of diameters: of a bearing of normal accuracy [ISO492], whose bore and outside are at most as
/// large as stated. Negative: loose. Throws as above.
Deviations inner_interference(std::string_view shaft, double bore);
Deviations outer_interference(std::string_view hole, double outside_diameter);

}  // namespace orbearing::bearing::catalogue
