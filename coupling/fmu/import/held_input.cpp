#include "coupling/fmu/import/held_input.hpp"

#include <cmath>
#include <sstream>

#include "coupling/fmu/import/errors.hpp"

namespace orbearing::fmu {
namespace {

double held_value(const cosim::Course& course, Held held, double begin, double end) {
  switch (held) {
    case Held::at_begin:
      return course.at(begin);
    case Held::at_end:
      return course.at(end);
    case Held::mean:
      break;
  }
  return mean(course, begin, end);
}

bool finite(const cosim::Course& course) {
  bool all = true;
  for (const double c : course.coefficient) all = all && std::isfinite(c);
  return all;
}

// Of the polynomial, by time, at its beginning: k! c_k.
double derivative(const cosim::Course& course, int order) {
  constexpr double factorials[] = {1.0, 1.0, 2.0, 6.0};
  return factorials[order] * course.coefficient[static_cast<std::size_t>(order)];
}

}  // namespace

double mean(const cosim::Course& course, double begin, double end) {
  const auto& c = course.moved(begin).coefficient;
  const double h = end - begin;
  return c[0] + h * (c[1] / 2.0 + h * (c[2] / 3.0 + h * c[3] / 4.0));
}

HeldInputs::HeldInputs(const std::vector<cosim::Port>& ports,
                       const std::vector<ForeignPortChannels>& channels, int slopes)
    : port_number_{ports.size()}, slopes_{slopes} {
  const auto add = [this](std::size_t port, Half half, const std::optional<ForeignChannel>& channel) {
    if (channel) entries_.push_back({port, half, *channel});
  };
  for (std::size_t port = 0; port < ports.size(); ++port) {
    if (ports[port].gives == cosim::Gives::motion) {
      add(port, Half::force, channels[port].force);
    } else {
      add(port, Half::displacement, channels[port].displacement);
      add(port, Half::velocity, channels[port].velocity);
    }
  }
  for (const Entry& entry : entries_) references_.push_back(entry.channel.reference);
}

const cosim::Course& HeldInputs::course(const Entry& entry) const {
  const cosim::PortInput& input = inputs_[entry.port];
  if (entry.half == Half::force) return input.force;
  return entry.half == Half::velocity ? input.velocity : input.displacement;
}

void HeldInputs::take(const std::vector<cosim::PortInput>& inputs) {
  if (inputs.size() != port_number_) {
    std::ostringstream text;
    text << inputs.size() << " inputs for " << port_number_ << " ports";
    throw ForeignFmuError(text.str());
  }
  for (const cosim::PortInput& input : inputs) {
    if (!finite(input.displacement) || !finite(input.velocity) || !finite(input.force)) {
      throw ForeignFmuError("an input that is not finite");
    }
  }
  inputs_ = inputs;
}

void HeldInputs::set(ForeignInstance& instance, double begin, double end) const {
  const bool interpolated = slopes_ > 0 && end > begin;
  std::vector<double> values;
  for (const Entry& entry : entries_) {
    const Held held = interpolated || entry.channel.follows_velocity ? Held::at_begin : entry.channel.held;
    values.push_back((held_value(course(entry), held, begin, end) - entry.channel.offset) /
                     entry.channel.factor);
  }
  instance.set(references_, values);
  for (int order = 1; interpolated && order <= slopes_; ++order) set_slopes(instance, order, begin);
}

void HeldInputs::set_slopes(ForeignInstance& instance, int order, double begin) const {
  References references;
  std::vector<double> values;
  for (const Entry& entry : entries_) {
    if (entry.channel.follows_velocity) continue;
    references.push_back(entry.channel.reference);
    values.push_back(derivative(course(entry).moved(begin), order) / entry.channel.factor);
  }
  instance.set_slopes(references, order, values);
}

ForeignOutputs::ForeignOutputs(const std::vector<cosim::Port>& ports,
                               const std::vector<ForeignPortChannels>& channels) {
  for (std::size_t port = 0; port < ports.size(); ++port) {
    names_.push_back(ports[port].name);
    if (ports[port].gives == cosim::Gives::motion) {
      entries_.push_back({port, &cosim::PortOutput::displacement, *channels[port].displacement});
      entries_.push_back({port, &cosim::PortOutput::velocity, *channels[port].velocity});
    } else {
      entries_.push_back({port, &cosim::PortOutput::force, *channels[port].force});
    }
  }
  for (const Entry& entry : entries_) references_.push_back(entry.channel.reference);
}

void ForeignOutputs::get(ForeignInstance& instance, std::vector<cosim::PortOutput>& outputs) const {
  std::vector<double> values;
  instance.get(references_, values);
  outputs.assign(names_.size(), {});
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Entry& entry = entries_[i];
    if (!std::isfinite(values[i])) {
      throw ForeignFmuError("gives a value that is not finite at port " + names_[entry.port]);
    }
    outputs[entry.port].*entry.value = entry.channel.factor * values[i] + entry.channel.offset;
  }
}

}  // namespace orbearing::fmu
