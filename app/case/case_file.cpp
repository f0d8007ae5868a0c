#include "app/case/case_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>

#include "app/case/alternatives.hpp"
#include "app/case/bearing_type.hpp"
#include "app/case/catalogue_case.hpp"
#include "app/case/catalogue_checks.hpp"
#include "app/case/catalogue_fields.hpp"
#include "app/case/catalogue_file.hpp"
#include "app/case/consistency.hpp"
#include "app/case/derived_defaults.hpp"
#include "app/case/field_table.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/resolved_case.hpp"
#include "app/case/rows_file.hpp"
#include "app/case/settings.hpp"
#include "app/case/sweep_axes.hpp"
#include "app/case/uncertain_case.hpp"
#include "orbearing/files.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

// Names that may follow a prefix ("gearset.teeth.", "sets.reduction.", ""), in the order of the table.
std::vector<std::string> keys_under(const std::string& prefix, const CaseShape& shape) {
  std::vector<std::string> names;
  const std::size_t of_set = set_prefix_length(prefix);
  const std::string inner = prefix.substr(of_set);
  for (const Field& field : all_fields()) {
    if (!field.path.starts_with(inner)) continue;  // before the dearer question
    if (!(of_set > 0 ? in_each_set(field) : belongs(shape, field.path))) continue;
    const std::string rest = field.path.substr(inner.size());
    std::string name = rest.substr(0, rest.find('.'));
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
  }
  if (prefix.empty() && shape.several) names.insert(names.end(), {"sets", "shafts"});
  if (prefix.empty()) names.insert(names.end(), {"sweep", "uncertain", "assumed"});
  return names;
}

// Hint for keys of gear sets that cannot be stated here, though other programs have them; else empty.
std::string missing_kind_hint(const std::string& key, const std::string& prefix) {
  const bool of_stepped = prefix.ends_with("gearset.stepped_planet.");
  if ((of_stepped && (key == "ring" || key == "sun" || key.ends_with("_ring") || key.ends_with("_sun"))) ||
      (prefix.ends_with("gearset.teeth.") && key != "ring" && key.find("ring") != std::string::npos))
    return "none is required: the first gear of a stepped planet (gearset.teeth.planet) meshes with the sun "
           "alone. Its second gear (gearset.stepped_planet.teeth) meshes with the ring (gearset.teeth.ring). "
           "A "
           "set with two rings or suns (Wolfrom) cannot be stated; two sets in its place give wrong loads";
  const bool of_bodies = prefix.find("gearset.dynamics.") != std::string::npos;
  if (of_bodies && (key.find("tilt") != std::string::npos || key.find("transverse") != std::string::npos))
    return "none is required: inertias and stiffnesses against tilting cannot be stated but for "
           "gearset.dynamics.sun.tilt_stiffness. Modes in three dimensions take them from teeth, bearings "
           "and "
           "gearset.carrier. Modes of a set without these are in its plane";
  return {};
}

// Hint for keys of blocks that were read before and are not any more; else empty.
std::string retired_hint(const std::string& key, const std::string& prefix) {
  if (!prefix.empty() || (key != "measured" && key != "identification")) return {};
  return "a case without it is required: a shaft is no longer identified from measured frequencies. State "
         "the "
         "shaft as spindle.mass, spindle.first_lever, spindle.second_lever and spindle.diameter or inertias";
}

// Requirement for the message on the unknown `key` in the block of `prefix`.
std::string key_hint(const std::string& key, const std::string& prefix, const CaseShape& shape,
                     unsigned models) {
  const std::string set = set_of(prefix);
  if (!set.empty() && key == "fixed")
    return "a known key is required. A member is stationary on a shaft with 'ground'";
  if (std::string hint = missing_kind_hint(key, prefix); !hint.empty()) return hint;
  if (std::string hint = retired_hint(key, prefix); !hint.empty()) return hint;
  // The right name in the wrong block is likelier than a slip of the keyboard.
  for (const bool of_other_models : {false, true})
    for (const Field& field : all_fields()) {
      if ((!set.empty() && !in_each_set(field)) || ((field.models & models) == 0) != of_other_models)
        continue;
      if (field.path == key || field.path.ends_with("." + key))
        return fmt::format("a known key is required; '{}{}' nested by its blocks is one{}",
                           belongs(shape, field.path) ? "" : set, field.path,
                           of_other_models ? ", in cases of another model" : "");
    }
  const std::vector<std::string> siblings = keys_under(prefix, shape);
  // An oil by two viscosities, as data sheets state it, in any spelling.
  if (prefix == "lubricant.")
    for (const char* temperature : {"40", "100"})
      if (key.ends_with(temperature) || key.find(std::string(temperature) + "C") != std::string::npos)
        return fmt::format(
            "a known key is required; did you mean 'lubricant.viscosity_{}', the kinematic "
            "viscosity at {} degC?",
            temperature, temperature);
  const std::string near = nearest_word(key, siblings);
  if (!near.empty()) return fmt::format("a known key is required; did you mean '{}{}'?", prefix, near);
  const bool is_number = !key.empty() && key.find_first_not_of("0123456789") == std::string::npos;
  return fmt::format("one of {} is required{}", fmt::join(siblings, ", "),
                     is_number ? "; a number takes a decimal point, not a comma" : "");
}

class Resolver {
 public:
  Resolver(const Entry& root, const std::string& file, std::vector<Mistake>& mistakes)
      : root_(root), mistakes_(mistakes) {
    data_.file = file;
  }

  CaseData resolve() {
    find_model();
    find_shape();
    read_block(root_, "");
    if (model_ != no_model) {
      forget_printed_ratings();
      check_designations();
      fill_from_catalogue(data_, model_);
    }
    report_missing();
    fill_defaults();
    settle_alternatives(data_, model_, mistakes_);
    fill_derived_defaults(data_);
    read_assumed();
    read_sweep();
    read_uncertain_block();
    return std::move(data_);
  }

 private:
  void add_error(Location location, const std::string& path, std::string found, std::string required) {
    mistakes_.push_back({location, path, {std::move(found), std::move(required)}});
    faulty_.insert(path);
  }

  // Ratings, and an assumed class, that a resolved case repeats from a catalogue are no statements of the
  // user's.
  void forget_printed_ratings() {
    const Member* assumed = find_member(root_, "assumed");
    if (assumed == nullptr) return;
    for (const Member& member : assumed->value.members) {
      const auto value = data_.values.find(member.key);
      if (value == data_.values.end() || value->second.location.option) continue;
      if ((is_rating(member.key) || is_of_default_class(assumed->value, member.key)) &&
          member.value.text.starts_with("default:") &&
          data_.values.contains(set_of(member.key) + keys().designation))
        value->second.from_default = true;
    }
  }

  // A class that was assumed, and what follows from it.
  static bool is_of_default_class(const Entry& assumed, const std::string& path) {
    const std::string set = set_of(path);
    if (!is_one_of(path.substr(set.size()),
                   {keys().clearance_class, keys().radial_clearance, keys().clearance_state}))
      return false;
    const Member* of_class = find_member(assumed, set + keys().clearance_class);
    return of_class != nullptr && of_class->value.text.starts_with("default:");
  }

  static bool is_rating(std::string_view path) {
    return is_one_of(path.substr(set_prefix_length(path)),
                     {keys().dynamic_capacity, keys().static_capacity, keys().fatigue_load_limit});
  }

  // Reports unknown designations; values that would follow from them are not reported as missing.
  void check_designations() {
    for (const std::string& prefix : set_prefixes(data_.shape)) {
      const auto name = data_.values.find(prefix + keys().designation);
      if (name == data_.values.end()) continue;
      const std::string file = prefix + catalogue_keys::kCatalogue;
      const auto table = data_.values.find(file);
      const auto message = unknown_designation(
          name->second.value.given, table == data_.values.end() ? nullptr : &table->second.value, model_);
      if (!message) continue;
      if (is_faulty(file))
        faulty_.insert(name->first);  // the file that should have it is to blame
      else
        add_error(name->second.location, name->first, message->found, message->required);
      data_.values.erase(name);
    }
  }

  // Without a good model, every field of any model is let pass and none is missed.
  void find_model() {
    const Member* member = find_member(root_, "model");
    if (member == nullptr || member->value.shape != Entry::Shape::scalar) return;
    model_ = model_of(member->value.text);
    const Member* bearing = find_member(root_, "bearing");
    const bool rollers = bearing != nullptr && bearing->value.shape == Entry::Shape::block &&
                         find_member(bearing->value, "rollers") != nullptr;
    model_ = specific_model(model_, find_member(root_, "simulation") != nullptr, rollers);
    if (model_ != no_model) allowed_ = model_;
  }

  // A drivetrain with sets or shafts has several sets; the fields of one set beside them are a mistake.
  void find_shape() {
    if ((allowed_ & planetary_drivetrain) == 0) return;
    const Member* sets = find_member(root_, "sets");
    const Member* shafts = find_member(root_, "shafts");
    data_.shape.several = sets != nullptr || shafts != nullptr;
    data_.shape.defect = find_member(root_, "defect") != nullptr;
    if (!data_.shape.several) {
      find_parts(root_, data_.shape);
      return;
    }
    for (const char* key : {"gearset", "bearing"})
      if (const Member* own = find_member(root_, key); own != nullptr)
        add_error(own->location.option ? own->location : (sets != nullptr ? sets : shafts)->location, key,
                  "the fields of one set together with 'sets' and 'shafts'",
                  "either gearset and bearing, or sets and shafts, are required");
  }

  void read_block(const Entry& block, const std::string& prefix) {
    std::map<std::string, int> first_line;
    for (const Member& member : block.members) {
      const std::string path = prefix + member.key;
      const auto [first, fresh] = first_line.emplace(member.key, member.location.line);
      if (!fresh)
        add_error(member.location, path,
                  member.location.option ? "duplicate key"
                                         : fmt::format("duplicate key, first on line {}", first->second),
                  "each key once is required");
      else if (prefix.empty() &&
               (member.key == "sweep" || member.key == "uncertain" || member.key == "assumed"))
        require_block(member, path, "field paths");
      else if (data_.shape.several && prefix.empty() && (member.key == "sets" || member.key == "shafts"))
        read_named(member);
      else
        read_member(member, path, prefix);
    }
  }

  // The blocks `sets` and `shafts`, whose keys are names of the user's.
  void read_named(const Member& block) {
    const bool sets = block.key == "sets";
    block_locations_[block.key] = block.location;
    if (!require_block(block, block.key, sets ? "names of sets" : "names of shafts")) return;
    std::vector<std::string>& names = sets ? data_.shape.sets : data_.shape.shafts;
    for (const Member& member : block.value.members) {
      const std::string path = block.key + "." + member.key;
      if (!is_name(member.key)) {
        add_error(member.location, path, "the name " + quote(member.key), name_rule);
      } else if (std::find(names.begin(), names.end(), member.key) != names.end()) {
        add_error(member.location, path, "duplicate key", "each key once is required");
      } else {
        names.push_back(member.key);
        read_member(member, path, block.key + ".");
      }
    }
    if (names.size() > (sets ? most_sets : 3 * most_sets))
      add_error(block.location, block.key, fmt::format("{} {}", names.size(), block.key),
                fmt::format("at most {} are required", sets ? most_sets : 3 * most_sets));
  }

  void read_member(const Member& member, const std::string& path, const std::string& prefix) {
    const Field* field = find_field(path);
    const bool dotted = member.key.find('.') != std::string::npos;
    const std::vector<std::string> keys = keys_under(path + ".", data_.shape);
    const Field* of_block = keys.empty() ? field_under(path + ".") : nullptr;
    if (field != nullptr && !dotted) {
      read_value(member, path, *field);
    } else if (!dotted && !keys.empty()) {
      block_locations_[path] = member.location;
      if (require_block(member, path, fmt::format("{}", fmt::join(keys, ", "))))
        read_block(member.value, path + ".");
    } else if (!dotted && of_block != nullptr && !is_faulty(path)) {
      const auto [found, required] = unused_field(data_.shape, of_block->path);
      add_error(member.location, path, "the block " + quote(member.key) + ", " + found, required);
    } else if (!is_faulty(path)) {
      add_error(member.location, path, "unknown key", key_hint(member.key, prefix, data_.shape, allowed_));
    }
  }

  // A field of this model that the block holds in a case of another shape; null where there is none.
  const Field* field_under(const std::string& prefix) const {
    const std::vector<Field>& fields = all_fields();
    const auto found = std::find_if(fields.begin(), fields.end(), [&](const Field& field) {
      return field.path.starts_with(prefix) && (field.models & allowed_) != 0;
    });
    return found == fields.end() ? nullptr : &*found;
  }

  bool require_block(const Member& member, const std::string& path, const std::string& keys) {
    if (member.value.shape == Entry::Shape::block) return true;
    add_error(member.value.location, path, describe(member.value) + " found",
              "a block with keys (" + keys + ") is required");
    return false;
  }

  void read_value(const Member& member, const std::string& path, const Field& field) {
    if ((field.models & allowed_) == 0) {
      add_error(member.location, path, fmt::format("a field that {} does not use", model_name(model_)),
                "a case without it is required");
      return;
    }
    if (!belongs(data_.shape, path)) {
      if (is_faulty(path)) return;
      const auto [found, required] = unused_field(data_.shape, path);
      add_error(member.location, path, found, required);
      return;
    }
    const std::size_t before = mistakes_.size();
    const bool elsewhere = field.from_file && member.value.shape == Entry::Shape::block;
    const auto read_file = field.columns.empty() ? matrix_of_file : rows_of_file;
    const Entry value =
        elsewhere ? read_file(field, member.value, path, data_.file, mistakes_) : member.value;
    if (mistakes_.size() > before) {
      faulty_.insert(path);
      return;
    }
    FieldReading reading = read_field(field, value);
    if (!reading.good) {
      const bool oil = field.path == keys().oil_grade;
      add_error(reading.location.value_or(member.value.location), path, reading.message.found,
                reading.message.required + likely_place(path, field, value) +
                    (oil ? "; an oil of another viscosity is stated by lubricant.viscosity_40 and "
                           "lubricant.viscosity_100 instead of a grade"
                         : ""));
      return;
    }
    if (field.path == catalogue_keys::kCatalogue &&
        !take_catalogue(reading.value, member.value.location, path, data_.file, mistakes_)) {
      faulty_.insert(path);
      return;
    }
    StoredValue& stored = data_.values[path];
    stored = {std::move(reading.value), member.value.location, false};
    for (const Entry& item : member.value.items) stored.item_locations.push_back(item.location);
  }

  // The only quantity of another kind in the same block that the text fits, e.g. a torque given as a power.
  std::string likely_place(const std::string& path, const Field& field, const Entry& value) const {
    if (field.kind != Kind::quantity || value.shape != Entry::Shape::scalar) return "";
    const std::string block = path.substr(0, path.rfind('.') + 1);
    std::vector<std::string> fitting;
    for (const auto& [other, of_block] :
         inputs_of(model_ == no_model ? every_model : unsigned{model_}, data_.shape))
      if (of_block->kind == Kind::quantity && of_block->dimension.si != field.dimension.si &&
          other.starts_with(block) && other.find('.', block.size()) == std::string::npos &&
          read_field_text(*of_block, value.text).good)
        fitting.push_back(other);
    return fitting.size() == 1 ? fmt::format("; did you mean '{}'?", fitting.front()) : "";
  }

  bool is_faulty(std::string path) const {
    while (!faulty_.contains(path)) {
      const auto dot = path.rfind('.');
      if (dot == std::string::npos) return false;
      path.resize(dot);
    }
    return true;
  }

  Location nearest_block(std::string path) const {
    for (auto dot = path.rfind('.'); dot != std::string::npos; dot = path.rfind('.')) {
      path.resize(dot);
      if (const auto found = block_locations_.find(path); found != block_locations_.end())
        return found->second;
    }
    return {};
  }

  // One of several sets may have no bearing: it carries power and has no life.
  bool is_needed(const Input& input) const {
    if (model_ == no_model) return (input.field->required_by & every_model) == every_model;
    const unsigned kind = data_.shape.teeth ? unsigned{model_} : toothless_set | model_;
    return (input.field->required_by & kind) != 0 && !is_of_missing_bearing(input) &&
           !is_of_missing_cage(input) && !is_of_other_type(input);
  }

  // Nothing is missed of what another input would give that has a mistake itself, found here or by its own
  // check.
  bool is_of_faulty_giver(const Input& input) const {
    const std::string set = set_of(input.path);
    const std::vector<Condition> givers = given_by(input.field->path);
    return std::any_of(givers.begin(), givers.end(), [&](const Condition& giver) {
      const std::string path = set + giver.paths.front();
      return is_faulty(path) || (giver.values.empty() && data_.values.contains(path));
    });
  }

  // Inputs that would give what is missing.
  std::string in_its_place(const Input& input) const {
    std::vector<std::string> others;
    const std::string set = set_of(input.path);
    for (const Condition& giver : given_by(input.field->path)) {
      const Field* other = find_field(set + giver.paths.front());
      if (other == nullptr || (other->models & allowed_) == 0 ||
          data_.values.contains(set + giver.paths.front()))
        continue;
      others.push_back(set + giver.paths.front() + (giver.values.empty() ? "" : ": " + giver.values.front()));
    }
    return others.empty() ? "" : fmt::format(", or {} instead", fmt::join(others, " or "));
  }

  // As stated in the set of an input; empty: not at all.
  std::string given_beside(const Input& input, const std::string& path) const {
    const auto found = data_.values.find(set_of(input.path) + path);
    return found == data_.values.end() ? "" : found->second.value.given;
  }

  // A full complement of rollers has no cage.
  bool is_of_missing_cage(const Input& input) const {
    return input.field->path.starts_with("bearing.cage.") && given_beside(input, keys().complement) == "full";
  }

  bool is_of_other_type(const Input& input) const {
    return model_ == planetary_drivetrain &&
           goes_without(given_beside(input, keys().bearing_type), input.field->path);
  }

  bool is_of_missing_bearing(const Input& input) const {
    return input.field->path.starts_with("bearing.") && set_prefix_length(input.path) > 0 &&
           !has_bearing(input.path);
  }

  void report_missing() {
    for (const Input& input : inputs_of(every_model, data_.shape))
      if (is_needed(input) && !data_.values.contains(input.path) && !is_faulty(input.path) &&
          !is_of_faulty_giver(input))
        add_error(nearest_block(input.path), input.path, "missing",
                  what_is_missing(*input.field) + " is required" + in_its_place(input));
    if (!data_.shape.several) return;
    for (const auto& [key, names] :
         {std::pair<std::string, const std::vector<std::string>&>{"sets", data_.shape.sets},
          {"shafts", data_.shape.shafts}})
      if (names.empty() && !is_faulty(key))
        add_error(nearest_block(key + "."), key, "missing",
                  "sets: {NAME: {gearset: ..., bearing: ...}} and shafts: {NAME: [motor, SET.sun], ...} are "
                  "required");
  }

  // Types other than this one are those of planets.
  std::string what_is_missing(const Field& field) const {
    const bool single = field.path == keys().bearing_type && model_ != planetary_drivetrain;
    return single ? "cylindrical-roller" : requirement(field);
  }

  bool has_bearing(const std::string& path) const {
    const std::string set = set_of(path);
    return set.empty() ? data_.shape.bearing : block_locations_.contains(set + "bearing");
  }

  // For a file of the common name case.yaml the source includes the name of its folder.
  void fill_source() {
    if (data_.values.contains("source") || is_faulty("source")) return;
    const std::filesystem::path file(data_.file);
    const bool common = file.filename() == "case.yaml" && file.has_parent_path();
    const std::filesystem::path shown =
        common ? file.parent_path().filename() / file.filename() : file.filename();
    data_.values["source"] = {
        read_field_text(*find_field("source"), printable(shown.empty() ? "case" : shown.string())).value,
        {},
        true};
    data_.assumed["source"] = "default: name of the case file";
  }

  void fill_defaults() {
    fill_source();
    for (const auto& [path, field] : inputs_of(model_, data_.shape)) {
      if (field->default_text.empty() || !field->alternatives.empty() || data_.values.contains(path) ||
          is_faulty(path) || is_of_missing_bearing({path, field}) ||
          (field->default_without_bearing && has_bearing(path)))
        continue;
      data_.values[path] = {read_field_text(*field, field->default_text).value, {}, true};
      data_.assumed[path] = "default: " + field->default_reason;
    }
  }

  void read_assumed() {
    const Member* assumed = find_member(root_, "assumed");
    if (assumed == nullptr) return;
    read_each_once(assumed->value, "assumed", mistakes_, [&](const Member& member) { read_reason(member); });
  }

  void read_reason(const Member& member) {
    const std::string path = "assumed." + member.key;
    const Entry& reason = member.value;
    const auto value = data_.values.find(member.key);
    if (value == data_.values.end()) {
      if (!is_faulty(member.key))
        add_error(member.location, path, unknown_assumption(member.key), assumption_hint(member.key));
      return;
    }
    if (reason.shape != Entry::Shape::scalar ||
        reason.text.find_first_not_of(" \t\r\n") == std::string::npos) {
      add_error(reason.location, path, describe(reason) + " found",
                "the reason for the value, as a text, is required");
      return;
    }
    // The file's reason does not apply to a value that an option replaced.
    if (value->second.location.option && !reason.location.option) return;
    if (!value->second.replaced.empty()) return;  // nor is one that another input replaced
    if (value->second.from_default && is_rating(member.key)) return;
    data_.assumed[member.key] = reason.text;
  }

  static std::string unknown_assumption(const std::string& key) {
    return find_field(key) == nullptr ? "unknown path" : "a reason for a missing value";
  }

  std::string assumption_hint(const std::string& key) const {
    std::vector<std::string> known;
    for (const auto& [path, value] : data_.values) known.push_back(path);
    const std::string near = find_field(key) == nullptr ? nearest_word(key, known) : "";
    return near.empty()
               ? "the path of a value of this case is required"
               : fmt::format("the path of a value of this case is required; did you mean '{}'?", near);
  }

  void read_sweep() {
    const Member* sweep = find_member(root_, "sweep");
    if (sweep != nullptr && model_ != no_model && model_ != planetary_drivetrain) {
      add_error(sweep->location, "sweep", fmt::format("a sweep of a {}", model_name(model_)),
                "a case without it is required; planetary-drivetrain is the model that is swept");
      return;
    }
    if (sweep != nullptr && sweep->value.shape == Entry::Shape::block)
      data_.axes = std::make_shared<const std::vector<SweepAxis>>(
          read_axes(sweep->value, allowed_, data_.shape, mistakes_));
  }

  void read_uncertain_block() {
    const Member* uncertain = find_member(root_, "uncertain");
    if (uncertain == nullptr) return;
    if (uncertain->value.shape == Entry::Shape::block)
      data_.uncertain = std::make_shared<const StatedUncertainty>(
          read_uncertain(uncertain->value, allowed_, data_.shape, mistakes_));
  }

  const Entry& root_;
  std::vector<Mistake>& mistakes_;
  CaseData data_;
  Model model_ = no_model;
  unsigned allowed_ = every_model;
  std::set<std::string> faulty_;
  std::map<std::string, Location> block_locations_;
};

constexpr std::size_t largest_file =
    1U << 20U;  // [byte] a hundred times the largest case, small enough to check at once

constexpr const char* file_path = "(file)";

[[noreturn]] void refuse_file(const std::string& file, std::string found) {
  throw_mistakes(file, {{Location{}, file_path, {std::move(found), "a readable case file is required"}}});
}

// Kind of a file that `orbearing convert` reads, e.g. "a REXS file"; empty for other files.
std::string_view kind_to_convert(std::string_view text) {
  if (text.starts_with("PK\x03\x04")) return "a ZIP file";
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  const std::string_view beginning = text.substr(0, 4096);
  const auto has = [&](std::string_view word) { return beginning.find(word) != std::string_view::npos; };
  if (text.starts_with("<")) return has("<model") ? "a REXS file" : "an XML file";
  const bool model =
      text.starts_with("{") && has("\"model\"") && (has("\"relations\"") || has("\"components\""));
  return model ? "a REXS file" : "";
}

void refuse_kind_to_convert(const std::string& file, std::string_view text) {
  const std::string_view kind = kind_to_convert(text);
  if (kind.empty()) return;
  throw_mistakes(
      file, {{Location{},
              file_path,
              {std::string(kind),
               fmt::format("a case in YAML is required; of a REXS file (.rexs, .rexsj, .rexsz) 'orbearing "
                           "convert {} -o DIR' makes cases",
                           file)}}});
}

std::string read_file(const std::string& file) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(file, ignored);
  if (std::filesystem::is_directory(status)) refuse_file(file, "a folder without a file case.yaml");
  // Opening a pipe would wait for its other end.
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    refuse_file(file, "a pipe, a device or a socket");
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse_file(file, std::string("cannot be opened (") + std::strerror(errno) + ")");
  std::string text(largest_file + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) refuse_file(file, "cannot be read");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  refuse_kind_to_convert(file, text);
  if (text.size() > largest_file) refuse_file(file, "more than 1 MiB");
  return text;
}

std::optional<Entry> read_root(std::string_view text, std::vector<Mistake>& mistakes) {
  try {
    Entry root = read_yaml(text);
    if (root.shape == Entry::Shape::block) return root;
    const bool nothing = root.shape == Entry::Shape::nothing;
    mistakes.push_back({root.location,
                        file_path,
                        {nothing ? "an empty file" : describe(root) + " found",
                         "keys and values, beginning with 'name: ...', are required"}});
  } catch (const YamlFault& fault) {
    mistakes.push_back({fault.location, file_path, fault.message});
  }
  return std::nullopt;
}

struct Outcome {
  std::optional<ResolvedCase> resolved;  // none where the text is no YAML
  std::vector<Mistake> mistakes;
};

Outcome resolve_all(std::string_view text, const std::string& name,
                    const std::vector<std::string>& settings) {
  Outcome outcome;
  std::optional<Entry> root = read_root(text, outcome.mistakes);
  Entry unread;
  std::vector<FormerKey> former = former_keys_in(root ? *root : unread, settings);
  if (root) rename_former_keys(*root);
  apply_settings(root ? *root : unread, settings, outcome.mistakes);
  if (!root) return outcome;
  CaseData data = Resolver(*root, name, outcome.mistakes).resolve();
  data.former = std::move(former);
  outcome.resolved.emplace(std::move(data));
  // The rules of consistency depend on the model.
  if (outcome.resolved->model() == no_model) return outcome;
  check_consistency(*outcome.resolved, outcome.mistakes);
  check_sweep_consistency(*outcome.resolved, outcome.mistakes);
  check_uncertain(*outcome.resolved, outcome.mistakes);
  return outcome;
}

// Mistakes at values of the file that occur only with the settings are reported at the settings: a key that a
// replaced block lacks, a bore that no longer fits.
void blame_settings(std::vector<Mistake>& mistakes, const std::vector<Mistake>& of_file_alone,
                    std::size_t settings) {
  const auto is_of_file = [&](const Mistake& mistake) {
    return std::any_of(of_file_alone.begin(), of_file_alone.end(), [&](const Mistake& other) {
      return other.path == mistake.path && other.message.found == mistake.message.found;
    });
  };
  for (Mistake& mistake : mistakes)
    if (!mistake.location.option && mistake.location.file.empty() && !is_of_file(mistake))
      mistake.location = {true, static_cast<int>(settings), 1};
}

}  // namespace

CaseSource source_of(const std::string& file) {
  const std::filesystem::path within = std::filesystem::path(file) / "case.yaml";
  std::error_code ignored;
  const std::string path = std::filesystem::is_regular_file(within, ignored) ? within.string() : file;
  return {.name = path, .text = read_file(path)};
}

ResolvedCase parse_case(CaseSource& source, const std::vector<std::string>& settings) {
  const KeepingFiles keeping(source.files);
  return parse_case(source.text, source.name, settings);
}

ResolvedCase read_case(const std::string& file, const std::vector<std::string>& settings) {
  const CaseSource source = source_of(file);
  return parse_case(source.text, source.name, settings);
}

ResolvedCase read_point(const std::string& file, const std::vector<std::string>& settings) {
  const ResolvedCase resolved = read_case(file, settings);
  std::vector<Mistake> mistakes;
  for (const SweepAxis& axis : resolved.axes())
    if (axis.location.option)
      mistakes.push_back({axis.location,
                          "sweep." + axis.path,
                          {"a sweep for a command that computes one operating point",
                           "one value, as in --set " + axis.path +
                               "=..., is required; sweeps are those of "
                               "orbearing sweep"}});
  if (!mistakes.empty()) throw_mistakes(file, std::move(mistakes));
  return resolved.without_sweep();
}

ResolvedCase parse_case(std::string_view text, const std::string& name,
                        const std::vector<std::string>& settings) {
  Outcome outcome = resolve_all(text, name, settings);
  if (outcome.mistakes.empty()) return std::move(*outcome.resolved);
  if (!settings.empty())
    blame_settings(outcome.mistakes, resolve_all(text, name, {}).mistakes, settings.size());
  throw_mistakes(name, std::move(outcome.mistakes));
}

}  // namespace orbearing::app
