#include "coupling/cosim/interface_polynomial.hpp"

#include <algorithm>

namespace orbearing::cosim {

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

}  // namespace orbearing::cosim
