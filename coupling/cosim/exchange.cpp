#include "coupling/cosim/exchange.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mechanics/checks.hpp"

namespace orbearing::cosim {

namespace {

struct NamedPosition {
  const Port& port;
  PortPosition position;
};

std::vector<NamedPosition> all_ports(const Sides& sides) {
  std::vector<NamedPosition> out;
  for (std::size_t s = 0; s < sides.size(); ++s)
    for (std::size_t i = 0; i < sides[s].ports.size(); ++i) out.push_back({sides[s].ports[i], {s, i}});
  return out;
}

bool is_same(const PortPosition& a, const PortPosition& b) {
  return a.side == b.side && a.port == b.port;
}

[[noreturn]] void refuse(const std::string& name, const char* problem) {
  throw std::invalid_argument("port " + name + ": found " + problem +
                              "; required: one participant that gives its motion, others that give forces");
}

Connection joined(const NamedPosition& motion, const std::vector<NamedPosition>& ports) {
  Connection out{motion.position, {}};
  for (const NamedPosition& other : ports) {
    if (other.port.name != motion.port.name || is_same(other.position, motion.position)) continue;
    if (other.port.kind != motion.port.kind) refuse(motion.port.name, "a translation and a rotation");
    if (other.port.output == PortOutput::motion)
      refuse(motion.port.name, "two participants that give its motion");
    out.forces.push_back(other.position);
  }
  if (out.forces.empty()) refuse(motion.port.name, "no participant that gives a force");
  return out;
}

void require_whole(const Port& port) {
  if (port.velocity == kNone || port.force == kNone ||
      (port.output == PortOutput::motion && port.displacement == kNone))
    throw std::invalid_argument("port " + port.name +
                                ": found no input or output for its motion or force; required: one each");
}

}  // namespace

std::vector<Connection> connect_by_name(const Sides& sides) {
  const std::vector<NamedPosition> ports = all_ports(sides);
  for (const NamedPosition& port : ports) require_whole(port.port);
  std::vector<Connection> out;
  for (const NamedPosition& port : ports)
    if (port.port.output == PortOutput::motion) out.push_back(joined(port, ports));
  for (const NamedPosition& port : ports) {
    const auto same = [&](const NamedPosition& other) {
      return other.port.name == port.port.name && other.port.output == PortOutput::motion;
    };
    if (std::none_of(ports.begin(), ports.end(), same))
      refuse(port.port.name, "no participant that gives its motion");
  }
  return out;
}

namespace {

void require_points(const std::vector<TimedValue>& points) {
  mechanics::require(!points.empty() && points.size() <= 4, "points of a polynomial", points.size(),
                     "1 to 4");
}

// Newton's divided differences, in place.
void divide(const std::vector<TimedValue>& points, std::vector<double>& difference) {
  for (std::size_t order = 1; order < points.size(); ++order)
    for (std::size_t i = points.size() - 1; i >= order; --i) {
      const double span = points[i].time - points[i - order].time;
      if (span == 0.0)
        throw std::invalid_argument(
            "points of a polynomial: found two at one time; required: different times");
      difference[i] = (difference[i] - difference[i - 1]) / span;
    }
}

}  // namespace

InputPolynomial through(const std::vector<TimedValue>& points, double begin) {
  require_points(points);
  std::vector<double> difference;
  for (const TimedValue& point : points) difference.push_back(point.value);
  divide(points, difference);
  InputPolynomial out;  // Horner: out = out * (t - t_i) + difference_i
  auto& c = out.coefficient;
  for (std::size_t i = points.size(); i-- > 0;) {
    const double position = points[i].time - begin;
    for (std::size_t k = c.size() - 1; k > 0; --k) c[k] = c[k - 1] - position * c[k];
    c[0] = difference[i] - position * c[0];
  }
  return out;
}

namespace {

// The last order + 1 values of `member`, as far as there are so many.
std::vector<TimedValue> last_values(const InterfaceHistory& history, std::size_t joint, int order,
                                    double JointValue::*member) {
  const std::size_t count = std::min(history.size(), static_cast<std::size_t>(order) + 1);
  std::vector<TimedValue> out;
  for (std::size_t i = history.size() - count; i < history.size(); ++i)
    out.push_back({history[i].time, history[i].joints[joint].*member});
  return out;
}

}  // namespace

InterfaceValues extrapolated(const InterfaceHistory& history, int order, const Window& window) {
  const InterfaceValues& last = history.back();
  InterfaceValues out{window.end, {}};
  for (std::size_t joint = 0; joint < last.joints.size(); ++joint) {
    const auto polynomial = [&](double JointValue::*member) {
      return through(last_values(history, joint, order, member), window.begin);
    };
    const InputPolynomial velocity = polynomial(&JointValue::velocity);
    const InputPolynomial displacement = integral(last.joints[joint].displacement, velocity);
    out.joints.push_back({displacement.at(window.length()), velocity.at(window.length()),
                          polynomial(&JointValue::force).at(window.length())});
  }
  return out;
}

namespace {

// Polynomials of `joint` over `window` that end with `end`: the displacement as a cubic with both values and
// velocities, the force as the polynomial through `end` and the last order + 1 ends. Eqs. (5) and (6) of
// coupling/cosim/README.md. If `end` is the result of extrapolated(), these are the extrapolated polynomials.
InputPolynomial motion_polynomial(const InterfaceHistory& history, std::size_t joint, const JointValue& end,
                                  const Window& window) {
  const JointValue& begin = history.back().joints[joint];
  return hermite(begin.displacement, begin.velocity, end.displacement, end.velocity, window.length());
}

InputPolynomial force_polynomial(const InterfaceHistory& history, std::size_t joint, double end, int order,
                                 const Window& window) {
  std::vector<TimedValue> points = last_values(history, joint, order, &JointValue::force);
  points.push_back({window.end, end});
  return through(points, window.begin);
}

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

// Outputs that the ports of a side ask for, as a number of the first ones.
std::size_t asked_for(const Side& side) {
  std::size_t number = 0;
  for (const Port& port : side.ports)
    number = std::max(
        number,
        1 + (port.output == PortOutput::force ? port.force : std::max(port.displacement, port.velocity)));
  return number;
}

void add_to(InputPolynomial& sum, const InputPolynomial& more) {
  for (std::size_t k = 0; k < sum.coefficient.size(); ++k) sum.coefficient[k] += more.coefficient[k];
}

std::vector<double> values_at(const std::vector<InputPolynomial>& polynomials, double since) {
  std::vector<double> values;
  for (const InputPolynomial& polynomial : polynomials) values.push_back(polynomial.at(since));
  return values;
}

}  // namespace

Exchange::Exchange(const Sides& sides, ExchangeOrder order)
    : sides_(sides),
      connections_(connect_by_name(sides)),
      order_(order),
      inputs_(sides.size()),
      outputs_(sides.size()) {}

const Port& Exchange::port(std::size_t joint) const {
  const PortPosition& position = connections_[joint].motion;
  return sides_[position.side].ports[position.port];
}

bool Exchange::motion_is_expected(std::size_t joint) const {
  if (order_ == ExchangeOrder::jacobi) return true;
  const Connection& connection = connections_[joint];
  return std::any_of(connection.forces.begin(), connection.forces.end(),
                     [&](const PortPosition& force) { return force.side < connection.motion.side; });
}

bool Exchange::force_is_expected(std::size_t joint) const {
  if (order_ == ExchangeOrder::jacobi) return true;
  const Connection& connection = connections_[joint];
  return std::any_of(connection.forces.begin(), connection.forces.end(),
                     [&](const PortPosition& force) { return force.side > connection.motion.side; });
}

// Inputs of `side` over a window from `begin` [s] on: the nominal ones, and at each port the half given by
// `polynomial_of(joint, who gives it)`.
template <class PolynomialOf>
std::vector<InputPolynomial> Exchange::inputs_from(std::size_t side, double begin,
                                                   const PolynomialOf& polynomial_of) const {
  const Side& own = sides_[side];
  std::vector<InputPolynomial> inputs(own.participant->inputs().size());
  for (const Nominal& nominal : own.inputs) inputs[nominal.position] = nominal.polynomial(begin);
  for (std::size_t joint = 0; joint < connections_.size(); ++joint) {
    const Connection& connection = connections_[joint];
    if (connection.motion.side == side)
      add_to(inputs[port(joint).force], polynomial_of(joint, PortOutput::force).force);
    for (const PortPosition& position : connection.forces) {
      if (position.side != side) continue;
      const JointPolynomial motion = polynomial_of(joint, PortOutput::motion);
      const Port& taken = own.ports[position.port];
      if (taken.displacement != kNone) add_to(inputs[taken.displacement], motion.displacement);
      add_to(inputs[taken.velocity], motion.velocity);
    }
  }
  return inputs;
}

std::vector<double> Exchange::inputs_under(const InterfaceValues& values, std::size_t side) const {
  const auto constant = [&](std::size_t joint, PortOutput) -> JointPolynomial {
    const JointValue& value = values.joints[joint];
    return {InputPolynomial::constant(value.displacement), InputPolynomial::constant(value.velocity),
            InputPolynomial::constant(value.force)};
  };
  return values_at(inputs_from(side, values.time, constant), 0.0);
}

void Exchange::read(std::size_t side, double time, const std::vector<double>& inputs) {
  const Side& own = sides_[side];
  outputs_[side] = own.participant->values(inputs, asked_for(own));
  for (const Nominal& nominal : own.outputs)
    outputs_[side][nominal.position] -= nominal.polynomial(time).at(0.0);
}

void Exchange::read_motion(std::size_t side, InterfaceValues& values) const {
  for (std::size_t joint = 0; joint < connections_.size(); ++joint) {
    if (connections_[joint].motion.side != side) continue;
    values.joints[joint].displacement = outputs_[side][port(joint).displacement];
    values.joints[joint].velocity = outputs_[side][port(joint).velocity];
  }
}

double Exchange::force_of(std::size_t joint) const {
  double sum = 0.0;
  for (const PortPosition& position : connections_[joint].forces)
    sum += outputs_[position.side][sides_[position.side].ports[position.port].force];
  return sum;
}

void Exchange::read_forces(InterfaceValues& values) const {
  for (std::size_t joint = 0; joint < connections_.size(); ++joint)
    values.joints[joint].force = force_of(joint);
}

void Exchange::advance(std::size_t side, const InterfaceHistory& history, const InterfaceValues& known,
                       int force_order, const Window& window) {
  const auto polynomial_of = [&](std::size_t joint, PortOutput giver) -> JointPolynomial {
    if (giver == PortOutput::force)
      return {.force = force_polynomial(history, joint, known.joints[joint].force, force_order, window)};
    const InputPolynomial displacement = motion_polynomial(history, joint, known.joints[joint], window);
    return {.displacement = displacement, .velocity = slope_of(displacement)};
  };
  const std::vector<InputPolynomial> inputs = inputs_from(side, window.begin, polynomial_of);
  sides_[side].participant->advance(window, inputs);
  read(side, window.end, values_at(inputs, window.length()));
}

// The output of `side`, into the input of those after it; the force of a joint once all of its givers
// have moved.
void Exchange::learn(std::size_t side, std::vector<std::size_t>& still_to_come,
                     InterfaceValues& known) const {
  read_motion(side, known);
  for (std::size_t joint = 0; joint < connections_.size(); ++joint)
    for (const PortPosition& position : connections_[joint].forces)
      if (position.side == side && --still_to_come[joint] == 0) known.joints[joint].force = force_of(joint);
}

InterfaceValues Exchange::input(const InterfaceValues& expected, const InterfaceValues& output) const {
  InterfaceValues values = expected;
  for (std::size_t joint = 0; joint < connections_.size(); ++joint) {
    JointValue& value = values.joints[joint];
    const double force = force_is_expected(joint) ? value.force : output.joints[joint].force;
    if (!motion_is_expected(joint)) value = output.joints[joint];
    value.force = force;
  }
  return values;
}

PassResult Exchange::pass(const InterfaceHistory& history, const InterfaceValues& expected, int force_order,
                          const Window& window) {
  InterfaceValues known = expected, output = expected;
  std::vector<std::size_t> still_to_come;  // (joints)  givers of force that have not moved yet
  for (const Connection& connection : connections_) still_to_come.push_back(connection.forces.size());
  for (std::size_t side = 0; side < sides_.size(); ++side) {
    advance(side, history, known, force_order, window);
    read_motion(side, output);
    if (order_ != ExchangeOrder::jacobi) learn(side, still_to_come, known);
  }
  read_forces(output);
  return {output, input(expected, output)};
}

void Exchange::renew_forces(InterfaceValues& values) {
  for (std::size_t side = 0; side < sides_.size(); ++side) {
    const std::vector<Port>& ports = sides_[side].ports;
    if (std::none_of(ports.begin(), ports.end(),
                     [](const Port& port) { return port.output == PortOutput::force; }))
      continue;
    inputs_[side] = inputs_under(values, side);
    read(side, values.time, inputs_[side]);
  }
  read_forces(values);
}

InterfaceValues Exchange::initialize(double time, int rounds, double allowed_change) {
  InterfaceValues values{time, std::vector<JointValue>(connections_.size())};
  for (int round = 0; round < rounds; ++round) {
    const InterfaceValues before = values;
    for (std::size_t side = 0; side < sides_.size(); ++side) {
      const std::vector<double> inputs = inputs_under(values, side);
      Participant& participant = *sides_[side].participant;
      round == 0 ? participant.initialize(time, inputs) : participant.balance(time, inputs);
      read(side, time, inputs);
      read_motion(side, values);
    }
    read_forces(values);
    if (round > 0 && change_of_forces(before, values, *this) <= allowed_change) break;
  }
  return values;
}

}  // namespace orbearing::cosim
