// Constants of two elastic half-spaces in contact, one or both of which may end.
#pragma once

#include "bearing/pressure/contact.hpp"

namespace orbearing::bearing::half_space {

/// E* [Pa]: 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2. [Johnson1985]
double contact_modulus(const HalfSpaceContact& contact);

/// Factor psi [-] of the mirrored pressure of one body: 0 continuing, 1 mirrored, and for a corrected end
/// 1.29 - (0.08 - 0.5 nu)/(1 - nu), which makes up for the normal stress that the mirrored pressure leaves
/// on the end. [Guilbault2011]
double mirror_factor(EndSurface ends, double poisson_ratio);

/// Factor [-] of the mirrored pressure in the sum of both bodies' displacements: their factors weighted by
/// their compliances.
double mirror_factor(const HalfSpaceContact& contact);

/// Throws std::invalid_argument where `contact` has no meaning.
void require_sound(const HalfSpaceContact& contact);

}  // namespace orbearing::bearing::half_space
