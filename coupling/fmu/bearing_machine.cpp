// The planet bearing behind the C interface.
#include "coupling/fmu/bearing_fields.hpp"
#include "coupling/fmu/machine.hpp"
#include "coupling/system/driven_bearing.hpp"

namespace orbearing::fmu {

namespace {

using bearing::dynamics::BoreMotion;
using cosim::Course;

enum Input : std::size_t {
  x,
  y,
  velocity_x,
  velocity_y,
  planet_speed,
  carrier_speed,
  carrier_acceleration,
  input_number
};

std::vector<InputFacts> bearing_inputs(const BearingModel& model) {
  const std::string goes_on = "; inside a step it goes on with ";
  const auto displacement = [&](const char* axis, const char* sense) {
    return std::string("displacement of the planet's axis from that of its undeformed pin, ") + sense +
           goes_on + "planet.velocity." + axis;
  };
  return {
      {"planet.displacement.x", "m", displacement("x", "outward"), 0.0, velocity_x},
      {"planet.displacement.y", "m", displacement("y", "in the sense of carrier rotation"), 0.0, velocity_y},
      {"planet.velocity.x", "m/s", "slope of planet.displacement.x by time"},
      {"planet.velocity.y", "m/s", "slope of planet.displacement.y by time"},
      {"planet.speed", "rad/s", "speed of the planet about its axis, relative to the carrier",
       model.planet_speed},
      {"carrier.speed", "rad/s", "speed of the carrier" + goes_on + "carrier.acceleration",
       model.carrier_speed, carrier_acceleration},
      {"carrier.acceleration", "rad/s2", "slope of carrier.speed by time"}};
}

using Inputs = std::vector<std::size_t>;

// What rolls on the bore feels its motion at once; the rest only through its own motion.
Inputs bore() {
  return {x, y, velocity_x, velocity_y, planet_speed};
}
Inputs all() {
  return {x, y, velocity_x, velocity_y, planet_speed, carrier_speed, carrier_acceleration};
}

std::vector<OutputFacts> bearing_outputs(int rollers) {
  const Inputs none, turning{planet_speed};
  std::vector<OutputFacts> outputs{
      {"force.x", "N", "force of the bearing on the planet, outward", bore(), all()},
      {"force.y", "N", "force of the bearing on the planet, in the sense of carrier rotation", bore(), all()},
      {"moment", "N.m", "moment of the bearing on the planet about its axis", bore(), all()},
      {"life_used", "1", "revolutions so far over the life under the loads so far", none, none, false},
      {"cage.slip", "1", "1 - speed of the cage over that at pure rolling", turning, turning},
      {"cage.speed", "rad/s", "speed of the cage relative to the carrier", none, turning},
      {"revolutions", "1", "revolutions of the planet relative to the carrier since the start", none, none,
       false},
      {"friction_loss", "W", "power lost to friction", bore(), all()}};
  for (int i = 1; i <= rollers; ++i) {
    const std::string roller = "roller[" + std::to_string(i) + "].";
    outputs.push_back({roller + "inner_load", "N", "load between roller and pin", none, all()});
    outputs.push_back({roller + "outer_load", "N", "load between roller and planet", bore(), all()});
    outputs.push_back(
        {roller + "angle", "rad", "place of the roller, from outward towards carrier rotation", none, none});
  }
  return outputs;
}

BoreMotion motion_of(const std::vector<double>& in) {
  BoreMotion motion;
  motion.position = {in[x], in[y]};
  motion.velocity = {in[velocity_x], in[velocity_y]};
  motion.speed = in[planet_speed];
  motion.carrier_speed = in[carrier_speed];
  motion.carrier_acceleration = in[carrier_acceleration];
  return motion;
}

class BearingMachine : public Machine {
 public:
  explicit BearingMachine(const BearingModel& model) : bearing_(model.setup) {}

  void initialize(double, const std::vector<double>& inputs) override {
    bearing_.initialize(motion_of(inputs));
  }

  void advance(const cosim::Window& window, const std::vector<Course>& in) override {
    bearing_.advance(window, {.x = in[x],
                              .y = in[y],
                              .v_x = in[velocity_x],
                              .v_y = in[velocity_y],
                              .speed = in[planet_speed],
                              .carrier_speed = in[carrier_speed],
                              .carrier_acceleration = in[carrier_acceleration]});
  }

  std::vector<double> outputs(const std::vector<double>& inputs) const override {
    const cosim::DrivenBearingOutput now = bearing_.output(motion_of(inputs));
    std::vector<double> values{now.reaction.force.x(), now.reaction.force.y(), now.reaction.moment,
                               now.life_used,          now.cage_slip,          now.cage_speed,
                               now.revolutions,        now.friction_loss};
    for (std::size_t i = 0; i < now.inner_load.size(); ++i)
      values.insert(values.end(), {now.inner_load[i], now.outer_load[i], now.roller_angle[i]});
    return values;
  }

  std::vector<double> slopes(const std::vector<double>& inputs, std::size_t input) const override {
    std::vector<double> by = differences(inputs, input);
    if (input > planet_speed) return by;
    const cosim::ForceSlopes force = bearing_.slopes(motion_of(inputs));
    const Eigen::Vector2d column = input < velocity_x ? force.by_displacement.col(static_cast<int>(input - x))
                                   : input < planet_speed
                                       ? force.by_velocity.col(static_cast<int>(input - velocity_x))
                                       : force.by_speed;
    by[0] = column.x();
    by[1] = column.y();
    return by;
  }

  void save(cosim::SavedState& state) const override { bearing_.save(state); }
  void restore(const cosim::SavedState& state) override { bearing_.restore(state); }

 private:
  // Central, with steps far below what changes a contact and far above round-off.
  std::vector<double> differences(std::vector<double> inputs, std::size_t input) const {
    constexpr double kLength = 1e-9, kVelocity = 1e-5, kSpeed = 1e-3;  // [m], [m/s], [rad/s]
    const double step = input < velocity_x ? kLength : input < planet_speed ? kVelocity : kSpeed;
    const double middle = inputs[input];
    inputs[input] = middle + step;
    std::vector<double> by = outputs(inputs);
    inputs[input] = middle - step;
    const std::vector<double> below = outputs(inputs);
    for (std::size_t i = 0; i < by.size(); ++i) by[i] = (by[i] - below[i]) / (2.0 * step);
    return by;
  }

  cosim::DrivenBearing bearing_;
};

}  // namespace

ModelFacts bearing_facts(const NumberTable& numbers) {
  const BearingModel model = bearing_from(numbers);
  ModelFacts facts{.model = "bearing",
                   .meaning =
                       "One cylindrical roller bearing of one planet: rollers, cage and pin ring in the "
                       "carrier's frame"};
  show_fields(model, facts);
  facts.inputs = bearing_inputs(model);
  facts.outputs = bearing_outputs(model.setup.bearing.rollers().count);
  return facts;
}

std::unique_ptr<Machine> make_bearing(const NumberTable& numbers) {
  return std::make_unique<BearingMachine>(bearing_from(numbers));
}

}  // namespace orbearing::fmu
