#include "app/case/catalogue_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "app/case/catalogue_fields.hpp"
#include "app/case/field_table.hpp"
#include "app/case/rows_file.hpp"
#include "app/catalogue_text.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

namespace catalogue = bearing::catalogue;
using Line = catalogue::Entry;

// One number of a line.
struct NumberColumn {
  const char* key;
  Dimension dimension;
  Range range;
  double Line::*number;
};

struct TextColumn {
  const char* key;
  std::string Line::*text;
};

constexpr double kLongest = 10e3;     // [mm]
constexpr double kStrongest = 1e9;    // [N]
constexpr double kRightAngle = 90.0;  // [deg]

const std::array<NumberColumn, 10>& number_columns() {
  static const std::array<NumberColumn, 10> columns{
      {{"bore", dimension::length, positive(kLongest), &Line::bore},
       {"outside_diameter", dimension::length, positive(kLongest), &Line::outside},
       {"width", dimension::length, positive(kLongest), &Line::width},
       {"inner_raceway", dimension::length, positive(kLongest), &Line::inner_race},
       {"outer_raceway", dimension::length, positive(kLongest), &Line::outer_race},
       {"contact_angle", dimension::angle, positive(kRightAngle), &Line::contact_angle},
       {"dynamic_capacity", dimension::force, positive(kStrongest), &Line::dynamic_rating},
       {"static_capacity", dimension::force, positive(kStrongest), &Line::static_rating},
       {"fatigue_load_limit", dimension::force, positive(kStrongest), &Line::fatigue_load_limit},
       {"static_factor", {}, positive(100.0), &Line::static_factor}}};
  return columns;
}

constexpr const char *kDesignationColumn = "designation", *kFamilyColumn = "family", *kCageColumn = "cage";
constexpr std::array<TextColumn, 4> kTextColumns{{{"suffix", &Line::suffix},
                                                  {kCageColumn, &Line::cage},
                                                  {"maker", &Line::maker},
                                                  {"source", &Line::source}}};

// Columns that a line of a family requires, and those that it must not have.
struct FamilyColumns {
  std::string_view name;
  catalogue::Family family;
  std::vector<std::string_view> required, refused;
};

const std::array<FamilyColumns, 4>& families() {
  using enum catalogue::Family;
  static const std::array<FamilyColumns, 4> all{
      {{"cylindrical-roller",
        cylindrical,
        {"bore", "outside_diameter", "width", "inner_raceway", "dynamic_capacity", "static_capacity"},
        {"contact_angle", "static_factor"}},
       {"deep-groove-ball",
        deep_groove,
        {"bore", "outside_diameter", "width", "dynamic_capacity", "static_capacity"},
        {"inner_raceway", "outer_raceway", "contact_angle"}},
       {"angular-contact-ball",
        angular_contact,
        {"bore", "outside_diameter", "width", "contact_angle", "dynamic_capacity", "static_capacity"},
        {"inner_raceway", "outer_raceway"}},
       {"needle-roller-cage",
        needle_cage,
        {"width", "inner_raceway", "outer_raceway", "dynamic_capacity", "static_capacity"},
        {"bore", "outside_diameter", "contact_angle", "static_factor"}}}};
  return all;
}

const FamilyColumns* family_named(std::string_view name) {
  for (const FamilyColumns& one : families())
    if (one.name == name) return &one;
  return nullptr;
}

// All columns as those of a list of rows; one with a unit first, which messages show as an example.
Field table_field() {
  Field field{.path = "bearing.catalogue", .kind = Kind::list, .use = Use({}, {})};
  for (const NumberColumn& column : number_columns())
    field.columns.push_back({column.key, column.dimension, column.range});
  for (const char* key : {kDesignationColumn, kFamilyColumn}) field.columns.push_back({key});
  for (const TextColumn& column : kTextColumns) field.columns.push_back({column.key});
  return field;
}

// A cell that is left empty, with the unit of its column at most.
bool is_empty(const Entry& cell) {
  return cell.text.empty() || cell.text.front() == ' ';
}

// "NU/NJ 205" are NU 205 and NJ 205.
std::vector<std::string> designations_in(const std::string& text) {
  const std::size_t space = text.find(' ');
  const std::string types = text.substr(0, space);
  if (space == std::string::npos || types.find('/') == std::string::npos) return {text};
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin <= types.size();) {
    const std::size_t end = std::min(types.find('/', begin), types.size());
    names.push_back(types.substr(begin, end - begin) + text.substr(space));
    begin = end + 1;
  }
  return names;
}

// One row of a table that becomes a line of a catalogue.
class LineReader {
 public:
  LineReader(const Entry& row, std::string path, std::vector<Mistake>& mistakes)
      : row_(row), path_(std::move(path)), mistakes_(mistakes) {}

  std::optional<Line> read(const std::string& file) {
    const std::size_t before = mistakes_.size();
    read_names();
    for (const NumberColumn& column : number_columns()) read_number(column);
    for (const TextColumn& column : kTextColumns)
      if (const Entry* cell = filled(column.key)) line_.*column.text = cell->text;
    if (line_.source.empty()) line_.source = file;
    check_cage();
    if (mistakes_.size() == before) check();
    return mistakes_.size() == before ? std::optional<Line>(std::move(line_)) : std::nullopt;
  }

 private:
  const Entry* filled(std::string_view key) const {
    const Member* member = find_member(row_, key);
    return member == nullptr || is_empty(member->value) ? nullptr : &member->value;
  }

  void add_error(const Location& location, std::string found, std::string required) {
    mistakes_.push_back({location, path_, {std::move(found), std::move(required)}});
  }

  // At the cell of the column; at the row where it has none.
  Location location_of(std::string_view key) const {
    const Member* member = find_member(row_, key);
    return member == nullptr ? row_.location : member->value.location;
  }

  void read_names() {
    if (const Entry* names = filled(kDesignationColumn))
      line_.designations = designations_in(names->text);
    else
      add_error(location_of(kDesignationColumn), "no designation",
                "one in each row is required, such as NU 205");
    const Entry* family = filled(kFamilyColumn);
    family_ = family == nullptr ? nullptr : family_named(family->text);
    if (family_ != nullptr) {
      line_.family = family_->family;
      return;
    }
    std::vector<std::string_view> names;
    for (const FamilyColumns& one : families()) names.push_back(one.name);
    add_error(location_of(kFamilyColumn), "family: " + (family == nullptr ? "nothing" : describe(*family)),
              fmt::format("one of {} is required", fmt::join(names, ", ")));
  }

  void read_number(const NumberColumn& column) {
    const Entry* cell = filled(column.key);
    if (cell == nullptr) {
      if (family_ != nullptr && is_among(family_->required, column.key))
        add_error(location_of(column.key), fmt::format("no {}", column.key),
                  fmt::format("a row of a {} states {}", family_->name, fmt::join(family_->required, ", ")));
      return;
    }
    if (family_ != nullptr && is_among(family_->refused, column.key)) {
      add_error(cell->location, fmt::format("{} of a {}", column.key, family_->name),
                "an empty cell is required");
      return;
    }
    const Field field{.path = column.key,
                      .kind = column.dimension.si.empty() ? Kind::number : Kind::quantity,
                      .use = Use({}, {}),
                      .dimension = column.dimension,
                      .range = column.range};
    const FieldReading reading = read_field(field, *cell);
    if (reading.good)
      line_.*column.number = reading.value.number;
    else
      add_error(cell->location, fmt::format("{}: {}", column.key, reading.message.found),
                reading.message.required);
  }

  void check_cage() {
    const Entry* cell = filled(kCageColumn);
    if (cell == nullptr) return;
    const FieldReading reading = read_field(*find_field(catalogue_keys::kMaterial), *cell);
    if (!reading.good)
      add_error(cell->location, fmt::format("{}: {}", kCageColumn, reading.message.found),
                reading.message.required);
  }

  static bool is_among(const std::vector<std::string_view>& keys, std::string_view key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
  }

  // Diameters rise from the bore outward.
  void check() {
    const NumberColumn* inner = nullptr;
    for (const char* key : {"bore", "inner_raceway", "outer_raceway", "outside_diameter"}) {
      const auto column =
          std::find_if(number_columns().begin(), number_columns().end(),
                       [&](const NumberColumn& one) { return std::string_view(one.key) == key; });
      if (line_.*column->number == 0.0) continue;
      if (inner != nullptr && !(line_.*column->number > line_.*inner->number))
        add_error(
            location_of(key), fmt::format("{} of {:g} mm", key, 1e3 * line_.*column->number),
            fmt::format("more than the {} of {:g} mm is required", inner->key, 1e3 * line_.*inner->number));
      inner = &*column;
    }
  }

  const Entry& row_;
  std::string path_;
  std::vector<Mistake>& mistakes_;
  const FamilyColumns* family_ = nullptr;
  Line line_;
};

std::string number_text(double value) {
  return value == 0.0 ? "" : fmt::format("{:.12g}", value);
}

// Quoted where a comma in it would end the cell.
std::string cell_of(const std::string& text) {
  return text.find(',') == std::string::npos ? text : '"' + text + '"';
}

// "NU/NJ 205" of NU 205 and NJ 205.
std::string types_joined(const std::vector<std::string>& designations) {
  if (designations.size() == 1) return designations.front();
  std::vector<std::string> types;
  for (const std::string& one : designations) types.push_back(one.substr(0, one.find(' ')));
  const std::string& first = designations.front();
  return fmt::format("{}{}", fmt::join(types, "/"), first.substr(first.find(' ')));
}

}  // namespace

std::vector<Line> read_catalogue(const std::string& text, const std::string& file, const std::string& path,
                                 std::vector<Mistake>& mistakes) {
  static const Field field = table_field();
  std::vector<Line> lines;
  std::set<std::string> known;
  for (const Entry& row : rows_of_text(field, text, path, file, mistakes).items) {
    std::optional<Line> line = LineReader(row, path, mistakes).read(file);
    if (!line) continue;
    for (const std::string& name : line->designations)
      if (!known.insert(name).second)
        mistakes.push_back(
            {find_member(row, kDesignationColumn)->value.location,
             path,
             {fmt::format("the designation {} again", quote(name)), "each designation once is required"}});
    lines.push_back(std::move(*line));
  }
  return lines;
}

const std::vector<Line>& built_in_catalogue() {
  static const std::vector<Line> lines = [] {
    std::vector<Mistake> mistakes;
    std::vector<Line> read = read_catalogue(catalogue_text, "catalogue.csv", "bearing.catalogue", mistakes);
    if (!mistakes.empty()) throw std::logic_error(describe(mistakes.front(), "catalogue.csv"));
    return read;
  }();
  return lines;
}

bool take_catalogue(FieldValue& value, const Location& location, const std::string& path,
                    const std::string& case_file, std::vector<Mistake>& mistakes) {
  const bool in_the_case = value.given.find('\n') != std::string::npos;
  const std::optional<NamedFile> file =
      in_the_case ? NamedFile{path, value.given}
                  : read_named_file(value.given, location, path, case_file, mistakes);
  if (!file) return false;
  const std::size_t before = mistakes.size();
  (void)read_catalogue(file->text, file->name, path, mistakes);
  if (in_the_case)
    for (std::size_t i = before; i < mistakes.size(); ++i) {
      mistakes[i].message.found =
          fmt::format("line {} of the table: {}", mistakes[i].location.line, mistakes[i].message.found);
      mistakes[i].location = location;
    }
  value.texts = {in_the_case ? path : std::filesystem::path(file->name).filename().string(), file->text};
  return mistakes.size() == before;
}

const std::vector<Line>& catalogue_of(const FieldValue& value) {
  using ByText = std::map<std::string, std::vector<Line>, std::less<>>;
  static std::map<std::string, ByText, std::less<>> known;
  static std::mutex one_at_a_time;
  const std::scoped_lock lock(one_at_a_time);
  const std::string &file = value.texts.at(0), &text = value.texts.at(1);
  const auto [found, fresh] = known[file].try_emplace(text);
  std::vector<Mistake> none;
  if (fresh) found->second = read_catalogue(text, file, "", none);
  return found->second;
}

std::string table_of(const Line& line) {
  std::vector<std::string> head{kDesignationColumn, kFamilyColumn}, row{types_joined(line.designations)};
  for (const FamilyColumns& one : families())
    if (one.family == line.family) row.emplace_back(one.name);
  for (const NumberColumn& column : number_columns()) {
    if (line.*column.number == 0.0) continue;
    const Dimension& dimension = column.dimension;
    head.push_back(dimension.si.empty() ? column.key
                                        : fmt::format("{} [{}]", column.key, dimension.customary));
    const double value = line.*column.number;
    row.push_back(number_text(
        dimension.si.empty() ? value : convert(value, dimension.si, dimension.customary).value.value()));
  }
  for (const TextColumn& column : kTextColumns) {
    if ((line.*column.text).empty()) continue;
    head.emplace_back(column.key);
    row.push_back(cell_of(line.*column.text));
  }
  return fmt::format("{}\n{}\n", fmt::join(head, ","), fmt::join(row, ","));
}

}  // namespace orbearing::app
