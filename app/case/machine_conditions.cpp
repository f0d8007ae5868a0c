// Conditions beside the types that analyses of machines take: conditions_on() of machine_fields.hpp. Unlike
// the other pairs of this folder it has no header of its own, since cases are above the fields.
#include <algorithm>

#include "app/case/machine_fields.hpp"
#include "app/case/machine_of.hpp"

namespace orbearing::app {

namespace {

template <class Row>
void add_conditions(std::string_view path, std::vector<Condition>& found) {
  using Inputs = InputsOfRow<Row>;
  if constexpr (requires { Inputs::conditions(); })
    for (const auto& one : Inputs::conditions())
      if (std::ranges::any_of(one.keys, [&](const std::string& key) { return path.starts_with(key); }))
        found.push_back({.paths = one.on,
                         .holds =
                             [holds = one.holds](const ResolvedCase& in, std::string_view) {
                               return in.model() == Row::model && holds(machine_of<Inputs>(in));
                             },
                         .text = one.text});
}

}  // namespace

std::vector<Condition> conditions_on(std::string_view path, std::size_t analysis) {
  std::vector<Condition> found;
  MachineAnalyses::each([&]<class Row>(Row, std::size_t number) {
    if (number == analysis) add_conditions<Row>(path, found);
  });
  return found;
}

}  // namespace orbearing::app
