// --set path=value: overlays a case before it is checked.
#pragma once

#include <compare>
#include <optional>
#include <string>
#include <vector>

#include "app/case/field.hpp"
#include "app/case/yaml_tree.hpp"

namespace orbearing::app {

// Renamed keys: a former name is read as the present one, with a warning, until the next major version.

struct FormerKey {
  std::string former, present;  // paths
};

/// All renamed keys: a field, or a block of fields.
std::vector<FormerKey> former_keys();

/// Those that a case file or its settings use, by the paths that are written there.
std::vector<FormerKey> former_keys_in(const Entry& root, const std::vector<std::string>& settings);

/// The same path with present names; behind "sweep.", "uncertain." and "assumed.", and in one of several
/// sets, too.
std::string present_path(const std::string& path);

/// Gives all keys of a case file their present names. Where a file has both names, the former one remains and
/// is an unknown key.
void rename_former_keys(Entry& block, const std::string& prefix = "");

/// Replacement of one independent value.
struct Setting {
  std::string path;                // of a list of numbers also "PATH[i]", its element i, counted from 0
  std::string text;                // as in a case; empty: the number is used
  std::optional<double> number{};  // [SI] where the text has been read or there is none

  auto operator<=>(const Setting&) const = default;
};

/// Puts every setting into the tree as if the file contained it; malformed ones become mistakes. A block or
/// list is replaced as a whole; of two settings of one path the later holds. The value null leaves the key
/// out.
void apply_settings(Entry& root, const std::vector<std::string>& settings, std::vector<Mistake>& mistakes);

/// A value of a field from text as it would be written in a case.
FieldReading read_field_text(const Field& field, const std::string& text);

}  // namespace orbearing::app
