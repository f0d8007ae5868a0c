// The formula of each kind of profile. Called through bearing/profile/profile.hpp.
#pragma once

#include "bearing/profile/profile.hpp"

namespace orbearing::bearing::profile {

Relief relief_of(const Straight& profile, double x);
Relief relief_of(const Chamfer& profile, double x);
Relief relief_of(const CircularCrown& profile, double x);
Relief relief_of(const StraightCircular& profile, double x);
Relief relief_of(const Lundberg& profile, double x);
Relief relief_of(const JohnsGohar& profile, double x);
Relief relief_of(const Iso16281& profile, double x);
Relief relief_of(const FujiwaraKawase& profile, double x);
Relief relief_of(const Table& profile, double x);

}  // namespace orbearing::bearing::profile
