#include "coupling/cosim/bearing_participant.hpp"

#include <sstream>
#include <stdexcept>

#include "coupling/cosim/gears_participant.hpp"
#include "gearset/dynamics/model.hpp"
#include "mechanics/checks.hpp"

namespace orbearing::cosim {

BearingParticipant::BearingParticipant(const DrivenBearingSetup& setup, BearingPlace place)
    : bearing_(setup), place_(std::move(place)), ports_(planet_ports(place_.planet, Gives::force)) {}

// Speeds change along a straight line from their value and rate at the beginning.
void BearingParticipant::set_course(const std::vector<PortInput>& inputs) {
  const gearset::dynamics::SpeedState now = speed_at(place_.operation, time_);
  const gearset::Speeds& nominal = place_.operation.speeds;
  course_ = {inputs[0].displacement,
             inputs[1].displacement,
             inputs[0].velocity,
             inputs[1].velocity,
             inputs[2].velocity,
             {},
             {}};
  course_.speed.coefficient[0] += nominal.planet_relative * now.factor;
  course_.speed.coefficient[1] += nominal.planet_relative * now.rate;
  course_.carrier_speed = {{nominal.carrier * now.factor, nominal.carrier * now.rate, 0.0, 0.0}};
  course_.carrier_acceleration = Course::constant(nominal.carrier * now.rate);
  since_ = 0.0;
}

void BearingParticipant::initialize(double time, const std::vector<PortInput>& inputs) {
  time_ = time;
  set_course(inputs);
  bearing_.initialize(motion());
}

void BearingParticipant::set_input(const std::vector<PortInput>& inputs) {
  set_course(inputs);
}

void BearingParticipant::advance(const Window& window) {
  bearing_.advance(window, course_);
  time_ = window.end;
  since_ = window.length();
}

void BearingParticipant::output(std::vector<PortOutput>& outputs) const {
  const bearing::dynamics::BoreReaction reaction = bearing_.reaction(motion());
  outputs.assign(ports_.size(), {});
  outputs[0].force = reaction.force.x();
  outputs[1].force = reaction.force.y();
  outputs[2].force = reaction.moment;
}

// The machine's own state, and at the end the present time and course.
void BearingParticipant::save(SavedState& state) const {
  bearing_.save(state);
  state.insert(state.end(), {time_, since_});
  for (const Course* course : {&course_.x, &course_.y, &course_.v_x, &course_.v_y, &course_.speed,
                               &course_.carrier_speed, &course_.carrier_acceleration})
    state.insert(state.end(), course->coefficient.begin(), course->coefficient.end());
}

void BearingParticipant::restore(const SavedState& state) {
  constexpr std::size_t tail = 2 + 7 * 4;
  mechanics::require(state.size() >= tail, "size of a saved state", state.size(), "that of a bearing");
  const auto own = state.end() - static_cast<std::ptrdiff_t>(tail);
  bearing_.restore({state.begin(), own});
  auto next = own;
  time_ = *next++;
  since_ = *next++;
  for (Course* course : {&course_.x, &course_.y, &course_.v_x, &course_.v_y, &course_.speed,
                         &course_.carrier_speed, &course_.carrier_acceleration})
    for (double& coefficient : course->coefficient) coefficient = *next++;
}

}  // namespace orbearing::cosim
