#include "app/study/fidelity.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "app/errors.hpp"

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
  const auto found = rungs.find(name);
  if (found == rungs.end())
    throw BadInput(fmt::format("fidelity: found '{}'; required: {}", name, fmt::join(fidelity_names(), ", ")));
  return found->second;
}

}  // namespace orbearing::app
