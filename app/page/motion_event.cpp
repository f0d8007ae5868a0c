#include "app/page/motion_event.hpp"

#include "app/units.hpp"
#include "bearing/motion/snapshot.hpp"

namespace orbearing::app::page {

namespace {

using Json = nlohmann::ordered_json;

Json list(const Eigen::ArrayXd& values) {
  return std::vector<double>(values.begin(), values.end());
}

}  // namespace

Json motion_event(const system::MotionProgress& now) {
  const bearing::motion::Snapshot& bearing = now.bearing;
  return {{"time_s", now.time},
          {"most_s", now.most},
          {"expected_s", now.expected},
          {"run", now.run},
          {"most_runs", now.most_runs},
          {"rolling_cage_rpm", kRpm * now.rolling_cage_speed},
          {"cage_rpm", kRpm * bearing.orbit_speed},
          {"cage_turned_deg", kDegree * bearing.orbit_angle},
          {"cage_um", {per_micro * bearing.cage_position.x(), per_micro * bearing.cage_position.y()}},
          {"angle_deg", list(kDegree * bearing.angle)},
          {"spin_rpm", list(kRpm * bearing.spin)},
          {"inner_load_N", list(bearing.inner.load)},
          {"outer_load_N", list(bearing.outer.load)}};
}

}  // namespace orbearing::app::page
