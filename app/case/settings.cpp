#include "app/case/settings.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "app/case/case_shape.hpp"
#include "app/case/field_table.hpp"
#include "app/case/text_parts.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

// A field or a block of fields, of which the last key has changed.
struct FormerPath {
  std::string_view former, present;
};

constexpr std::array<FormerPath, 5> kFormerPaths{{
    // Lambda is the ratio of film and roughness where one reads of a bearing's lubrication.
    {"life.lambda", "life.reduction_factor"},
    {"bearing.inner_race.standing_form", "bearing.inner_race.out_of_roundness"},
    {"bearing.outer_race.standing_form", "bearing.outer_race.out_of_roundness"},
    {"bearing.inner_race.turning_form", "bearing.inner_race.waviness"},
    {"bearing.outer_race.turning_form", "bearing.outer_race.waviness"},
}};

// Blocks whose keys are paths of fields.
constexpr std::array<std::string_view, 3> kBlocksOfPaths{"sweep.", "uncertain.", "assumed."};

std::size_t block_length(std::string_view path) {
  for (const std::string_view block : kBlocksOfPaths)
    if (path.starts_with(block)) return block.size();
  return 0;
}

}  // namespace

std::string present_path(const std::string& path) {
  std::size_t begin = block_length(path);
  begin += set_prefix_length(std::string_view(path).substr(begin));
  const std::string_view field = std::string_view(path).substr(begin);
  for (const auto& [former, present] : kFormerPaths) {
    if (!field.starts_with(former)) continue;
    const std::string_view rest = field.substr(former.size());
    if (rest.empty() || rest.front() == '.')
      return path.substr(0, begin) + std::string(present) + std::string(rest);
  }
  return path;
}

void rename_former_keys(Entry& block, const std::string& prefix) {
  if (block.shape != Entry::Shape::block) return;
  for (Member& member : block.members) {
    const std::string present = present_path(prefix + member.key).substr(prefix.size());
    if (present != member.key && find_member(block, present) == nullptr) member.key = present;
    rename_former_keys(member.value, prefix + member.key + ".");
  }
}

std::vector<FormerKey> former_keys() {
  std::vector<FormerKey> keys;
  for (const auto& [former, present] : kFormerPaths)
    keys.push_back({std::string(former), std::string(present)});
  return keys;
}

namespace {

// Keys within a renamed block are not listed again.
void add_former_keys(const Entry& block, const std::string& prefix, std::vector<FormerKey>& found) {
  if (block.shape != Entry::Shape::block) return;
  for (const Member& member : block.members) {
    const std::string path = prefix + member.key, present = present_path(path);
    if (present != path)
      found.push_back({path, present});
    else
      add_former_keys(member.value, path + ".", found);
  }
}

}  // namespace

std::vector<FormerKey> former_keys_in(const Entry& root, const std::vector<std::string>& settings) {
  std::vector<FormerKey> found;
  add_former_keys(root, "", found);
  for (const std::string& setting : settings) {
    const std::string path = trimmed(setting.substr(0, setting.find('='))), present = present_path(path);
    if (present != path) found.push_back({path, present});
  }
  return found;
}

namespace {

void split_into(std::vector<std::string>& keys, std::string_view path) {
  for (std::size_t dot = path.find('.'); dot != std::string_view::npos; dot = path.find('.')) {
    keys.emplace_back(path.substr(0, dot));
    path.remove_prefix(dot + 1);
  }
  keys.emplace_back(path);
}

// Keys of "sweep", "uncertain" and "assumed" are field paths, with dots of their own.
std::vector<std::string> split_paths(const char* block, std::string_view rest) {
  std::vector<std::string> keys{block};
  const Field* longest = nullptr;
  const std::size_t prefix = set_prefix_length(rest);
  const std::string_view inner = rest.substr(prefix);
  for (const Field& field : all_fields())
    if ((inner == field.path || inner.starts_with(field.path + ".")) &&
        (longest == nullptr || field.path.size() > longest->path.size()))
      longest = &field;
  const std::size_t length = longest == nullptr ? rest.size() : prefix + longest->path.size();
  keys.emplace_back(rest.substr(0, length));
  if (length < rest.size()) split_into(keys, rest.substr(length + 1));
  return keys;
}

std::vector<std::string> keys_of(const std::string& path) {
  if (path.starts_with("assumed.")) return {"assumed", path.substr(8)};
  if (path.starts_with("sweep.")) return split_paths("sweep", std::string_view(path).substr(6));
  if (path.starts_with("uncertain.correlations.")) return {"uncertain", "correlations", path.substr(23)};
  if (path.starts_with("uncertain.")) return split_paths("uncertain", std::string_view(path).substr(10));
  std::vector<std::string> keys;
  split_into(keys, path);
  return keys;
}

bool takes_any_text(const std::string& path) {
  const Field* field = find_field(path);
  return path.starts_with("assumed.") || (field != nullptr && field->kind == Kind::text);
}

void move_to(Entry& entry, Location location) {
  entry.location = location;
  for (Entry& item : entry.items) move_to(item, location);
  for (Member& member : entry.members) {
    member.location = location;
    move_to(member.value, location);
  }
}

// A colon or a bracket in a reason is no YAML.
Entry read_value(const std::string& path, const std::string& text) {
  if (!takes_any_text(path)) return read_yaml(text);
  const bool is_text =
      first_byte_not_utf8(text) == text.size() && first_control_character(text) == text.size();
  if (!is_text) return read_yaml(text);                                      // which reports it
  if (text.find('\n') != std::string::npos) return make_scalar(text, true);  // lines of a table stay apart
  try {
    Entry entry = read_yaml(text);
    if (entry.shape == Entry::Shape::scalar || entry.shape == Entry::Shape::nothing) return entry;
  } catch (const YamlFault&) {
  }
  return make_scalar(text, true);
}

void put(Entry& root, const std::vector<std::string>& keys, Entry value) {
  Entry* block = &root;
  for (const std::string& key : keys) {
    if (block->shape != Entry::Shape::block) *block = make_entry(Entry::Shape::block, value.location);
    Member* member = find_member(*block, key);
    if (member == nullptr) member = &block->members.emplace_back(Member{key, value.location, {}});
    block = &member->value;
  }
  *block = std::move(value);
}

// Whether the key was there.
bool remove(Entry& block, const std::vector<std::string>& keys, std::size_t from = 0) {
  if (block.shape != Entry::Shape::block) return false;
  if (from + 1 < keys.size()) {
    Member* member = find_member(block, keys[from]);
    return member != nullptr && remove(member->value, keys, from + 1);
  }
  return std::erase_if(block.members, [&](const Member& member) { return member.key == keys[from]; }) > 0;
}

// A value that is left out has no reason: its default has its own.
void remove_reasons(Entry& root, const std::string& path) {
  if (Member* assumed = find_member(root, "assumed"); assumed != nullptr)
    std::erase_if(assumed->value.members, [&](const Member& member) {
      return member.key == path || member.key.starts_with(path + ".");
    });
}

// A field, or a block of fields.
bool may_stand(const std::string& path) {
  if (block_length(path) > 0 || is_one_of(path, {"sweep", "uncertain", "assumed", "sets", "shafts"}))
    return true;
  const std::string_view field = std::string_view(path).substr(set_prefix_length(path));
  return find_field(path) != nullptr || path.starts_with("sets.") ||
         std::ranges::any_of(all_fields(), [&](const Field& one) {
           return one.path.starts_with(field) && one.path.size() > field.size() &&
                  one.path[field.size()] == '.';
         });
}

bool is_null(std::string_view text) {
  const std::string word = trimmed(std::string(text));
  return word == "null" || word == "~";
}

void apply(Entry& root, const std::string& setting, Location location, std::vector<Mistake>& mistakes) {
  const auto sign = setting.find('=');
  const std::string path = present_path(trimmed(setting.substr(0, sign)));
  const std::vector<std::string> keys = keys_of(path);
  const bool gap = std::find(keys.begin(), keys.end(), "") != keys.end();
  if (sign == std::string::npos || gap) {
    mistakes.push_back({location,
                        path.empty() ? "(option)" : path,
                        {quote(setting) + (gap ? " has no complete path" : " has no '='"),
                         "path=value, as in 'input.power=150 kW', is required"}});
    return;
  }
  if (is_null(std::string_view(setting).substr(sign + 1))) {
    if (!remove(root, keys) && !may_stand(path))
      mistakes.push_back(
          {location, path, {"unknown key", "the path of an input, to be left out, is required"}});
    remove_reasons(root, path);
    return;
  }
  try {
    Entry value = read_value(path, setting.substr(sign + 1));
    move_to(value, location);
    put(root, keys, std::move(value));
  } catch (const YamlFault& fault) {
    mistakes.push_back({location, path, fault.message});
  }
}

}  // namespace

void apply_settings(Entry& root, const std::vector<std::string>& settings, std::vector<Mistake>& mistakes) {
  int number = 0;
  for (const std::string& setting : settings) apply(root, setting, {true, ++number, 1}, mistakes);
}

FieldReading read_field_text(const Field& field, const std::string& text) {
  if (field.kind != Kind::list) return read_field(field, make_scalar(text));
  try {
    return read_field(field, read_yaml(text));
  } catch (const YamlFault& fault) {
    return {false, {}, fault.message};
  }
}

}  // namespace orbearing::app
