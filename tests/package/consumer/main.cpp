// Uses each header that is installed.
#include <cmath>
#include <cstdlib>
#include <string>

#include "orbearing/case.hpp"
#include "orbearing/errors.hpp"
#include "orbearing/participant.hpp"
#include "orbearing/request.hpp"
#include "orbearing/sweep.hpp"
#include "orbearing/version.hpp"

namespace {

bool equal(double value, double expected, double share) {
  return std::abs(value - expected) <= share * std::abs(expected);
}

const orbearing::Case& reducer() {
  static const auto read = orbearing::Case::read(REDUCER);
  return read;
}

// Half the power, the same numbers by text and by SI; mistakes are reported with their location.
bool case_works() {
  const orbearing::Case half = reducer().with("input.power", "75 kW");
  bool refused = false;
  try {
    (void)reducer().with("input.power", "75 mm");
  } catch (const orbearing::BadInput& error) {
    refused = error.messages.size() == 1 && error.messages.front().find("input.power") != std::string::npos;
  }
  return refused && half.number("input.power") == 75e3 && half.text("input.power") == "75 kW" &&
         reducer().with("input.power", 75e3).number("input.power") == 75e3 &&
         orbearing::Case::parse(half.resolved()).number("input.power") == 75e3;
}

// At half the power the teeth carry half the load: what is left of the planet's is centrifugal.
bool sweep_works() {
  const orbearing::Points points = orbearing::evaluate(reducer(), {"input.power"}, {150e3, 75e3});
  std::size_t column = 0;
  while (points.columns.at(column) != "tangential_load_N") ++column;
  const double whole = points.numbers[column], half = points.numbers[points.columns.size() + column];
  return points.status == std::vector<std::string>{"ok", "ok"} && equal(half, 0.5 * whole, 1e-12);
}

bool request_works() {
  const orbearing::Answer answer = orbearing::answer({.command = "run", .given = reducer()});
  return answer.code == 0 && answer.result.find("\"life_h\"") != std::string::npos;
}

// The bearing in equilibrium: it returns the load that is applied.
bool participant_works() {
  orbearing::Participant bearing = orbearing::Participant::bearing(reducer());
  bearing.advance(1e-5);
  return equal(bearing.time(), 1e-5, 1e-12) && !bearing.inputs().empty() &&
         bearing.values().size() == bearing.outputs().size();
}

}  // namespace

int main() {
  const bool works = !orbearing::version().empty() && case_works() && sweep_works() && request_works() && participant_works();
  return works ? EXIT_SUCCESS : EXIT_FAILURE;
}
