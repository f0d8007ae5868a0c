#include "app/case/field_table.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <numeric>
#include <stdexcept>
#include <unordered_map>

#include "app/case/described_fields.hpp"
#include "app/case/drivetrain_analyses.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/machine_fields.hpp"
#include "app/case/machine_rows.hpp"

namespace orbearing::app {

namespace {

constexpr std::string_view kSetsBlock = "sets.";
constexpr std::size_t kLongestName = 40;

// Place of a path among its neighbours: for each of its blocks, when the table first names it.
using BlockOrder = std::vector<std::size_t>;

BlockOrder block_order(const std::string& path, std::map<std::string, std::size_t>& first_seen) {
  BlockOrder order;
  for (std::size_t dot = path.find('.');; dot = path.find('.', dot + 1)) {
    order.push_back(first_seen.try_emplace(path.substr(0, dot), first_seen.size()).first->second);
    if (dot == std::string::npos) return order;
  }
}

// The order in which cases are written, where it is not that of the rows: keys of blocks. What is not listed
// follows.
const std::pair<std::string_view, std::vector<std::string_view>> written_first[] = {
    {"",
     {"name",     "source",    "model",    "input",   "parallel_stage", "spectrum", "gearset",    "bearing",
      "load",     "operation", "material", "contact", "lubricant",      "film",     "life",       "inertia",
      "numerics", "traction",  "drag",     "support", "simulation",     "heat",     "equilibrium"}},
    {"input.", {"member", "power", "torque", "torque_curve"}},
    {"gearset.", {"fixed", "planets", "teeth", "module", "pressure_angle", "profile_shift", "face_width"}},
    {"bearing.",
     {"type", "per_planet", "designation", "complement", "rollers", "roller_diameter", "roller_length",
      "pitch_diameter", "clearance_class", "radial_clearance"}},
    {"bearing.",
     {"rings", "bore", "outside_diameter", "width", "cage", "laminae", "profile", "misalignment",
      "inner_race", "outer_race"}},
    {"bearing.cage.",
     {"inner_diameter", "outer_diameter", "width", "material", "density", "guide_land_diameter", "guidance",
      "pocket_clearance", "pocket_stiffness", "pocket_damping", "pocket_friction", "largest_eccentricity",
      "touch_down_stiffness"}},
    {"operation.",
     {"shaft_speed", "outer_speed", "speeds", "load_factors", "turning_race", "shaft_acceleration"}},
    {"contact.", {"law", "damping", "lubrication", "roughness", "boundary_friction"}}};

// Blocks stay together in what is written from the table, whichever file adds their fields.
std::vector<Field> grouped(std::vector<Field> fields) {
  std::map<std::string, std::size_t> first_seen;
  for (const auto& [block, keys] : written_first)
    for (const std::string_view key : keys) block_order(std::string(block) + std::string(key), first_seen);
  std::vector<std::pair<BlockOrder, Field*>> order;
  for (Field& field : fields) order.emplace_back(block_order(field.path, first_seen), &field);
  std::ranges::stable_sort(order, {}, &std::pair<BlockOrder, Field*>::first);
  std::vector<Field> sorted;
  sorted.reserve(fields.size());
  for (const auto& [place, field] : order) sorted.push_back(std::move(*field));
  return sorted;
}

// Models whose cases are no types.
unsigned models_by_table() {
  unsigned models = every_model;
  Machines::each([&]<class Row>(Row, std::size_t) { models &= ~unsigned{Row::model}; });
  return models;
}

std::vector<Field> build_table() {
  const unsigned models = models_by_table();
  std::vector<Field> fields;
  table::add_case_fields(fields, models, Use(all_of_drivetrains(), {}));
  table::add_drivetrain_fields(fields);
  table::add_bearing_fields(fields);
  table::add_static_fields(fields);
  table::add_oil_fields(fields, models);
  for (Field& field : fields)
    if ((field.models & planetary_drivetrain) != 0)
      field.use = with_carrier_beside(
          with_carrier_body(with_planet_defect(field.use, field.path), field.path), field.path);
  table::add_catalogue_fields(fields, models);
  add_machine_fields(fields);
  std::erase_if(fields, [](const Field& field) { return field.models == no_model; });
  return grouped(std::move(fields));
}

std::unordered_map<std::string_view, const Field*> fields_by_path() {
  std::unordered_map<std::string_view, const Field*> by_path;
  for (const Field& field : all_fields()) by_path.emplace(field.path, &field);
  return by_path;
}

// Levenshtein's distance: least number of characters put in, taken out or replaced.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

}  // namespace

const std::vector<Field>& all_fields() {
  static const std::vector<Field> fields = build_table();
  return fields;
}

bool is_name(std::string_view name) {
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  return !name.empty() && name.size() <= kLongestName && is_letter(name.front()) &&
         std::all_of(name.begin(), name.end(), [&](char c) {
           return is_letter(c) || std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '_';
         });
}

std::size_t set_prefix_length(std::string_view path) {
  if (!path.starts_with(kSetsBlock)) return 0;
  const std::size_t dot = path.find('.', kSetsBlock.size());
  const bool named =
      dot != std::string_view::npos && is_name(path.substr(kSetsBlock.size(), dot - kSetsBlock.size()));
  return named ? dot + 1 : 0;
}

bool is_of_one_set(const Field& field) {
  return field.path == keys().fixed_member || field.path == keys().driven_member;
}

bool in_each_set(const Field& field) {
  const bool of_a_set = field.path.starts_with("gearset.") || field.path.starts_with("bearing.");
  return of_a_set && (field.models & planetary_drivetrain) != 0 && !is_of_one_set(field);
}

const Field& shaft_field() {
  static const Field field{
      .path = "shafts",
      .kind = Kind::list,
      .meaning = "parts that rotate together: members as in 'reduction.sun', and motor, load or ground",
      .use = Use(analyses_with_lives() | AnalysisId::planet_stiffness | AnalysisId::planet_defect, {}),
      .models = planetary_drivetrain,
      .element = Kind::text};
  return field;
}

const Field* find_field(std::string_view path) {
  if (path.starts_with("shafts.")) return is_name(path.substr(7)) ? &shaft_field() : nullptr;
  if (const std::size_t prefix = set_prefix_length(path); prefix > 0) {
    const Field* field = find_field(path.substr(prefix));
    return field != nullptr && in_each_set(*field) ? field : nullptr;
  }
  static const std::unordered_map<std::string_view, const Field*> by_path = fields_by_path();
  const auto found = by_path.find(path);
  return found == by_path.end() ? nullptr : found->second;
}

std::vector<const Field*> fields_of(unsigned models) {
  std::vector<const Field*> found;
  for (const Field& field : all_fields())
    if ((field.models & models) != 0) found.push_back(&field);
  return found;
}

std::string_view model_name(Model model) {
  switch (model) {
    case planetary_drivetrain:
      return "planetary-drivetrain";
    case roller_bearing:
      return "roller-bearing";
    case gear_pair:
      return "gear-pair";
    case ball_bearing:
      return "ball-bearing";
    case ball_motion:
      return "ball-bearing with a block 'simulation'";
    case raceway_defect:
      return "raceway-defect";
    case roller_defect:
      return "raceway-defect of rollers";
    case duplex_pair:
      return "duplex-pair";
    case spin_film:
      return "spin-film";
    case no_model:
      break;
  }
  return "";
}

const std::vector<Model>& models() {
  static const std::vector<Model> all{planetary_drivetrain, roller_bearing, ball_bearing, gear_pair,
                                      raceway_defect,       duplex_pair,    spin_film};
  return all;
}

Model model_of(std::string_view name) {
  for (const Model model : models())
    if (model_name(model) == name) return model;
  return no_model;
}

Model specific_model(Model named, bool simulation, bool rollers) {
  if (named == ball_bearing && simulation) return ball_motion;
  return named == raceway_defect && rollers ? roller_defect : named;
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& known) {
  std::string nearest;
  std::size_t least =
      std::max<std::size_t>(2, word.size() / 3) + 1;  // further apart is no slip of the keyboard
  for (const std::string& candidate : known) {
    const std::size_t distance = edit_distance(word.substr(0, 100), candidate);
    if (distance >= least || distance >= candidate.size()) continue;
    least = distance;
    nearest = candidate;
  }
  return nearest;
}

namespace table {

Field& Rows::add(Kind kind, std::string path, std::string meaning, const Use& use, Range range) {
  fields_.push_back({.path = std::move(path),
                     .kind = kind,
                     .meaning = std::move(meaning),
                     .use = use,
                     .models = models_,
                     .range = range});
  return fields_.back();
}

Field& Rows::quantity(std::string path, std::string meaning, const Use& use, const Dimension& dimension,
                      Range range) {
  Field& field = add(Kind::quantity, std::move(path), std::move(meaning), use, range);
  field.dimension = dimension;
  return field;
}

Field& Rows::number(std::string path, std::string meaning, const Use& use, Range range) {
  return add(Kind::number, std::move(path), std::move(meaning), use, range);
}

Field& Rows::integer(std::string path, std::string meaning, const Use& use, Range range) {
  return add(Kind::integer, std::move(path), std::move(meaning), use, range);
}

Field& Rows::choice(std::string path, std::string meaning, const Use& use, std::vector<std::string> choices) {
  Field& field = add(Kind::choice, std::move(path), std::move(meaning), use);
  field.choices = std::move(choices);
  return field;
}

Field& Rows::text(std::string path, std::string meaning, const Use& use) {
  return add(Kind::text, std::move(path), std::move(meaning), use);
}

Field& Rows::list_of_rows(std::string path, std::string meaning, const Use& use,
                          std::vector<ListColumn> columns) {
  Field& field = add(Kind::list, std::move(path), std::move(meaning), use);
  field.element = Kind::list;
  field.columns = std::move(columns);
  return field;
}

Field* find_row(std::vector<Field>& fields, std::string_view path) {
  const auto found = std::ranges::find(fields, path, &Field::path);
  return found == fields.end() ? nullptr : &*found;
}

Field& row_of(std::vector<Field>& fields, std::string_view path) {
  Field* found = find_row(fields, path);
  if (found == nullptr) throw std::logic_error("no field '" + std::string(path) + "'");
  return *found;
}

void add_case_fields(std::vector<Field>& fields, unsigned models, const Use& use) {
  Rows rows(fields, models);
  std::vector<std::string> names;
  for (const Model model : app::models()) names.emplace_back(model_name(model));
  rows.text("name", "name of the case", use).required();
  rows.text("source", "where the data come from; the name of the file unless it is given", use);
  rows.choice("model", "what is computed", use, std::move(names)).required();
}

}  // namespace table

}  // namespace orbearing::app
