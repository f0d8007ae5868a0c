#include "app/study/fidelity.hpp"

#include <map>

namespace orbearing::app {

const std::vector<std::string>& fidelity_names() {
  static const std::vector<std::string> names{"quasi-static", "dynamic", "co-simulated", "monolithic"};
  return names;
}

study::Fidelity fidelity_of(const std::string& name) {
  using study::Fidelity;
  static const std::map<std::string, Fidelity> rungs{{"quasi-static", Fidelity::quasi_static},
                                                     {"dynamic", Fidelity::dynamic},
                                                     {"co-simulated", Fidelity::co_simulated},
                                                     {"monolithic", Fidelity::monolithic}};
  return rungs.at(name);
}

}  // namespace orbearing::app
