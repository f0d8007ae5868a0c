// Life by Lundberg and Palmgren of a bearing whose contacts are not cut, from roller loads [N] at places
// evenly spaced on each race.
#pragma once

#include "bearing/life/lamina_life.hpp"

namespace orbearing::bearing {

inline BearingLife whole_contact_life(const Bearing& bearing, double reduction_factor,
                                      const Eigen::ArrayXd& inner, const Eigen::ArrayXd& outer) {
  return life::lamina_life(life::lamina_rating(bearing, reduction_factor), inner.transpose(),
                           outer.transpose());
}

}  // namespace orbearing::bearing
