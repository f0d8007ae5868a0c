// Every parameter that an FMU shows changes its outputs: one that does not is no parameter.
#include <gtest/gtest.h>

#include <map>

#include "tests/identities/app_fields/analysis_results.hpp"
#include "tests/identities/app_fields/field_bases.hpp"

namespace orbearing::app::fmu_parameters_test {
namespace {

using namespace fields_test;

struct Machine {
  std::string name;
  bool bearing = true;
  std::vector<std::string> settings{};
};

std::vector<Machine> machines() {
  const std::string eccentric = "bearing.cage.largest_eccentricity=0.1", gears = "gearset.dynamics.";
  return {{"bearing", true, {eccentric}},
          {"limited_shear", true, {eccentric, "traction.law=limiting-shear"}},
          {"mixed", true, {eccentric, "contact.lubrication=mixed"}},
          {"squeezed", true, {eccentric, "contact.squeeze=true"}},
          {"dry_air", true, {eccentric, "drag.enabled=false"}},
          {"laminae", true, {eccentric, "bearing.laminae=10"}},
          {"full_complement", true, {"bearing.complement=full", "bearing.rollers=21"}},
          {"gears", false},
          {"gears_with_a_ring_on_springs",
           false,
           {gears + "ring.torsional_stiffness=1e7 N/m", gears + "ring.support_stiffness=1e8 N/m"}},
          {"gears_with_a_driven_ring", false, {"input.member=carrier", "gearset.fixed=sun"}}};
}

// Far enough for a visible change, near enough to be allowed.
double other_value(const fmu::ShownField& field) {
  if (field.facts.name == "contact.roughness")
    return 5.0 * field.start;  // it bounds films that are thicker here
  constexpr double share = 1e-3;
  const double more = (1.0 + share) * field.start;
  if (field.start != 0.0) return field.facts.range.most < more ? (1.0 - share) * field.start : more;
  static const std::map<std::string, double> of_unit{{"m", 1e-6},    {"rad", 0.01},    {"kg", 0.1},   {"N", 10.0},
                                                     {"N/m", 1e6},   {"N.s/m", 100.0}, {"rad/s", 1.0}, {"1", 0.05},
                                                     {"s/m", 0.05}};
  const auto found = of_unit.find(field.facts.unit);
  return found == of_unit.end() ? 1.0 : found->second;
}

class Shown : public testing::TestWithParam<Machine> {};

TEST_P(Shown, ParametersChangeWhatItGives) {
  const bool bearing = GetParam().bearing;
  const Base& base = bases().front();
  const ResolvedCase in = parse_case(base.text, base.name + ".yaml", GetParam().settings);
  const fmu::NumberTable numbers = bearing ? bearing_numbers(in) : gear_numbers(in);
  const std::string plain = machine_result(numbers, bearing);
  const std::vector<fmu::ShownField> parameters = fmu::facts_of(numbers).shown.parameters;
  EXPECT_GT(parameters.size(), 10u);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    std::vector<double> values;
    for (const fmu::ShownField& one : parameters) values.push_back(one.start);
    values[i] = other_value(parameters[i]);
    EXPECT_NE(machine_result(numbers, bearing, values), plain)
        << parameters[i].facts.name << ": " << parameters[i].start << " and " << values[i];
  }
}

std::string machine_name(const testing::TestParamInfo<Machine>& machine) {
  return machine.param.name;
}

INSTANTIATE_TEST_SUITE_P(Machines, Shown, testing::ValuesIn(machines()), machine_name);

}  // namespace
}  // namespace orbearing::app::fmu_parameters_test
