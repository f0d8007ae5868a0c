// A case file as a tree that remembers where everything was written.
//
// Built from yaml-cpp's events rather than its nodes: events still show duplicate keys, places and quotes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/case/mistake.hpp"

namespace orbearing::app {

struct Member;

struct Entry {
  enum class Shape { nothing, scalar, list, block };

  Shape shape = Shape::nothing;
  std::string text;     // scalar
  bool quoted = false;  // scalar: written in quotes, hence a text
  Location location;
  std::vector<Entry> items;     // list
  std::vector<Member> members;  // block, in the order written, duplicates included
};

struct Member {
  std::string key;
  Location location;  // of the key
  Entry value;
};

/// Reads YAML. Throws `YamlFault` for wrong syntax, aliases, tags, several documents, too deep nesting, or
/// text that is not UTF-8.
Entry read_yaml(std::string_view text);

/// Wrong syntax, at a place.
struct YamlFault {
  Location location;
  ConsistencyMessage message;
};

/// An entry without content yet, and one that holds a text.
Entry make_entry(Entry::Shape shape, Location location);
Entry make_scalar(std::string text, bool quoted = false, Location location = {});

/// First member of that key, or null.
const Member* find_member(const Entry& block, std::string_view key);
Member* find_member(Entry& block, std::string_view key);

/// A text as YAML writes it in double quotes.
std::string quoted_scalar(const std::string& text);

/// Description of an entry for messages: "'3 mm'", "a block", "a list", "nothing".
std::string describe(const Entry& entry);

}  // namespace orbearing::app
