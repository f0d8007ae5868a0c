#include "app/case/machines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>

#include "app/case/alternatives.hpp"
#include "app/case/machine_fields.hpp"
#include "app/case/machine_of.hpp"
#include "app/case/oil_case.hpp"

namespace orbearing::app {

namespace {

template <class Row>
auto found_for(const ResolvedCase& in, const AnalysisOptions& options) {
  if constexpr (requires { InputsOfRow<Row>::required(); }) require_inputs<Row>(in);
  const auto inputs = machine_of<InputsOfRow<Row>>(in);
  if constexpr (std::is_invocable_v<decltype(Row::analyse), decltype(inputs), const ShareDone&>)
    return Row::analyse(inputs, options.progress);
  else
    return Row::analyse(inputs);
}

template <class Row>
AnalysisResult computed(const ResolvedCase& in, const AnalysisOptions& options) {
  const auto found = result_for(in, [&] { return found_for<Row>(in, options); });
  AnalysisResult result;
  describe(result.record, found);
  result.warnings = found.warnings;
  if constexpr (requires { found.failed(); }) result.failed = found.failed();
  if constexpr (is_rated<ResultOfRow<Row>>) result.lives = found.life_table();
  if constexpr (requires { found.largest_load(); }) put_largest_load(found.largest_load(), result);
  if constexpr (requires { found.files(); })
    if (options.files) result.files = found.files();
  return result;
}

template <class Row>
MachineAnalysis values_of(std::size_t number) {
  MachineAnalysis row{.model = Row::model,
                      .command = Row::command,
                      .used = id_of_machine_analysis(number),
                      .other_fidelity = "",
                      .names = Row::names,
                      .scatter = Row::scatter,
                      .compute = computed<Row>,
                      .simulated = nullptr};
  if constexpr (requires { Row::other_fidelity; }) row.other_fidelity = Row::other_fidelity;
  if constexpr (requires { Row::simulated; }) {
    row.in_time = true;
    row.progress = Row::progress;
    row.simulated = [](const ResolvedCase& in) { return Row::simulated(machine_of<InputsOfRow<Row>>(in)); };
  }
  return row;
}

std::vector<MachineAnalysis> rows_of_analyses() {
  std::vector<MachineAnalysis> rows;
  MachineAnalyses::each([&]<class Row>(Row, std::size_t number) { rows.push_back(values_of<Row>(number)); });
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

bool is_required(const ResolvedCase& in, const Field& field) {
  return (field.required_by & in.model()) != 0 || (field.required_if_chosen && is_chosen(in.data(), field));
}

bool has_length(const ResolvedCase& in, const Field& field) {
  return field.count == 0 || !in.has(field.path) || in.list(field.path).size() == field.count;
}

// Lists that are shorter or longer than their members, and chosen alternatives without an input.
void check_form(CheckedCase& in) {
  for (const Field& field : fields_of_machine(in.model())) {
    if (is_required(in, field) && field.required_if_chosen && !in.has(field.path) &&
        std::ranges::find(in.mistakes, field.path, &Mistake::path) == in.mistakes.end()) {
      const std::string others = inputs_of_others(field, field.alternatives.back());
      in.add_error_at(
          field.path, "missing",
          requirement(field) + " is required" + (others.empty() ? "" : ", or " + others + " instead"));
    }
    if (!has_length(in, field))
      in.add_error_at(field.path, fmt::format("a list of {}", in.list(field.path).size()),
                      fmt::format("{} values are required", field.count));
  }
}

// Whether the case has all that the structure requires.
template <class Part>
bool is_whole(const ResolvedCase& in) {
  const std::vector<std::string> paths = paths_of<Part>();
  return std::ranges::all_of(fields_of_machine(in.model()), [&](const Field& field) {
    return std::ranges::find(paths, field.path) == paths.end() ||
           ((!is_required(in, field) || in.has(field.path)) && has_length(in, field));
  });
}

// Machines that are checked by several parts: each as far as its values are there.
template <class Parts>
inline constexpr bool are_several = false;
template <class... Parts>
inline constexpr bool are_several<RowsOf<Parts...>> = sizeof...(Parts) > 1;

template <class Row>
void check_parts(CheckedCase& in) {
  Row::Checked::each([&]<class Part>(Part, std::size_t) {
    if (!are_several<typename Row::Checked> && !is_whole<Part>(in)) return;
    for (const mechanics::Problem& problem : problems(machine_of<Part>(in, Missing::left_out)))
      if (!is_missing(in, problem.key)) in.add_error(stated_path(in, problem.key), problem.text);
  });
}

}  // namespace

bool is_missing(const ResolvedCase& in, const std::string& path) {
  const Field* field = find_field(path);
  return field != nullptr && is_required(in, *field) && !in.has(path);
}

void check_machine(CheckedCase& in) {
  check_form(in);
  Machines::each([&]<class Row>(Row, std::size_t) {
    if (in.model() == Row::model) check_parts<Row>(in);
  });
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

std::vector<Derived> derived_rows(const described::Record& record, const std::string& prefix) {
  std::vector<Derived> rows;
  add_derived(record, prefix, rows);
  return rows;
}

MachineQuantities machine_quantities(const ResolvedCase& in) {
  MachineQuantities quantities;
  Machines::each([&]<class Row>(Row, std::size_t) {
    if constexpr (requires(const typename Row::Type& machine) { quantities_of(machine); })
      if (in.model() == Row::model) {
        const auto found = quantities_of(machine_of<typename Row::Type>(in));
        described::Record record;
        describe(record, found);
        quantities.rows = derived_rows(record, std::string(Row::prefix));
        if constexpr (requires { found.warnings; }) quantities.warnings = found.warnings;
      }
  });
  return quantities;
}

}  // namespace orbearing::app
