// Random bearings cut into laminae, with profiles and a tilted bore, the same in every run.
#pragma once

#include <cmath>
#include <random>

#include "bearing/profile/profile.hpp"
#include "tests/random_bearings.hpp"

namespace orbearing::bearing {

class RandomLaminae {
 public:
  /// Any number of laminae, any kind of profile on rollers and races, tilts up to 3 mrad.
  Draw next() {
    Draw draw = bearings_.next();
    draw.bearing.rollers().laminae = std::uniform_int_distribution<int>(1, 60)(engine_);
    draw.bearing.rollers().profile = profile(draw.bearing);
    if (between(0.0, 1.0) < 0.3) draw.bearing.inner.profile = profile(draw.bearing);
    if (between(0.0, 1.0) < 0.3) draw.bearing.outer.profile = profile(draw.bearing);
    draw.point.bore_tilt = {between(-3e-3, 3e-3), between(-3e-3, 3e-3)};
    if (between(0.0, 1.0) < 0.2) draw.point.bore_tilt.setZero();
    return draw;
  }

  double between(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(engine_);
  }

 private:
  profile::Profile profile(const Bearing& bearing) {
    const double l = bearing.rollers().length, drop = std::pow(10.0, between(-7.0, -4.3));
    const profile::DesignLoad design{std::pow(10.0, between(1.0, 4.0)), l, 0.4 * bearing.rollers().diameter,
                                     bearing.material};
    switch (std::uniform_int_distribution<int>(0, 7)(engine_)) {
      case 0:
        return profile::Chamfer{l, between(0.02, 0.5) * l, drop};
      case 1:
        return profile::CircularCrown{l, drop};
      case 2:
        return profile::StraightCircular{l, between(0.0, 0.9) * l, drop};
      case 3:
        return profile::lundberg_for(design);
      case 4:
        return profile::johns_gohar_for(design);
      case 5:
        return profile::Iso16281{l, bearing.rollers().diameter, between(0.0, 3.0)};
      case 6:
        return profile::fujiwara_kawase_for(design, between(0.5, 3.0), between(0.1, 1.0), drop);
      default:
        return profile::Straight{};
    }
  }

  RandomBearings bearings_;
  std::mt19937_64 engine_{kSeed + 1};
};

}  // namespace orbearing::bearing
