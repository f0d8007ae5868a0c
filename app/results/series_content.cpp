#include "app/results/series_content.hpp"

#include "bearing/motion/layout.hpp"

namespace orbearing::app {

namespace {

struct RollerSeries {
  const char* name;
  const char* units;
  const char* meaning;
  const Eigen::ArrayXXd& values;
};

void add_rollers(const system::BearingSeries& series, PointContent& content) {
  const RollerSeries all[] = {
      {"roller_angle", "rad", "place of each roller in the carrier frame", series.angle},
      {"roller_inner_load", "N", "load on the inner race", series.inner_load},
      {"roller_outer_load", "N", "load on the outer race", series.outer_load},
      {"roller_inner_sliding", "m s-1", "surface speed of the inner race less that of the roller",
       series.inner_sliding},
      {"roller_outer_sliding", "m s-1", "surface speed of the outer race less that of the roller",
       series.outer_sliding},
      {"roller_inner_film", "m", "least film on the inner race", series.inner_film},
      {"roller_outer_film", "m", "least film on the outer race", series.outer_film},
      series.caged
          ? RollerSeries{"roller_pocket_load", "N",
                         "load on the cage bar, positive where the roller drives the cage",
                         series.pocket_load}
          : RollerSeries{"roller_neighbour_load", "N", "load on the roller ahead", series.neighbour_load},
      {"roller_spin", "rad s-1", "spin relative to the carrier", series.spin}};
  for (const RollerSeries& one : all)
    content.add(one.name, {"roller", "time"}, one.units, one.meaning, one.values);
}

}  // namespace

void add_series(const system::BearingSeries& series, PointContent& content) {
  if (series.time.size() == 0) return;
  content.add_dimension("time", series.time.size());
  content.add_dimension("roller", series.inner_load.rows());
  content.add_dimension("direction", 2);
  content.add("time", {"time"}, "s", "time since the start of the run", series.time);
  add_rollers(series, content);
  if (series.caged) {
    content.add("cage_position", {"direction", "time"}, "m",
                "cage centre, x outward and y in the sense of rotation", series.cage_position);
    content.add("cage_angle", {"time"}, "rad",
                "rotation of the cage in the carrier frame, grows without bound", series.orbit_angle);
    content.add("cage_speed", {"time"}, "rad s-1", "speed of the cage relative to the carrier",
                series.orbit_speed);
  } else {
    content.add("orbit_speed", {"time"}, "rad s-1",
                "mean orbital speed of the rollers relative to the carrier", series.orbit_speed);
  }
  content.add("power_loss_over_time", {"time"}, "W", "power lost in all", series.power_loss);
}

void add_final_state(const Eigen::VectorXd& state, const bearing::motion::StateLayout& layout,
                     PointContent& content) {
  if (state.size() == 0) return;
  std::string names;
  for (const std::string& name : bearing::motion::variable_names(layout))
    names += (names.empty() ? "" : ", ") + name;
  content.add_dimension("state", state.size());
  content.add(final_state_name, {"state"}, "1",
              "state at the end of the run, from which a neighbouring point may go on, in SI: " + names,
              state);
}

}  // namespace orbearing::app
