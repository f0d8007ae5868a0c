#include "app/case/machine_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <stdexcept>
#include <utility>

#include "app/case/field_rows.hpp"
#include "app/case/input_keys.hpp"

namespace orbearing::app {

namespace {

bool is_same(const Condition& one, const Condition& other) {
  return one.text == other.text && one.paths == other.paths && one.values == other.values;
}
bool are_same(const std::vector<ConditionalUse>& some, const std::vector<ConditionalUse>& others) {
  return std::ranges::equal(some, others, [](const ConditionalUse& one, const ConditionalUse& other) {
    return std::ranges::equal(one.conditions, other.conditions, is_same);
  });
}

/// Collects the uses of one field by the analyses of its model.
class UsesOfField {
 public:
  void add(AnalysisId analysis, const std::vector<ConditionalUse>& uses) {
    Conditional found{analysis, {}};
    for (const ConditionalUse& use : uses)
      if (use.beside_row)
        beside_.push_back({analysis, use.conditions});
      else
        found.uses.push_back(use);
    if (found.uses.empty())
      always_ |= analysis;
    else
      conditional_.push_back(std::move(found));
  }
  void add_not_modelled(AnalysisId analysis) { not_modelled_ |= analysis; }
  void add_refused(AnalysisId analysis) { refused_ |= analysis; }

  /// `row` has the condition of the field's row.
  Use joined(const Use& row) const {
    Use use(always_, not_modelled_, refused_);
    use.conditions = row.conditions;
    if (have_shared_conditions())
      put_shared(use);
    else
      for (const Conditional& one : conditional_) put_ways(one, 0, row.conditions, use);
    use.ways.insert(use.ways.end(), beside_.begin(), beside_.end());
    return use;
  }

 private:
  struct Conditional {
    AnalysisId analysis;
    std::vector<ConditionalUse> uses;
  };

  // Conditions that all analyses have are those of the field.
  bool have_shared_conditions() const {
    return always_.is_empty() && !conditional_.empty() &&
           std::ranges::all_of(conditional_, [&](const Conditional& one) {
             return !one.uses.front().not_modelled && are_same(one.uses, conditional_.front().uses);
           });
  }

  void put_shared(Use& use) const {
    const std::vector<Condition> row = use.conditions;
    const std::vector<Condition>& first = conditional_.front().uses.front().conditions;
    use.conditions.insert(use.conditions.end(), first.begin(), first.end());
    for (const Conditional& one : conditional_) {
      use.by |= one.analysis;
      put_ways(one, 1, row, use);
    }
  }

  static void put_ways(const Conditional& one, std::size_t from, const std::vector<Condition>& row,
                       Use& use) {
    for (std::size_t i = from; i < one.uses.size(); ++i) {
      Way way{one.analysis, one.uses[i].conditions};
      way.conditions.insert(way.conditions.end(), row.begin(), row.end());
      use.ways.push_back(std::move(way));
      if (one.uses[i].not_modelled) use.not_modelled_by |= one.analysis;
    }
  }

  AnalysisSet always_, not_modelled_, refused_;
  std::vector<Conditional> conditional_;
  std::vector<Way> beside_;
};

/// Inputs that the analyses of one model take.
struct UsesOfModel {
  AnalysisSet all, rated;  // all of them, and those with lives
  std::map<std::string, UsesOfField> by_path;
};

template <class Inputs>
std::vector<std::string> refused_of() {
  if constexpr (requires { Inputs::refused(); })
    return Inputs::refused();
  else
    return {};
}

bool contains(const std::vector<std::string>& paths, const std::string& path) {
  return std::ranges::find(paths, path) != paths.end();
}

template <class Row>
void add_uses(std::size_t number, const std::vector<std::string>& paths, UsesOfModel& uses) {
  const AnalysisId analysis = id_of_machine_analysis(number);
  const std::vector<std::string> taken = paths_of<InputsOfRow<Row>>(),
                                 refused = refused_of<InputsOfRow<Row>>();
  uses.all |= analysis;
  if (is_rated<ResultOfRow<Row>>) uses.rated |= analysis;
  for (const std::string& path : paths) {
    UsesOfField& of_field = uses.by_path[path];
    if (contains(refused, path))
      of_field.add_refused(analysis);
    else if (contains(taken, path))
      of_field.add(analysis, conditional_uses(path, number));
    else
      of_field.add_not_modelled(analysis);
  }
}

UsesOfModel uses_of(Model model, const MachineFields& of_machine) {
  const std::vector<std::string> paths = described::each(of_machine.fields, &Field::path);
  UsesOfModel uses;
  MachineAnalyses::each([&]<class Row>(Row, std::size_t number) {
    if (Row::model == model) add_uses<Row>(number, paths, uses);
  });
  return uses;
}

// A grade replaces viscosities.
void add_grade(std::vector<Field>& fields, unsigned model, const Use& use) {
  table::add_grade_fields(fields, model, use);
  for (const std::string& path : {keys().viscosity, keys().pressure_viscosity, keys().kinematic_viscosity})
    if (Field* replaced = table::find_row(fields, path)) replaced->under(where_absent(keys().oil_grade));
}

// Inputs of the profile have an effect by its kind.
void put_profile_uses(std::vector<Field>& fields, AnalysisSet all) {
  const Field* kind = table::find_row(fields, keys().profile_kind);
  if (kind == nullptr) return;
  const Use use = kind->use;
  table::put_profile_uses(fields, {use, use, use, use, all});
}

std::vector<Field> fields_of_row(Model model, MachineFields of_machine) {
  const UsesOfModel uses = uses_of(model, of_machine);
  std::vector<Field>& fields = of_machine.fields;
  for (Field& field : fields) field.use = uses.by_path.at(field.path).joined(field.use);
  put_profile_uses(fields, uses.all);
  const Field *viscosity = table::find_row(fields, keys().viscosity),
              *grade = table::find_row(fields, keys().oil_grade);
  if (viscosity != nullptr) add_grade(fields, model, Use((grade != nullptr ? grade : viscosity)->use));
  table::add_case_fields(fields, model, Use(uses.all, {}));
  table::add_bearing_type(fields, model, Use(uses.all, {}));
  if (!uses.rated.is_empty())
    table::add_requirements(fields, model, Use(uses.rated, uses.all.without(uses.rated)));
  table::add_catalogue_fields(fields, model, uses.all);
  return std::move(of_machine.fields);
}

std::map<Model, std::vector<Field>> fields_by_model() {
  std::map<Model, std::vector<Field>> all;
  Machines::each([&]<class Row>(Row, std::size_t) {
    MachineFields visit(Row::model);
    typename Row::Type machine{};
    describe(visit, machine);
    all[Row::model] = fields_of_row(Row::model, std::move(visit));
  });
  return all;
}

const std::map<Model, std::vector<Field>>& all_machine_fields() {
  static const std::map<Model, std::vector<Field>> all = fields_by_model();
  return all;
}

bool state_the_same(const Field& one, const Field& other) {
  return one.kind == other.kind && one.meaning == other.meaning && one.default_text == other.default_text &&
         one.default_reason == other.default_reason && one.dimension.name == other.dimension.name &&
         one.range.least == other.range.least && one.range.most == other.range.most &&
         one.numerical == other.numerical && std::ranges::is_permutation(one.choices, other.choices);
}

void merge(const Field& of_machine, Field& field) {
  if (!state_the_same(of_machine, field))
    throw std::logic_error(fmt::format("two rows of '{}' differ: '{}' and '{}'", field.path,
                                       field.default_text, of_machine.default_text));
  field.models |= of_machine.models;
  field.required_by |= of_machine.required_by;
}

}  // namespace

const std::vector<Field>& fields_of_machine(Model model) {
  static const std::vector<Field> none;
  const auto found = all_machine_fields().find(model);
  return found == all_machine_fields().end() ? none : found->second;
}

void add_machine_fields(std::vector<Field>& fields) {
  Machines::each([&]<class Row>(Row, std::size_t) {
    for (const Field& of_machine : fields_of_machine(Row::model)) {
      auto same = std::ranges::find(fields, of_machine.path, &Field::path);
      if (same == fields.end())
        same = fields.insert(fields.end(), of_machine);
      else
        merge(of_machine, *same);
      same->of_machines.emplace_back(Row::model, of_machine.use);
    }
  });
}

}  // namespace orbearing::app
