// Seats of bearings by their tolerance classes [ISO286], and the interference of bearings of normal accuracy
// on them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace orbearing::bearing::catalogue {

/// Both ends [m], of diameters.
struct Deviations {
  double least = 0.0;
  double most = 0.0;

  double middle() const { return 0.5 * (least + most); }
};

/// Classes of shafts ("k5") and of holes ("N6") that are known here: g h js k m n p in grades 5 to 7, and
/// their capitals in grades 6 and 7.
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
