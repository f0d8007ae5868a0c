#include "bearing/motion/mixed_lubrication.hpp"

namespace orbearing::bearing::dynamics {

double MixedLubrication::shared(double film_traction, double load, double sliding, double entrainment) const {
  const double share = asperity_share(film.at(load, entrainment) / roughness);
  return share * regularised_friction(friction, load, sliding, sliding_scale) + (1.0 - share) * film_traction;
}

}  // namespace orbearing::bearing::dynamics
