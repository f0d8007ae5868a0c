#include "coupling/cosim/exchange.hpp"

#include <algorithm>
#include <cmath>

namespace orbearing::cosim {

namespace {

double largest_force(const InterfaceValues& values, const Exchange& exchange, PortKind kind) {
  double largest = 0.0;
  for (std::size_t joint = 0; joint < values.joints.size(); ++joint)
    if (exchange.port(joint).kind == kind) largest = std::max(largest, std::abs(values.joints[joint].force));
  return largest;
}

// Largest change of a force over the largest force of its kind.
double change_of_forces(const InterfaceValues& before, const InterfaceValues& now, const Exchange& exchange) {
  double change = 0.0;
  for (std::size_t joint = 0; joint < now.joints.size(); ++joint) {
    const double step = std::abs(now.joints[joint].force - before.joints[joint].force);
    if (step > 0.0) change = std::max(change, step / largest_force(now, exchange, exchange.port(joint).kind));
  }
  return change;
}

}  // namespace

Exchange::Exchange(const Participants& participants, const std::vector<Connection>& connections,
                   ExchangeOrder order)
    : participants_(participants), connections_(connections), order_(order) {
  for (const Participant* participant : participants_) {
    inputs_.emplace_back(participant->ports().size());
    outputs_.emplace_back(participant->ports().size());
  }
}

const Port& Exchange::port(std::size_t joint) const {
  const PortPlace& place = connections_[joint].motion;
  return participants_[place.participant]->ports()[place.port];
}

bool Exchange::motion_is_expected(std::size_t joint) const {
  if (order_ == ExchangeOrder::jacobi) return true;
  const Connection& connection = connections_[joint];
  return std::any_of(connection.forces.begin(), connection.forces.end(), [&](const PortPlace& force) {
    return force.participant < connection.motion.participant;
  });
}

bool Exchange::force_is_expected(std::size_t joint) const {
  if (order_ == ExchangeOrder::jacobi) return true;
  if (order_ == ExchangeOrder::one_way) return false;
  const Connection& connection = connections_[joint];
  return std::any_of(connection.forces.begin(), connection.forces.end(), [&](const PortPlace& force) {
    return force.participant > connection.motion.participant;
  });
}

void Exchange::read_motion(std::size_t participant, InterfaceValues& values) const {
  for (std::size_t joint = 0; joint < connections_.size(); ++joint) {
    const PortPlace& place = connections_[joint].motion;
    if (place.participant != participant) continue;
    const PortOutput& given = outputs_[participant][place.port];
    values.joints[joint].displacement = given.displacement;
    values.joints[joint].velocity = given.velocity;
  }
}

double Exchange::force_of(std::size_t joint) const {
  double sum = 0.0;
  for (const PortPlace& place : connections_[joint].forces)
    sum += outputs_[place.participant][place.port].force;
  return sum;
}

void Exchange::read_forces(InterfaceValues& values) const {
  for (std::size_t joint = 0; joint < connections_.size(); ++joint)
    values.joints[joint].force = force_of(joint);
}

void Exchange::advance(std::size_t participant, const InterfaceHistory& history, const InterfaceValues& known,
                       int force_order, const Window& window) {
  for (std::size_t joint = 0; joint < connections_.size(); ++joint) {
    const Connection& connection = connections_[joint];
    if (connection.motion.participant == participant && order_ != ExchangeOrder::one_way)
      inputs_[participant][connection.motion.port].force =
          force_course(history, joint, known.joints[joint].force, force_order, window);
    for (const PortPlace& place : connection.forces) {
      if (place.participant != participant) continue;
      PortInput& input = inputs_[participant][place.port];
      input.displacement = motion_course(history, joint, known.joints[joint], window);
      input.velocity = slope_of(input.displacement);
    }
  }
  participants_[participant]->set_input(inputs_[participant]);
  participants_[participant]->advance(window);
  participants_[participant]->output(outputs_[participant]);
}

// What `participant` has answered, into what those after it are told; the force of a joint once all of its
// givers have moved.
void Exchange::learn(std::size_t participant, std::vector<std::size_t>& still_to_come,
                     InterfaceValues& known) const {
  read_motion(participant, known);
  for (std::size_t joint = 0; joint < connections_.size(); ++joint)
    for (const PortPlace& place : connections_[joint].forces)
      if (place.participant == participant && --still_to_come[joint] == 0)
        known.joints[joint].force = force_of(joint);
}

InterfaceValues Exchange::told(const InterfaceValues& expected, const InterfaceValues& answered) const {
  InterfaceValues values = expected;
  for (std::size_t joint = 0; joint < connections_.size(); ++joint) {
    JointValue& value = values.joints[joint];
    const double force = force_is_expected(joint) ? value.force : answered.joints[joint].force;
    if (!motion_is_expected(joint)) value = answered.joints[joint];
    value.force = order_ == ExchangeOrder::one_way ? 0.0 : force;
  }
  return values;
}

PassResult Exchange::pass(const InterfaceHistory& history, const InterfaceValues& expected, int force_order,
                          const Window& window) {
  InterfaceValues known = expected, answered = expected;
  std::vector<std::size_t> still_to_come;  // (joints)  givers of force that have not moved yet
  for (const Connection& connection : connections_) still_to_come.push_back(connection.forces.size());
  for (std::size_t p = 0; p < participants_.size(); ++p) {
    advance(p, history, known, force_order, window);
    read_motion(p, answered);
    if (order_ != ExchangeOrder::jacobi) learn(p, still_to_come, known);
  }
  read_forces(answered);
  return {answered, told(expected, answered)};
}

void Exchange::set_constant_motion(const InterfaceValues& values, std::size_t participant) {
  for (std::size_t joint = 0; joint < connections_.size(); ++joint)
    for (const PortPlace& place : connections_[joint].forces) {
      if (place.participant != participant) continue;
      PortInput& input = inputs_[participant][place.port];
      input.displacement = Course::constant(values.joints[joint].displacement);
      input.velocity = Course::constant(values.joints[joint].velocity);
    }
}

void Exchange::renew_forces(InterfaceValues& values) {
  for (std::size_t p = 0; p < participants_.size(); ++p) {
    const std::vector<Port>& ports = participants_[p]->ports();
    const bool gives =
        std::any_of(ports.begin(), ports.end(), [](const Port& port) { return port.gives == Gives::force; });
    if (!gives) continue;
    set_constant_motion(values, p);
    participants_[p]->set_input(inputs_[p]);
    participants_[p]->output(outputs_[p]);
  }
  read_forces(values);
}

InterfaceValues Exchange::initialize(double time, int rounds, double allowed_change) {
  InterfaceValues values{time, std::vector<JointValue>(connections_.size())};
  for (std::size_t p = 0; p < participants_.size(); ++p) inputs_[p].assign(inputs_[p].size(), {});
  for (int round = 0; round < rounds; ++round) {
    const InterfaceValues before = values;
    for (std::size_t p = 0; p < participants_.size(); ++p) {
      set_constant_motion(values, p);
      for (std::size_t joint = 0; joint < connections_.size(); ++joint) {
        const PortPlace& place = connections_[joint].motion;
        if (place.participant == p && order_ != ExchangeOrder::one_way)
          inputs_[p][place.port].force = Course::constant(values.joints[joint].force);
      }
      participants_[p]->initialize(time, inputs_[p]);
      participants_[p]->output(outputs_[p]);
      read_motion(p, values);
    }
    read_forces(values);
    if (round > 0 && change_of_forces(before, values, *this) <= allowed_change) break;
  }
  return values;
}

}  // namespace orbearing::cosim
