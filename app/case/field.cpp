#include "app/case/field.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>

#include "app/case/input_keys.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

FieldReading good(FieldValue value) {
  return {true, std::move(value), {}};
}

// Advice for a value of the source that the field cannot hold.
std::string remedy(const Field& field) {
  if (field.path.starts_with("parallel_stage."))
    return "; one stage is [82, 23], several are [[82, 23], [88, 22]]";
  if (field.path == keys().oil_viscosity_index)
    return "; an oil of a higher index states lubricant.viscosity_100 of its data sheet instead";
  if (field.path == "spectrum" && field.kind == Kind::number)
    return "; shares are fractions that add up to 1: 0.25 is 25 %";
  if (field.path == "pair.teeth") return "; of a gear inside a ring, state pair.kind: internal";
  return {};
}

FieldReading bad(std::string found, const Field& field) {
  return {false, {}, {std::move(found), requirement(field) + " is required" + remedy(field)}};
}

std::string with_unit(double value, const Field& field) {
  if (field.dimension.customary.empty()) return fmt::format("{}", value);
  return fmt::format("{} {}", value, field.dimension.customary);
}

// Converts a bound as a case would convert the same text, so that a value written like the bound equals it.
double bound_in_si(double bound, const Field& field) {
  if (field.dimension.si.empty() || bound == 0.0 || std::isinf(bound)) return bound;
  const Reading<double> reading = convert(bound, field.dimension.customary, field.dimension.si);
  assert(reading.value);
  return *reading.value;
}

bool in_range(double value, const Field& field) {
  const double least = bound_in_si(field.range.least, field);
  const double most = bound_in_si(field.range.most, field);
  const bool above = field.range.least_allowed ? value >= least : value > least;
  const bool below = field.range.most_allowed ? value <= most : value < most;
  return above && below;
}

std::string range_text(const Field& field) {
  const Range& range = field.range;
  std::vector<std::string> bounds;
  if (range.least > -std::numeric_limits<double>::infinity())
    bounds.push_back((range.least_allowed ? "at least " : "greater than ") + with_unit(range.least, field));
  if (range.most < std::numeric_limits<double>::infinity())
    bounds.push_back((range.most_allowed ? "at most " : "less than ") + with_unit(range.most, field));
  return fmt::format("{}", fmt::join(bounds, " and "));
}

FieldReading check_range(FieldValue value, const Field& field, const Entry& entry) {
  if (!in_range(value.number, field)) return bad(describe(entry) + " is out of range", field);
  return good(std::move(value));
}

FieldReading read_integer(const Field& field, const Entry& entry) {
  const std::string& text = entry.text;
  int value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  const std::size_t first_digit = text.starts_with('-') ? 1 : 0;
  const bool octal_look = text.size() > first_digit + 1 && text[first_digit] == '0';
  if (end != last || error == std::errc::invalid_argument || octal_look)
    return bad(describe(entry) + " is not a whole number", field);
  if (error != std::errc{}) return bad(describe(entry) + " is out of range", field);
  return check_range({text, static_cast<double>(value), {}}, field, entry);
}

FieldReading read_real(const Field& field, const Entry& entry) {
  const bool dimensional = field.kind == Kind::quantity;
  const Reading<double> reading =
      dimensional ? read_quantity(entry.text, field.dimension) : read_number(entry.text);
  if (!reading.value) return bad(fmt::format("{}: {}", describe(entry), reading.fault), field);
  return check_range({entry.text, *reading.value, {}}, field, entry);
}

FieldReading read_flag(const Field& field, const Entry& entry) {
  if (entry.text != "true" && entry.text != "false") return bad(describe(entry) + " is not a switch", field);
  return good({entry.text, entry.text == "true" ? 1.0 : 0.0, {}});
}

// Letters and digits alone, all large.
std::string bare(const std::string& text) {
  std::string letters;
  for (const unsigned char c : text)
    if (std::isalnum(c) != 0) letters += static_cast<char>(std::toupper(c));
  return letters;
}

// The choice that `text` is but for spaces, hyphens and size of letters, or else the longest one that it
// begins or ends with, or that ends with it: "VG 220" of "ISO VG 220", "17/15/12" of "-/15/12"; empty where
// there is none.
std::string likely_choice(const Field& field, const std::string& text) {
  const std::string given = bare(text);
  std::string likely;
  for (const std::string& choice : field.choices) {
    const std::string known = bare(choice);
    if (known == given) return choice;
    constexpr std::size_t least_letters = 4;  // of an end that is no accident
    const bool same_end = std::min(given.size(), known.size()) >= least_letters &&
                          (given.ends_with(known) || known.ends_with(given));
    if ((given.starts_with(known) || same_end) && known.size() > bare(likely).size()) likely = choice;
  }
  return likely;
}

// A text as letters and the number behind them: "ISO VG 320" is ISOVG and 320.
std::optional<std::pair<std::string, double>> numbered(const std::string& text) {
  const std::string letters = bare(text);
  const std::size_t digit = letters.find_first_of("0123456789");
  if (digit == std::string::npos) return std::nullopt;
  const Reading<double> number = read_number(letters.substr(digit));
  if (!number.value || *number.value <= 0.0) return std::nullopt;
  return std::pair{letters.substr(0, digit), *number.value};
}

// Among choices that differ only by a number, such as grades of oil, the one whose number is nearest in
// ratio; choices without a number are skipped. Empty where there is none.
std::string nearest_number(const Field& field, const std::string& text) {
  const auto given = numbered(text);
  const auto is_alike = [&](const std::string& choice) {
    const auto known = numbered(choice);
    return known && given && known->first == given->first && !given->first.empty();
  };
  const auto is_another = [&](const std::string& choice) { return numbered(choice) && !is_alike(choice); };
  constexpr std::size_t least_letters = 4;  // of a name that numbers follow beside other choices
  const bool all = std::all_of(field.choices.begin(), field.choices.end(), is_alike);
  if (!given || (!all && given->first.size() < least_letters) ||
      std::any_of(field.choices.begin(), field.choices.end(), is_another))
    return "";
  std::string nearest;
  double least = std::log(2.0);
  for (const std::string& choice : field.choices) {
    const auto known = numbered(choice);
    if (!known) continue;
    const double distance = std::abs(std::log(given->second / known->second));
    if (distance >= least) continue;
    least = distance;
    nearest = choice;
  }
  return nearest;
}

FieldReading read_choice(const Field& field, const Entry& entry) {
  if (std::find(field.choices.begin(), field.choices.end(), entry.text) == field.choices.end()) {
    std::string likely = likely_choice(field, entry.text);
    if (bare(likely) != bare(entry.text))
      if (const std::string nearest = nearest_number(field, entry.text); !nearest.empty()) likely = nearest;
    return bad(describe(entry) + " is none of the choices" +
                   (likely.empty() ? "" : fmt::format(" (did you mean '{}'?)", likely)),
               field);
  }
  return good({entry.text, 0.0, {}});
}

FieldReading read_text(const Field& field, const Entry& entry) {
  if (entry.text.find_first_not_of(" \t\r\n") == std::string::npos) return bad("an empty text", field);
  return good({entry.text, 0.0, {}});
}

FieldReading read_scalar(const Field& field, const Entry& entry) {
  switch (field.kind) {
    case Kind::integer:
      return read_integer(field, entry);
    case Kind::quantity:
    case Kind::number:
      return read_real(field, entry);
    case Kind::flag:
      return read_flag(field, entry);
    case Kind::choice:
      return read_choice(field, entry);
    case Kind::text:
      return read_text(field, entry);
    case Kind::list:
      break;
  }
  return bad(describe(entry) + " is not a list", field);
}

// One quantity, or text, of a row.
Field field_of_column(const Field& field, const ListColumn& column) {
  Field one = field;
  one.kind = column.text ? Kind::text : column.dimension.si.empty() ? Kind::number : Kind::quantity;
  one.dimension = column.dimension;
  one.range = column.range;
  one.columns.clear();
  return one;
}

FieldReading at(const Entry& entry, FieldReading reading) {
  if (!reading.good && !reading.location) reading.location = entry.location;
  return reading;
}

FieldReading read_cell(const Field& field, const ListColumn& column, const Entry& entry) {
  const Field one = field_of_column(field, column);
  Entry cell = entry;
  const bool plain = entry.shape == Entry::Shape::scalar && !entry.quoted && read_number(entry.text).value;
  if (plain && !column.unit_of_number.empty()) cell.text += " " + std::string(column.unit_of_number);
  FieldReading reading = at(entry, read_field(one, cell));
  if (!reading.good) reading.message.found = column_key(column) + ": " + reading.message.found;
  return reading;
}

FieldReading bad_row(const Entry& entry, std::string found, const Field& field) {
  return at(entry, bad(std::move(found), field));
}

FieldReading read_listed_row(const Field& field, const Entry& entry) {
  if (has_choices(field) || entry.shape != Entry::Shape::list || entry.items.size() != field.columns.size())
    return bad_row(entry, describe(entry) + " as a row", field);
  FieldValue value;
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < field.columns.size(); ++i) {
    FieldReading reading = read_cell(field, field.columns[i], entry.items[i]);
    if (!reading.good) return reading;
    texts.push_back(reading.value.given);
    value.list.push_back(reading.value.number);
  }
  value.given = fmt::format("[{}]", fmt::join(texts, ", "));
  return good(std::move(value));
}

// "power or torque"
std::string keys_of_group(const Field& field, int group) {
  std::vector<std::string> keys;
  for (const ListColumn& column : field.columns)
    if (column.one_of == group) keys.push_back(column_key(column));
  return fmt::format("{}", fmt::join(keys, " or "));
}

// The first key that no column has, or that is listed twice; nothing where all is well.
std::optional<FieldReading> wrong_key(const Field& field, const Entry& row) {
  for (std::size_t i = 0; i < row.members.size(); ++i) {
    const std::string& key = row.members[i].key;
    const Entry at_key = make_entry(Entry::Shape::nothing, row.members[i].location);
    if (std::none_of(field.columns.begin(), field.columns.end(),
                     [&](const ListColumn& column) { return column_key(column) == key; }))
      return bad_row(at_key, "the unknown key '" + key + "'", field);
    for (std::size_t j = 0; j < i; ++j)
      if (row.members[j].key == key) return bad_row(at_key, "the key '" + key + "' twice", field);
  }
  return std::nullopt;
}

// Mistake in columns of which a row must have exactly one: none or several were given; nothing where all is
// well.
std::optional<FieldReading> wrong_choice(const Field& field, const Entry& row) {
  for (const ListColumn& column : field.columns) {
    if (column.one_of == 0) continue;
    int found = 0;
    for (const ListColumn& other : field.columns)
      if (other.one_of == column.one_of && find_member(row, column_key(other)) != nullptr) ++found;
    if (found != 1)
      return bad_row(row,
                     fmt::format("a row with {} {}", found == 0 ? "no" : "more than one",
                                 keys_of_group(field, column.one_of)),
                     field);
  }
  return std::nullopt;
}

FieldReading read_named_row(const Field& field, const Entry& entry) {
  if (auto wrong = wrong_key(field, entry)) return *wrong;
  if (auto wrong = wrong_choice(field, entry)) return *wrong;
  FieldValue value;
  std::vector<std::string> texts;
  for (const ListColumn& column : field.columns) {
    const Member* member = find_member(entry, column_key(column));
    if (member == nullptr && (column.one_of > 0 || column.optional)) {
      value.list.push_back(0.0);
      continue;
    }
    if (member == nullptr) return bad_row(entry, "a row without '" + column_key(column) + "'", field);
    FieldReading reading = read_cell(field, column, member->value);
    if (!reading.good) return reading;
    const std::string& given = reading.value.given;
    texts.push_back(column_key(column) + ": " + (column.text ? quoted_scalar(given) : given));
    if (column.text) value.texts.push_back(given);
    value.list.push_back(column.text ? static_cast<double>(value.texts.size()) : reading.value.number);
  }
  value.given = fmt::format("{{{}}}", fmt::join(texts, ", "));
  return good(std::move(value));
}

FieldReading read_row(const Field& field, const Entry& entry) {
  return entry.shape == Entry::Shape::block ? read_named_row(field, entry) : read_listed_row(field, entry);
}

// Texts of a row get the numbers that they have among those of all rows.
void number_texts(const Field& field, FieldValue& row, std::vector<std::string>& texts) {
  for (std::size_t i = 0; i < field.columns.size(); ++i) {
    if (!field.columns[i].text || row.list[i] == 0.0) continue;
    const std::string text = text_numbered(row.texts, row.list[i]);
    const auto known = std::find(texts.begin(), texts.end(), text);
    row.list[i] = static_cast<double>(known - texts.begin() + 1);
    if (known == texts.end()) texts.push_back(text);
  }
}

FieldReading read_rows(const Field& field, const Entry& entry) {
  if (entry.shape != Entry::Shape::list || entry.items.empty()) return bad(describe(entry) + " found", field);
  FieldValue value;
  std::vector<std::string> texts;
  for (const Entry& item : entry.items) {
    FieldReading reading = read_row(field, item);
    if (!reading.good) return reading;
    number_texts(field, reading.value, value.texts);
    texts.push_back(reading.value.given);
    value.list.insert(value.list.end(), reading.value.list.begin(), reading.value.list.end());
  }
  value.given = fmt::format("[{}]", fmt::join(texts, ", "));
  return good(std::move(value));
}

FieldReading read_list(const Field& field, const Entry& entry);

// Each group is a list; a single one is written like a list without groups.
FieldReading read_groups(const Field& field, const Entry& entry) {
  FieldValue value;
  std::vector<std::string> texts;
  for (const Entry& item : entry.items) {
    if (item.shape != Entry::Shape::list) return at(item, bad(describe(item) + " beside lists", field));
    Field one = field;
    one.group = 0;
    FieldReading reading = read_list(one, item);
    if (!reading.good) return at(item, std::move(reading));
    if (reading.value.list.size() != field.group)
      return at(item, bad(fmt::format("a list of {} among lists", reading.value.list.size()), field));
    texts.push_back(reading.value.given);
    value.list.insert(value.list.end(), reading.value.list.begin(), reading.value.list.end());
  }
  value.given = texts.size() == 1 ? texts.front() : fmt::format("[{}]", fmt::join(texts, ", "));
  return good(std::move(value));
}

FieldReading read_list(const Field& field, const Entry& entry) {
  if (!field.columns.empty()) return read_rows(field, entry);
  if (entry.shape != Entry::Shape::list || entry.items.empty()) return bad(describe(entry) + " found", field);
  if (field.group > 0 && entry.items.front().shape == Entry::Shape::list) return read_groups(field, entry);
  Field element = field;
  element.kind = field.element;
  FieldValue value;
  std::vector<std::string> texts;
  for (const Entry& item : entry.items) {
    FieldReading reading = read_field(element, item);
    if (!reading.good) return reading;
    texts.push_back(reading.value.given);
    if (element.kind == Kind::text)
      value.texts.push_back(reading.value.given);
    else
      value.list.push_back(reading.value.number);
  }
  if (field.group > 0 && texts.size() != field.group)
    return bad(fmt::format("a list of {}", texts.size()), field);
  value.given = fmt::format("[{}]", fmt::join(texts, ", "));
  return good(std::move(value));
}

// "[load, speed] like [[3 N, 2 m/s]]"; of columns of which a row has one, "{power or torque, speed}".
std::string rows_text(const Field& field) {
  std::vector<std::string> names, examples;
  const bool blocks = has_choices(field);
  for (const ListColumn& column : field.columns) {
    if (column.optional) continue;
    const std::string name = column.one_of > 0 ? keys_of_group(field, column.one_of) : column.name;
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    names.push_back(name);
    const std::string example(column.dimension.example.empty() ? "0.5" : column.dimension.example);
    examples.push_back(blocks ? column_key(column) + ": " + example : example);
  }
  if (!blocks)
    return fmt::format("list of rows [{}] like [[{}]]", fmt::join(names, ", "), fmt::join(examples, ", "));
  return fmt::format("list of rows {{{}}} like [{{{}}}]{}", fmt::join(names, ", "), fmt::join(examples, ", "),
                     field.from_file ? " or {file: NAME.csv}" : "");
}

std::string kind_text(const Field& field, Kind kind) {
  switch (kind) {
    case Kind::quantity:
      return fmt::format("{} like '{}'", field.dimension.name, field.dimension.example);
    case Kind::integer:
      return "whole number";
    case Kind::number:
      return "number without unit";
    case Kind::flag:
      return "true or false";
    case Kind::choice:
      return fmt::format("one of {}", fmt::join(field.choices, ", "));
    case Kind::text:
      return "text";
    case Kind::list:
      if (!field.columns.empty()) return rows_text(field);
      if (field.group > 0)
        return fmt::format("list of {}, each element a {}, or a list of such lists", field.group,
                           kind_text(field, field.element));
      return "list, each element a " + kind_text(field, field.element) +
             (field.from_file ? ", or {file: NAME.csv}" : "");
  }
  return {};
}

}  // namespace

Field& Field::of_numerics() {
  numerical = true;
  return *this;
}

const Use& Field::use_in(Model model) const {
  const auto own = std::ranges::find(of_machines, model, &std::pair<Model, Use>::first);
  return own == of_machines.end() ? use : own->second;
}

Field& Field::by_default(std::string text, std::string reason) {
  default_text = std::move(text);
  default_reason = std::move(reason);
  return *this;
}

Field& Field::required() {
  required_by = models;
  return *this;
}

Field& Field::listed() {
  element = kind;
  kind = Kind::list;
  return *this;
}

Field& Field::under(Condition condition) {
  use = use.when(std::move(condition));
  return *this;
}

bool has_choices(const Field& field) {
  return std::any_of(field.columns.begin(), field.columns.end(),
                     [](const ListColumn& column) { return column.one_of > 0; });
}

std::string column_key(const ListColumn& column) {
  std::string key = column.name;
  std::replace(key.begin(), key.end(), ' ', '_');
  return key;
}

FieldReading read_field_number(const Field& field, double value, std::string text) {
  assert(is_numeric(field));
  if (text.empty()) {
    text = fmt::format("{}", value);
    if (field.kind == Kind::quantity) text += " " + std::string(field.dimension.si);
  }
  if (!std::isfinite(value)) return bad(quote(text) + " is not a number", field);
  if (field.kind == Kind::integer && value != std::round(value))
    return bad(quote(text) + " is not a whole number", field);
  if (!in_range(value, field)) return bad(quote(text) + " is out of range", field);
  return good({std::move(text), value, {}});
}

FieldReading read_field(const Field& field, const Entry& entry) {
  if (field.kind == Kind::list) return read_list(field, entry);
  if (entry.shape != Entry::Shape::scalar) return bad(describe(entry) + " found", field);
  const bool plain_only =
      field.kind == Kind::integer || field.kind == Kind::number || field.kind == Kind::flag;
  if (plain_only && entry.quoted) return bad("the text " + describe(entry) + " in quotes", field);
  return read_scalar(field, entry);
}

std::string requirement(const Field& field) {
  std::string text = kind_text(field, field.kind);
  if (field.kind != Kind::flag && field.kind != Kind::choice)
    text = (text.starts_with('a') ? "an " : "a ") + text;
  const std::string range = range_text(field);
  return range.empty() ? text : text + ", " + range + ",";
}

}  // namespace orbearing::app
