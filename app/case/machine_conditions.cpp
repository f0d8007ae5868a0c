// Conditions beside the types that analyses of machines take: conditional_uses() of machine_fields.hpp.
// Unlike the other pairs of this folder it has no header of its own, since cases are above the fields.
#include <algorithm>

#include "app/case/machine_fields.hpp"
#include "app/case/machine_of.hpp"
#include "app/case/text_parts.hpp"

namespace orbearing::app {

namespace {

template <class Row, class Inputs>
Condition condition_of(const mechanics::Premise<Inputs>& premise) {
  return {.paths = premise.on,
          .values = premise.value.empty() ? std::vector<std::string>{} : parts_of(premise.value, '|'),
          .holds =
              [holds = premise.holds](const ResolvedCase& in, std::string_view) {
                return in.model() == Row::model &&
                       holds(in.once<Inputs>([&] { return machine_of<Inputs>(in); }));
              },
          .text = premise.text};
}

template <class Row>
void add_uses(std::string_view path, std::vector<ConditionalUse>& found) {
  using Inputs = InputsOfRow<Row>;
  if constexpr (requires { Inputs::conditions(); }) {
    // Made once, since all inputs of a machine are asked for.
    static const std::vector<mechanics::Conditional<Inputs>> conditions = Inputs::conditions();
    for (const mechanics::Conditional<Inputs>& one : conditions) {
      if (std::ranges::none_of(one.keys, [&](const std::string& key) { return path.starts_with(key); }))
        continue;
      ConditionalUse& use = found.emplace_back();
      use.not_modelled = one.otherwise == mechanics::Otherwise::not_modelled;
      use.beside_row = one.beside_row;
      for (const auto& premise : one.premises) use.conditions.push_back(condition_of<Row>(premise));
    }
  }
}

}  // namespace

std::vector<ConditionalUse> conditional_uses(std::string_view path, std::size_t analysis) {
  std::vector<ConditionalUse> found;
  MachineAnalyses::each([&]<class Row>(Row, std::size_t number) {
    if (number == analysis) add_uses<Row>(path, found);
  });
  return found;
}

}  // namespace orbearing::app
