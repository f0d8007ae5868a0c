#include "coupling/cosim/joint_vector.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace orbearing::cosim {

namespace {

void take_largest(const JointValue& value, JointValue& largest) {
  largest.displacement = std::max(largest.displacement, std::abs(value.displacement));
  largest.velocity = std::max(largest.velocity, std::abs(value.velocity));
  largest.force = std::max(largest.force, std::abs(value.force));
}

void complete(JointValue& scale, double length) {
  constexpr double share = 1e-3;
  scale.velocity = std::max(scale.velocity, share * scale.displacement / length);
  for (double* value : {&scale.displacement, &scale.velocity, &scale.force})
    if (*value == 0.0) *value = 1.0;
}

// Calls `function` with each value that belongs to the vector.
template <class Values, class Function>
void for_each_expected(const Exchange& exchange, Values& values, const Function& function) {
  for (std::size_t joint = 0; joint < exchange.joints(); ++joint) {
    auto& value = values.joints[joint];
    if (exchange.motion_is_expected(joint)) {
      function(value.displacement);
      function(value.velocity);
    }
    if (exchange.force_is_expected(joint)) function(value.force);
  }
}

}  // namespace

JointScales scales_of(const Exchange& exchange, const InterfaceValues& a, const InterfaceValues& b,
                      double length) {
  JointScales scales;
  for (std::size_t joint = 0; joint < exchange.joints(); ++joint) {
    JointValue& scale =
        exchange.port(joint).kind == PortKind::translation ? scales.translation : scales.rotation;
    take_largest(a.joints[joint], scale);
    take_largest(b.joints[joint], scale);
  }
  complete(scales.translation, length);
  complete(scales.rotation, length);
  return scales;
}

Eigen::VectorXd packed(const Exchange& exchange, const InterfaceValues& values) {
  std::vector<double> list;
  for_each_expected(exchange, values, [&](double value) { list.push_back(value); });
  return Eigen::Map<const Eigen::VectorXd>(list.data(), static_cast<Eigen::Index>(list.size()));
}

void unpack(const Exchange& exchange, const Eigen::VectorXd& vector, InterfaceValues& values) {
  Eigen::Index place = 0;
  for_each_expected(exchange, values, [&](double& value) { value = vector[place++]; });
}

Eigen::VectorXd weights(const Exchange& exchange, const JointScales& scales) {
  InterfaceValues sizes;
  for (std::size_t joint = 0; joint < exchange.joints(); ++joint)
    sizes.joints.push_back(exchange.port(joint).kind == PortKind::translation ? scales.translation
                                                                              : scales.rotation);
  return packed(exchange, sizes).cwiseInverse();
}

}  // namespace orbearing::cosim
