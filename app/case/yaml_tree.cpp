#include "app/case/yaml_tree.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

constexpr std::size_t deepest = 16;  // levels; the fields need four

// Locations of bytes, with columns in characters (yaml-cpp counts bytes). For requests in rising order it
// reads the text once.
class LocationFinder {
 public:
  explicit LocationFinder(std::string_view text) : text_(text) {}

  Location operator()(std::size_t position) {
    if (position < reached_) *this = LocationFinder(text_);
    for (; reached_ < std::min(position, text_.size()); ++reached_) pass(text_[reached_]);
    return location_;
  }

 private:
  void pass(char c) {
    if (c == '\n') {
      ++location_.line;
      location_.column = 1;
    } else if ((static_cast<unsigned char>(c) & 0xC0) != 0x80) {
      ++location_.column;
    }
  }

  std::string_view text_;
  std::size_t reached_ = 0;
  Location location_;
};

Location location_at(std::string_view text, std::size_t position) {
  return LocationFinder(text)(position);
}

[[noreturn]] void refuse(Location location, std::string found, std::string required) {
  throw YamlFault{location, {std::move(found), std::move(required)}};
}

// The first tab in the indentation of a line: YAML allows none, and its parser does not report it.
std::optional<std::size_t> tab_of_indentation(std::string_view text) {
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t first = std::min(text.find_first_not_of(" \t", begin), text.size());
    const std::size_t tab = text.find('\t', begin);
    if (tab < first && first < text.size() && text[first] != '#' && text[first] != '\n' &&
        text[first] != '\r')
      return tab;
    begin = text.find('\n', begin);
    if (begin == std::string_view::npos) break;
    ++begin;
  }
  return std::nullopt;
}

// yaml-cpp lets the end of the file close a quotation.
bool is_closed(std::string_view text, std::size_t start) {
  const char mark = text[start];
  for (std::size_t i = start + 1; i < text.size(); ++i) {
    if (mark == '"' && text[i] == '\\') {
      ++i;
    } else if (text[i] == mark) {
      if (mark == '"' || i + 1 >= text.size() || text[i + 1] != mark) return true;
      ++i;
    }
  }
  return false;
}

class TreeBuilder : public YAML::EventHandler {
 public:
  explicit TreeBuilder(std::string_view text) : text_(text), location_of_(text) {}

  Entry take_root() { return std::move(root_); }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    refuse_anchor(mark, anchor);
    // The mark of a missing value lies on what comes next.
    add(make_entry(Entry::Shape::nothing, expects_value() ? open_.back().key_location : location(mark)));
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override { refuse_anchor(mark, 1); }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    refuse_anchor(mark, anchor);
    refuse_tag(mark, tag);
    const bool quoted = tag == "!";
    // Escapes in double quotes ("\e[31m") make characters that the file itself does not hold.
    if (first_byte_not_utf8(value) < value.size() || first_control_character(value) < value.size())
      refuse(location(mark), "an escape that makes a control character", "a text without it is required");
    const char opening = at(mark) < text_.size() ? text_[at(mark)] : ' ';
    if (quoted && (opening == '"' || opening == '\'') && !is_closed(text_, at(mark)))
      refuse(location(mark), "a quotation that does not end",
             "a closing " + std::string(1, opening) + " is required");
    if (expects_key()) {
      open_.back().key = value;
      open_.back().key_location = location(mark);
      open_.back().has_key = true;
    } else {
      add(make_scalar(value, quoted, location(mark)));
    }
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, Entry::Shape::list);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, Entry::Shape::block);
  }
  void OnMapEnd() override { close(); }

 private:
  struct Open {
    Entry entry;
    std::string key{};
    Location key_location{};
    bool has_key = false;
  };

  std::size_t at(const YAML::Mark& mark) const { return static_cast<std::size_t>(std::max(mark.pos, 0)); }
  Location location(const YAML::Mark& mark) { return location_of_(at(mark)); }
  bool in_block() const { return !open_.empty() && open_.back().entry.shape == Entry::Shape::block; }
  bool expects_key() const { return in_block() && !open_.back().has_key; }
  bool expects_value() const { return in_block() && open_.back().has_key; }

  void refuse_anchor(const YAML::Mark& mark, YAML::anchor_t anchor) {
    if (anchor != 0)
      refuse(location(mark), "an anchor or alias (& or *)", "the value written out is required");
  }
  void refuse_tag(const YAML::Mark& mark, const std::string& tag) {
    if (!tag.empty() && tag != "?" && tag != "!")
      refuse(location(mark), "the YAML tag " + quote(tag), "a value without a tag is required");
  }

  void open(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, Entry::Shape shape) {
    refuse_anchor(mark, anchor);
    refuse_tag(mark, tag);
    if (expects_key())
      refuse(location(mark), "an open bracket or a key that is no plain text",
             "closed brackets and plain keys are required");
    if (open_.size() >= deepest)
      refuse(location(mark), "nesting of more than 16 levels", "the blocks of a case are required");
    open_.push_back({.entry = make_entry(shape, location(mark))});
  }

  void close() {
    Entry done = std::move(open_.back().entry);
    open_.pop_back();
    add(std::move(done));
  }

  void add(Entry entry) {
    if (open_.empty()) {
      root_ = std::move(entry);
      return;
    }
    Open& parent = open_.back();
    if (parent.entry.shape == Entry::Shape::list) {
      parent.entry.items.push_back(std::move(entry));
    } else if (parent.has_key) {
      parent.entry.members.push_back({std::move(parent.key), parent.key_location, std::move(entry)});
      parent.has_key = false;
    } else {
      refuse(entry.location, "an empty key", "a plain key is required");
    }
  }

  std::string_view text_;
  LocationFinder location_of_;
  std::vector<Open> open_;
  Entry root_;
};

Entry parse(std::string_view text) {
  std::istringstream stream{std::string(text)};
  YAML::Parser parser(stream);
  TreeBuilder builder(text);
  if (!parser.HandleNextDocument(builder)) return {};
  Entry root = builder.take_root();
  TreeBuilder rest(text);
  if (parser.HandleNextDocument(rest))
    refuse(rest.take_root().location, "a second YAML document", "one document is required");
  return root;
}

// yaml-cpp stops in silence at some control characters and repairs broken UTF-8: both would lose input.
void check_text(std::string_view text) {
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
    refuse({}, "a file in UTF-16", "a text file in UTF-8 is required: save it as UTF-8");
  if (const std::size_t byte = first_byte_not_utf8(text); byte < text.size())
    refuse(location_at(text, byte), "a byte that is not UTF-8", "a text file in UTF-8 is required");
  if (const std::size_t control = first_control_character(text); control < text.size())
    refuse(location_at(text, control), "a control character", "a text file in UTF-8 is required");
}

}  // namespace

Entry read_yaml(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  check_text(text);
  try {
    return parse(text);
  } catch (const YAML::Exception& error) {
    if (const std::optional<std::size_t> tab = tab_of_indentation(text))
      refuse(location_at(text, *tab), "a tab in the indentation of a line",
             "blanks instead of tabs are required");
    const auto position = static_cast<std::size_t>(std::max(error.mark.pos, 0));
    refuse(location_at(text, std::min(position, text.size())), "wrong YAML (" + error.msg + ")",
           "keys and values as 'key: value', indented by blanks, are required");
  }
}

Entry make_entry(Entry::Shape shape, Location location) {
  return {.shape = shape, .location = location};
}

Entry make_scalar(std::string text, bool quoted, Location location) {
  return {.shape = Entry::Shape::scalar, .text = std::move(text), .quoted = quoted, .location = location};
}

const Member* find_member(const Entry& block, std::string_view key) {
  const auto found = std::find_if(block.members.begin(), block.members.end(),
                                  [&](const Member& member) { return member.key == key; });
  return found == block.members.end() ? nullptr : &*found;
}

Member* find_member(Entry& block, std::string_view key) {
  return const_cast<Member*>(find_member(static_cast<const Entry&>(block), key));
}

// JSON's strings are YAML's double-quoted ones.
std::string quoted_scalar(const std::string& text) {
  return nlohmann::json(text).dump();
}

std::string describe(const Entry& entry) {
  switch (entry.shape) {
    case Entry::Shape::scalar:
      return entry.quoted && entry.text.empty() ? "an empty text" : quote(entry.text);
    case Entry::Shape::list:
      return "a list";
    case Entry::Shape::block:
      return "a block";
    case Entry::Shape::nothing:
      break;
  }
  return "nothing";
}

}  // namespace orbearing::app
