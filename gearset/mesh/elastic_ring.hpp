// The body of a gear as an elastic ring, held rigidly at one edge and loaded at the other under a tooth.
#pragma once

#include "gearset/mesh/foundation.hpp"

namespace orbearing::gearset {

/// The coefficients of Eq. (6) of gearset/mesh/README.md for a ring in plane strain, by Fourier series of the
/// exact solution [Muskhelishvili1953]: linear normal and constant shear stress over the root of one tooth,
/// displacement and rotation taken at its middle. It is the problem that [Sainsot2004] solved for a bore that
/// is held, and agrees with the polynomials where they hold; it also serves thin rims, and the ring gear,
/// held at its outside and loaded within.
/// @param poisson_ratio [-] below 0.5
/// @throws std::domain_error if the ring has no thickness
FoundationCoefficients elastic_ring_coefficients(const FoundationBody& body, double poisson_ratio);

}  // namespace orbearing::gearset
