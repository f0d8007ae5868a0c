#include "app/case/case_resolver.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "app/case/field_table.hpp"
#include "app/case/settings.hpp"
#include "app/case/sweep_axes.hpp"

namespace orbearing::app {

namespace {

class Resolver {
 public:
  Resolver(const Entry& root, const std::string& file, std::vector<Mistake>& mistakes)
      : root_(root), mistakes_(mistakes) {
    data_.file = file;
  }

  CaseData resolve() {
    find_model();
    read_block(root_, "");
    report_missing();
    fill_defaults();
    read_assumed();
    read_sweep();
    return std::move(data_);
  }

 private:
  void object(Place place, const std::string& path, std::string found, std::string required) {
    mistakes_.push_back({place, path, {std::move(found), std::move(required)}});
    faulty_.insert(path);
  }

  // Without a good model, every field of any model is let pass and none is missed.
  void find_model() {
    const Member* member = find_member(root_, "model");
    if (member == nullptr || member->value.shape != Entry::Shape::scalar) return;
    model_ = model_of(member->value.text);
    if (model_ != no_model) allowed_ = model_;
  }

  void read_block(const Entry& block, const std::string& prefix) {
    std::map<std::string, int> first_line;
    for (const Member& member : block.members) {
      const std::string path = prefix + member.key;
      const auto [first, fresh] = first_line.emplace(member.key, member.place.line);
      if (!fresh)
        object(member.place, path,
               member.place.option ? "duplicate key"
                                   : fmt::format("duplicate key, first on line {}", first->second),
               "each key once is required");
      else if (prefix.empty() && (member.key == "sweep" || member.key == "assumed"))
        require_block(member, path, "field paths");
      else
        read_member(member, path, prefix);
    }
  }

  void read_member(const Member& member, const std::string& path, const std::string& prefix) {
    const Field* field = find_field(path);
    const bool dotted = member.key.find('.') != std::string::npos;
    if (field != nullptr && !dotted) {
      read_value(member, *field);
    } else if (!dotted && !children(path + ".").empty()) {
      block_places_[path] = member.place;
      if (require_block(member, path, fmt::format("{}", fmt::join(children(path + "."), ", "))))
        read_block(member.value, path + ".");
    } else {
      object(member.place, path, "unknown key", key_hint(member.key, prefix));
    }
  }

  bool require_block(const Member& member, const std::string& path, const std::string& keys) {
    if (member.value.shape == Entry::Shape::block) return true;
    object(member.value.place, path, describe(member.value) + " found",
           "a block with keys (" + keys + ") is required");
    return false;
  }

  void read_value(const Member& member, const Field& field) {
    if ((field.models & allowed_) == 0) {
      object(member.place, field.path, fmt::format("a field that {} does not use", model_name(model_)),
             "a case without it is required");
      return;
    }
    if (refuse_planned_model(member, field)) return;
    FieldReading reading = read_field(field, member.value);
    if (!reading.good) {
      object(member.value.place, field.path, reading.complaint.found, reading.complaint.required);
      return;
    }
    data_.values[field.path] = {std::move(reading.value), member.value.place, false};
  }

  bool refuse_planned_model(const Member& member, const Field& field) {
    const std::vector<std::string>& planned = planned_models();
    if (field.path != "model" ||
        std::find(planned.begin(), planned.end(), member.value.text) == planned.end())
      return false;
    object(member.value.place, "model", quote(member.value.text) + " is not in this version",
           requirement(field) + " is required");
    return true;
  }

  // Names that may follow a prefix ("gearset.teeth."), in table order.
  std::vector<std::string> children(const std::string& prefix) const {
    std::vector<std::string> names;
    for (const Field& field : all_fields()) {
      if (!field.path.starts_with(prefix)) continue;
      const std::string rest = field.path.substr(prefix.size());
      std::string name = rest.substr(0, rest.find('.'));
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
    }
    if (prefix.empty()) names.insert(names.end(), {"sweep", "assumed"});
    return names;
  }

  std::string key_hint(const std::string& key, const std::string& prefix) const {
    // The right name in the wrong block is likelier than a slip of the keyboard.
    for (const Field& field : all_fields())
      if (field.path == key || field.path.ends_with("." + key))
        return fmt::format("a known key is required; '{}' nested by its blocks is one", field.path);
    const std::vector<std::string> siblings = children(prefix);
    const std::string near = nearest_word(key, siblings);
    if (!near.empty()) return fmt::format("a known key is required; did you mean '{}{}'?", prefix, near);
    return fmt::format("one of {} is required", fmt::join(siblings, ", "));
  }

  bool is_faulty(std::string path) const {
    while (!faulty_.contains(path)) {
      const auto dot = path.rfind('.');
      if (dot == std::string::npos) return false;
      path.resize(dot);
    }
    return true;
  }

  Place nearest_block(std::string path) const {
    for (auto dot = path.rfind('.'); dot != std::string::npos; dot = path.rfind('.')) {
      path.resize(dot);
      if (const auto found = block_places_.find(path); found != block_places_.end()) return found->second;
    }
    return {};
  }

  void report_missing() {
    for (const Field& field : all_fields()) {
      const bool needed =
          model_ == no_model ? field.path.find('.') == std::string::npos : (field.required_by & model_) != 0;
      if (needed && !data_.values.contains(field.path) && !is_faulty(field.path))
        object(nearest_block(field.path), field.path, "missing", requirement(field) + " is required");
    }
  }

  void fill_defaults() {
    for (const Field* field : fields_of(model_)) {
      if (field->default_text.empty() || data_.values.contains(field->path) || is_faulty(field->path))
        continue;
      data_.values[field->path] = {read_field_text(*field, field->default_text).value, {}, true};
      data_.assumed[field->path] = "default: " + field->default_reason;
    }
  }

  void read_assumed() {
    const Member* assumed = find_member(root_, "assumed");
    if (assumed == nullptr) return;
    std::set<std::string> seen;
    for (const Member& member : assumed->value.members) {
      if (seen.insert(member.key).second)
        read_reason(member);
      else
        object(member.place, "assumed." + member.key, "duplicate key", "each key once is required");
    }
  }

  void read_reason(const Member& member) {
    const std::string path = "assumed." + member.key;
    const Entry& reason = member.value;
    const auto value = data_.values.find(member.key);
    if (value == data_.values.end()) {
      if (!is_faulty(member.key))
        object(member.place, path, unknown_assumption(member.key), assumption_hint(member.key));
      return;
    }
    if (reason.shape != Entry::Shape::scalar ||
        reason.text.find_first_not_of(" \t\r\n") == std::string::npos) {
      object(reason.place, path, describe(reason) + " found",
             "the reason for the value, as a text, is required");
      return;
    }
    // A value put in its place by an option is no longer the one that the file gives reasons for.
    if (value->second.place.option && !reason.place.option) return;
    data_.assumed[member.key] = reason.text;
  }

  static std::string unknown_assumption(const std::string& key) {
    return find_field(key) == nullptr ? "unknown path" : "a reason for a value that is not there";
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
    if (sweep != nullptr && sweep->value.shape == Entry::Shape::block)
      data_.axes =
          std::make_shared<const std::vector<SweepAxis>>(read_axes(sweep->value, allowed_, mistakes_));
  }

  const Entry& root_;
  std::vector<Mistake>& mistakes_;
  CaseData data_;
  Model model_ = no_model;
  unsigned allowed_ = every_model;
  std::set<std::string> faulty_;
  std::map<std::string, Place> block_places_;
};

}  // namespace

CaseData resolve(const Entry& root, const std::string& file, std::vector<Mistake>& mistakes) {
  return Resolver(root, file, mistakes).resolve();
}

}  // namespace orbearing::app
