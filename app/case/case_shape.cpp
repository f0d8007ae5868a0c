#include "app/case/case_shape.hpp"

#include "app/case/input_keys.hpp"

#include <algorithm>
#include <cctype>

namespace orbearing::app {

namespace {

constexpr std::string_view sets_block = "sets.";
constexpr std::string_view shafts_block = "shafts.";

bool has_name(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void add_sets(unsigned models, const CaseShape& shape, std::vector<Input>& inputs) {
  for (const std::string& set : shape.sets)
    for (const Field& field : all_fields())
      if ((field.models & models) != 0 && in_each_set(field))
        inputs.push_back({set_prefix(set) + field.path, &field});
  for (const std::string& shaft : shape.shafts) inputs.push_back({shaft_path(shaft), &shaft_field()});
}

}  // namespace

std::string shaft_path(std::string_view shaft) {
  return std::string(shafts_block) + std::string(shaft);
}

std::vector<std::string> set_prefixes(const CaseShape& shape) {
  if (!shape.several) return {""};
  std::vector<std::string> prefixes;
  for (const std::string& set : shape.sets) prefixes.push_back(set_prefix(set));
  return prefixes;
}

void find_parts(const Entry& root, CaseShape& shape) {
  const Member* gearset = find_member(root, "gearset");
  const auto states = [&](const char* key) {
    return gearset != nullptr && gearset->value.shape == Entry::Shape::block &&
           find_member(gearset->value, key) != nullptr;
  };
  shape.bearing = find_member(root, "bearing") != nullptr;
  shape.defect = shape.bearing && find_member(root, "defect") != nullptr;
  shape.teeth = shape.bearing || !states("dynamics") || states("teeth");
}

namespace {

// Whether the field has no use without a bearing.
bool is_of_bearing(const Field& field) {
  return is_one_of(field.path, {keys().own_orbit, keys().gravity, keys().acceleration, "spectrum"}) ||
         begins_with_one_of(field.path, {"bearing.", "contact.", "traction.", "lubricant.", "film.", "life.",
                                         "drag.", "heat.", "support.", "simulation.", "numerics."});
}

// Whether the field describes a scratch or the analysis of its vibration.
bool is_of_defect(const Field& field) {
  return begins_with_one_of(field.path, {"defect.", "signal."});
}

// Only a case of several sets has it.
bool is_of_several_sets(const Field& field) {
  return field.path == kScratchedSet;
}

bool is_of_teeth(const Field& field) {
  if (field.path.find('.') == std::string::npos ||
      is_one_of(field.path, {keys().planets, keys().pressure_angle}))
    return false;
  // Fields of the drive and of the run in time have no use without tooth numbers.
  for (const char* used : {"run_up", "backlash", "separation", "error", "periods", "plate_ratio"})
    if (field.path.find(used) != std::string::npos) return true;
  return !field.path.starts_with("gearset.dynamics.");
}

}  // namespace

ConsistencyMessage unused_field(const CaseShape& shape, std::string_view path) {
  const Field* field = find_field(path);
  if (field != nullptr && is_of_several_sets(*field) && !shape.several)
    return {"a field that a case of one set does not use", "a case without it is required"};
  if (field != nullptr && is_of_defect(*field) && (shape.several || shape.bearing))
    return {"a field that a drivetrain uses where one of its bearings is scratched",
            "defect.race as well, or a case without it, is required"};
  if (shape.several)
    return {"a field that a case of several sets does not use",
            "the shafts, which say where motor and ground are, are required instead"};
  if (shape.teeth)
    return {"a field that a set without a bearing does not use",
            "a case without it, or with a bearing, is required"};
  return {"a field that a set without teeth does not use",
          "a case without it, or with gearset.teeth, is required"};
}

bool belongs(const CaseShape& shape, std::string_view path) {
  if (path.starts_with(shafts_block)) return has_name(shape.shafts, path.substr(shafts_block.size()));
  const std::size_t prefix = set_prefix_length(path);
  const Field* field = find_field(path);
  if (field == nullptr || (is_of_defect(*field) && !shape.defect)) return false;
  if (is_of_several_sets(*field) && !shape.several) return false;
  if (prefix > 0) return has_name(shape.sets, path.substr(sets_block.size(), prefix - 1 - sets_block.size()));
  if (shape.several) return !in_each_set(*field) && !is_of_one_set(*field);
  return (shape.bearing || !is_of_bearing(*field)) && (shape.teeth || !is_of_teeth(*field));
}

std::vector<Input> inputs_of(unsigned models, const CaseShape& shape) {
  std::vector<Input> inputs;
  bool sets_are_in = !shape.several;
  for (const Field& field : all_fields()) {
    if ((field.models & models) == 0) continue;
    // The fields of all sets are listed where the fields of a single set would be.
    if (!sets_are_in && in_each_set(field)) {
      add_sets(models, shape, inputs);
      sets_are_in = true;
    }
    if (belongs(shape, field.path)) inputs.push_back({field.path, &field});
  }
  return inputs;
}

}  // namespace orbearing::app
