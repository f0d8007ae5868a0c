#include "app/case/machines.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/case/alternatives.hpp"
#include "app/case/machine_fields.hpp"
#include "app/case/machine_of.hpp"

namespace orbearing::app {

namespace {

template <class Row>
AnalysisResult computed(const ResolvedCase& in, const Wanted&) {
  using Inputs = InputsOfRow<Row>;
  const auto found = computed_for(in, [&] { return Row::analyse(machine_of<Inputs>(in)); });
  AnalysisResult result;
  describe(result.record, found);
  result.warnings = found.warnings;
  if constexpr (requires { found.failed(); }) result.failed = found.failed();
  return result;
}

std::vector<MachineAnalysis> rows_of_analyses() {
  std::vector<MachineAnalysis> rows;
  MachineAnalyses::each([&]<class Row>(Row, std::size_t number) {
    rows.push_back({Row::model, Row::command, use_of_machine_analysis(number), Row::other_fidelity,
                    Row::names, Row::scatter, computed<Row>});
  });
  return rows;
}

}  // namespace

const std::vector<MachineAnalysis>& machine_analyses() {
  static const std::vector<MachineAnalysis> rows = rows_of_analyses();
  return rows;
}

const MachineAnalysis* machine_analysis(Model model, std::string_view command) {
  const auto found = std::ranges::find_if(machine_analyses(), [&](const MachineAnalysis& one) {
    return one.model == model && one.command == command;
  });
  return found == machine_analyses().end() ? nullptr : &*found;
}

namespace {

bool is_whole(CheckedCase& in) {
  bool whole = true;
  for (const Field& field : fields_of_machine(in.model())) {
    const bool required =
        (field.required_by & in.model()) != 0 || (field.required_if_chosen && is_chosen(in.data(), field));
    whole = whole && (!required || in.has(field.path));
    if (required && field.required_if_chosen && !in.has(field.path) &&
        std::ranges::find(in.mistakes, field.path, &Mistake::path) == in.mistakes.end()) {
      const std::string others = inputs_of_others(field, field.alternatives.back());
      in.add_error_at(
          field.path, "missing",
          requirement(field) + " is required" + (others.empty() ? "" : ", or " + others + " instead"));
    }
    if (field.count == 0 || !in.has(field.path) || in.list(field.path).size() == field.count) continue;
    in.add_error_at(field.path, fmt::format("a list of {}", in.list(field.path).size()),
                    fmt::format("{} values are required", field.count));
    whole = false;
  }
  return whole;
}

mechanics::Problems problems_of(const ResolvedCase& in) {
  mechanics::Problems found;
  Machines::each([&]<class Row>(Row, std::size_t) {
    if (in.model() == Row::model) found = problems(machine_of<typename Row::Type>(in));
  });
  return found;
}

}  // namespace

void check_machine(CheckedCase& in) {
  if (!is_whole(in)) return;
  for (const mechanics::Problem& problem : problems_of(in)) {
    const auto split = problem.text.find("; ");  // found; required
    in.add_error_at(problem.key, problem.text.substr(0, split), problem.text.substr(split + 2));
  }
}

namespace {

void add_derived(const described::Record& record, const std::string& prefix, std::vector<Derived>& rows) {
  for (const described::Entry& entry : record.entries()) {
    const std::string path = prefix + described::name_without_unit(entry);
    if (const auto* child = std::get_if<described::Child>(&entry.content))
      add_derived(child->one.front(), path + ".", rows);
    else if (const auto* numbers = std::get_if<described::Numbers>(&entry.content))
      rows.push_back({path, numbers->values.front() / entry.dimension.factor,
                      std::string(entry.dimension.customary), entry.meaning});
  }
}

}  // namespace

std::vector<Derived> machine_quantities(const ResolvedCase& in) {
  std::vector<Derived> rows;
  Machines::each([&]<class Row>(Row, std::size_t) {
    if constexpr (requires(const typename Row::Type& machine) { quantities_of(machine); })
      if (in.model() == Row::model) {
        described::Record record;
        describe(record, quantities_of(machine_of<typename Row::Type>(in)));
        add_derived(record, std::string(Row::prefix), rows);
      }
  });
  return rows;
}

}  // namespace orbearing::app
