#include "app/results/sweep_row.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/results/worst_bearing.hpp"

namespace orbearing::app {

namespace {

using described::Columns;
using described::Dimension;
using Json = nlohmann::ordered_json;

/// Messages of libraries may hold line ends or bytes that are not UTF-8; tables and JSON need neither.
std::string without_breaks(const std::string& status) {
  if (status.empty()) return "failed without a reason";
  const nlohmann::json text = status;
  std::string clean =
      nlohmann::json::parse(text.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace))
          .get<std::string>();
  std::replace_if(
      clean.begin(), clean.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return clean;
}

void forget(std::string_view, const Dimension&, double& value) {
  value = not_given;
}

// As files have it: 15 digits in the customary unit.
void round_as_shown(std::string_view, const Dimension& dimension, double& value) {
  value = in_customary_unit(dimension, value) * dimension.factor;
}

// Each set of the header has results, those that are missing without a number.
void complete_sets(const ManifestHeader& header, analysis::PointRow& point) {
  for (std::size_t i = point.sets.size(); i < header.sets.size(); ++i) {
    Columns unknown(forget);
    list(unknown, point.sets.emplace_back(analysis::SetResult{.set = header.sets[i]}));
  }
}

// A row without a number.
SweepRow empty_row(const ManifestHeader& header) {
  SweepRow row{.axes = std::vector<double>(header.axes.size(), not_given)};
  Columns unknown(forget);
  list(unknown, row.point);
  complete_sets(header, row.point);
  return row;
}

}  // namespace

void list(Columns& columns, Resonance& resonance) {
  namespace dimension = described::dimension;
  columns.text("resonance_kind", "of the mode: rotational, translational or planet", resonance.kind);
  columns.text("resonance_mode", "its name in the report", resonance.mode);
  columns.value("resonance_frequency_Hz", dimension::cycles,
                "natural frequency of the gear set, and harmonic of the mesh, at the nearest resonance",
                resonance.frequency);
  columns.value("resonance_harmonic", dimension::ratio, "harmonic of the mesh frequency that meets it",
                resonance.harmonic);
  columns.value("resonance_speed_rpm", dimension::angular_speed, "input speed at which it does",
                resonance.speed);
  columns.value(
      "resonance_frequency_change_Hz", dimension::cycles,
      "change of that natural frequency from 0.01 % below that speed to 0.01 % above; large where a "
      "roller leaves its load there",
      resonance.change);
}

void describe(Record& record, const Resonance& resonance) {
  described::describe_listed(record, resonance);
}

SweepRow sweep_row(const analysis::PointResult& result, const ManifestHeader& header,
                   std::vector<double> axes, const std::optional<Resonance>& resonance) {
  SweepRow row;
  if (is_computed(result.status)) {
    row.point = analysis::row_of(result);
    complete_sets(header, row.point);
  } else {
    row = empty_row(header);
    row.point.input_speed = result.input_speed;
  }
  row.point.status = without_breaks(result.status);
  row.axes = std::move(axes);
  row.resonance = resonance;
  Columns rounding(round_as_shown);
  list(rounding, header, row);
  return row;
}

SweepRow row_of_numbers(const std::vector<std::pair<std::string, double>>& values,
                        const ManifestHeader& header) {
  SweepRow row = empty_row(header);
  Columns columns([&](std::string_view name, const Dimension& dimension, double& value) {
    const auto last = std::find_if(values.rbegin(), values.rend(), [&](const auto& one) {
      return one.first == name && std::isfinite(one.second);
    });
    if (last != values.rend()) value = last->second * dimension.factor;
  });
  list(columns, header, row);
  return row;
}

double governing_hours(const ManifestHeader& header, const analysis::PointNumbers& point) {
  return governing_hours(header, point.life_hours, point.rating.hours);
}

double governing_hours(const ManifestHeader& header, double life_hours,
                       const bearing::rating::RatedHours& rated) {
  using bearing::rating::Life;
  for (const Life life : {Life::basic, Life::reference, Life::modified, Life::modified_reference})
    if (header.life == bearing::rating::hours_key(life))
      return bearing::rating::hours_of(life, life_hours, rated);
  return life_hours;
}

const SweepRow* longest_lived(const ManifestHeader& header, std::span<const SweepRow> rows, bool grid_alone) {
  const SweepRow* longest = nullptr;
  double life = 0.0;
  for (const SweepRow& row : rows) {
    const double hours = governing_hours(header, row.point);
    if ((grid_alone && row.refined) || !(hours > life)) continue;
    life = hours;
    longest = &row;
  }
  return longest;
}

double axis_value(const ManifestHeader& header, const SweepRow& row, std::string_view column) {
  const auto axis = std::ranges::find(header.axes, column, &SweptAxis::column);
  return axis == header.axes.end() ? not_given
                                   : row.axes[static_cast<std::size_t>(axis - header.axes.begin())];
}

void list(Columns& columns, const ManifestHeader& header, SweepRow& row) {
  list(columns, row.point);
  columns.flag(refined_column, "whether it was added around the peak", row.refined);
  for (std::size_t i = 0; i < header.axes.size(); ++i)
    columns.value(header.axes[i].column, {}, header.axes[i].meaning, row.axes[i]);
  if (!header.sets.empty())
    columns.text(limiting_set_column, "of several sets, the one with the worst bearing",
                 row.point.limiting_set);
  for (std::size_t i = 0; i < header.sets.size(); ++i)
    columns.within(column_prefix(header.sets[i]), [&] { list(columns, row.point.sets[i]); });
  if (header.resonances) columns.part(row.resonance, [&](Resonance& resonance) { list(columns, resonance); });
}

void describe(Record& record, const ManifestHeader& header, const SweepRow& row) {
  Columns columns(record);
  SweepRow listed = row;
  list(columns, header, listed);
}

Record record_of(const ManifestHeader& header, const SweepRow& row) {
  Record record;
  describe(record, header, row);
  return record;
}

double number_named(const ManifestHeader& header, const SweepRow& row, std::string_view name) {
  double found = not_given;
  Columns columns([&](std::string_view column, const Dimension& dimension, double& value) {
    if (column == name) found = in_customary_unit(dimension, value);
  });
  SweepRow listed = row;
  list(columns, header, listed);
  return found;
}

std::vector<std::pair<std::string, double>> named_numbers(const ManifestHeader& header, const SweepRow& row) {
  std::vector<std::pair<std::string, double>> numbers;
  Columns columns([&](std::string_view name, const Dimension& dimension, double& value) {
    numbers.emplace_back(name, in_customary_unit(dimension, value));
  });
  SweepRow listed = row;
  list(columns, header, listed);
  return numbers;
}

std::string csv_head(const ManifestHeader& header) {
  return csv_names(record_of(header, empty_row(header)));
}

std::string csv_line(const ManifestHeader& header, const SweepRow& row) {
  return csv_values(record_of(header, row));
}

nlohmann::ordered_json row_json(const ManifestHeader& header, const SweepRow& row) {
  Record record = record_of(header, row);
  if (!row.point.planets.empty())
    record.table("planets", "planet", "planets one by one, where they carry unlike loads", row.point.planets,
                 described::describe_listed<analysis::PlanetResult>);
  return json_of(record);
}

namespace {

// Numbers and texts of `object` by their names.
Columns reading_of(const Json& object) {
  return Columns(
      [&](std::string_view name, const Dimension& dimension, double& value) {
        const Json& field = object.at(std::string(name));
        if (field.is_boolean())
          value = field.get<bool>() ? 1.0 : 0.0;
        else
          value = field.is_null() ? not_given : field.get<double>() * dimension.factor;
      },
      [&](std::string_view name, std::string& text) {
        text = object.at(std::string(name)).get<std::string>();
      });
}

}  // namespace

SweepRow row_from_json(const ManifestHeader& header, const nlohmann::ordered_json& object) {
  SweepRow row = empty_row(header);
  Columns columns = reading_of(object);
  list(columns, header, row);
  if (object.contains("planets"))
    for (const Json& planet : object.at("planets")) {
      Columns of_planet = reading_of(planet);
      list(of_planet, row.point.planets.emplace_back());
    }
  return row;
}

}  // namespace orbearing::app
