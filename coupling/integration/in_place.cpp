#include "coupling/integration/in_place.hpp"

#include <algorithm>
#include <sstream>

namespace orbearing::integration {

// A bar that has moved by half the thickness of its rollers holds them no longer; a roller that stands off
// the pitch circle of the displaced rings by as much is on the other side of a race.
std::string out_of_place(const bearing::dynamics::BearingModel& model,
                         const Eigen::Ref<const Eigen::VectorXd>& x) {
  const auto now = bearing::dynamics::state_views(model.layout, x.data());
  const double limit = model.geometry.roller_radius;
  const double cage = (now.cage_position - now.pin_position).norm();
  std::ostringstream text;
  if (cage > limit)
    text << "the cage came out: it stands " << cage << " m beside the pin";
  else if (const double off = (now.radius - model.geometry.pitch_radius).abs().maxCoeff(),
           rings = std::max(now.pin_position.norm(), now.bore_position.norm());
           off > limit + rings)
    text << "a roller came out: it stands " << off << " m off the pitch circle";
  else
    return {};
  text << "; required: at most the radius of a roller, " << limit << " m";
  return text.str();
}

}  // namespace orbearing::integration
