// The lands of a ring that guide the cage, from what the user states; their law: contact/land_law.hpp.
#pragma once

#include <optional>

#include "bearing/contact/land_law.hpp"
#include "bearing/motion/parameters.hpp"

namespace orbearing::bearing::motion {

/// Lands that guide a cage, and what they do together.
struct GuidingLands {
  double width = 0.0;  // [m]  of one
  LandLaw law;
};

/// `lands` of them, in oil of `viscosity` [Pa s]; none where no diameter of theirs is given. Throws
/// std::invalid_argument where they have no clearance or no width.
std::optional<GuidingLands> guiding_lands(const Bearing& bearing, const CageParameters& given, int lands,
                                          double viscosity, double sliding_scale);

}  // namespace orbearing::bearing::motion
