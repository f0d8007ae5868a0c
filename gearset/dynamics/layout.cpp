#include "gearset/dynamics/layout.hpp"

namespace orbearing::gearset::dynamics {

std::vector<std::string> variable_names(const SetLayout& layout) {
  std::vector<std::string> bodies{"sun", "ring", "carrier"};
  for (Eigen::Index n = 1; n <= layout.planets; ++n) bodies.push_back("planet_" + std::to_string(n));
  std::vector<std::string> names;
  for (const std::string& body : bodies)
    for (const char* variable : {"_x [m]", "_y [m]", "_u [m]"}) names.push_back(body + variable);
  for (const std::string& body : bodies)
    for (const char* variable : {"_x_speed [m/s]", "_y_speed [m/s]", "_u_speed [m/s]"})
      names.push_back(body + variable);
  return names;
}

}  // namespace orbearing::gearset::dynamics
