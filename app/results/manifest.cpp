#include "app/results/manifest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/errors.hpp"
#include "orbearing/files.hpp"

namespace orbearing::app {
namespace {

using Json = nlohmann::ordered_json;

// A line that this version did not write; parse_manifest reports which.
struct Damaged : std::exception {};

constexpr int manifest_format = 3;

Json spectrum_line(const LoadSpectrum& spectrum) {
  Json bins = Json::array();
  for (const LoadBin& bin : spectrum.bins) {
    bins.push_back({bin.power, bin.speed, bin.share});
    if (!bin.file.empty()) bins.back().push_back(bin.file);
  }
  return {{"hours", spectrum.hours},
          {"minimum_load", spectrum.minimum_load},
          {"lines", spectrum.lines},
          {"bins_W_rad_per_s_share", bins}};
}

LoadSpectrum spectrum_from(const Json& object) {
  LoadSpectrum spectrum{.hours = object.at("hours").get<double>(),
                        .minimum_load = object.at("minimum_load").get<double>(),
                        .lines = object.at("lines").get<std::size_t>()};
  for (const Json& bin : object.at("bins_W_rad_per_s_share"))
    spectrum.bins.push_back({bin.at(0).get<double>(), bin.at(1).get<double>(), bin.at(2).get<double>(),
                             bin.size() > 3 ? bin.at(3).get<std::string>() : std::string()});
  return spectrum;
}

ManifestHeader header_from(const Json& object) {
  if (object.at("orbearing_results").get<int>() != manifest_format) throw Damaged{};
  ManifestHeader header;
  header.case_name = object.at("case").get<std::string>();
  header.case_hash = object.at("case_hash").get<std::string>();
  header.program_version = object.at("program_version").get<std::string>();
  header.instruction_set = object.at("instruction_set").get<std::string>();
  header.fidelity = object.at("fidelity").get<std::string>();
  header.points = object.at("points").get<std::size_t>();
  if (!object.at("shard").is_null()) header.shard = parse_shard(object.at("shard").get<std::string>());
  for (const Json& axis : object.at("axes"))
    header.axes.push_back({axis.at("column").get<std::string>(), axis.at("units").get<std::string>(),
                           axis.at("meaning").get<std::string>()});
  if (object.contains("continue"))
    header.continued = parse_direction(object.at("continue").get<std::string>());
  if (object.contains("sets")) header.sets = object.at("sets").get<std::vector<std::string>>();
  header.refined = object.at("refined").get<bool>();
  header.resonances = object.at("resonances").get<bool>();
  header.life = object.at("life").get<std::string>();
  if (object.contains("table")) header.table = object.at("table").get<std::string>();
  if (object.contains("spectrum")) header.spectrum = spectrum_from(object.at("spectrum"));
  if (header.spectrum.points() > header.points) throw Damaged{};
  return header;
}

void add_entry(Manifest& manifest, const Json& object) {
  const auto point = object.at("point").get<std::size_t>();
  const bool of_this_sweep = manifest.header->holds(point) || manifest.header->adds(point);
  const auto file = object.at("file").get<std::string>();
  const bool named = file == point_file_name(point) || (file.empty() && !manifest.header->table.empty());
  if (!of_this_sweep || !named) throw Damaged{};
  ManifestEntry entry{file, object.at("checksum").get<std::string>(),
                      row_from_json(*manifest.header, object.at("row"))};
  if (object.contains("others")) entry.others = object.at("others").get<std::map<std::string, std::string>>();
  manifest.entries[point] = std::move(entry);
}

constexpr std::string_view sum_opening = ",\"line_checksum\":\"", sum_end = "\"}";
constexpr std::size_t sum_digits = 16;

}  // namespace

std::string sealed_line(const std::string& text) {
  return fmt::format("{}{}{}{}\n", text.substr(0, text.size() - 1), sum_opening, checksum(text), sum_end);
}

bool is_sealed(std::string_view line) {
  const std::size_t length = sum_opening.size() + sum_digits + sum_end.size();
  if (line.size() < length || !line.ends_with(sum_end)) return false;
  const std::string_view sum = line.substr(line.size() - length);
  const std::string content = std::string(line.substr(0, line.size() - length)) + "}";
  return sum.starts_with(sum_opening) && sum.substr(sum_opening.size(), sum_digits) == checksum(content);
}

namespace {

bool is_blank(std::string_view line) {
  return line.find_first_not_of(' ') == std::string_view::npos;
}

void add_line(Manifest& manifest, std::string_view line) {
  const Json object = Json::parse(line);
  if (manifest.header)
    add_entry(manifest, object);
  else
    manifest.header = header_from(object);
}

}  // namespace

namespace {

using Entries = std::map<std::size_t, ManifestEntry>;

/// The grid's point with the next lower speed among those that differ from `row` in speed alone.
std::size_t grid_point_below(const ManifestHeader& header, const Entries& entries, const SweepRow& row) {
  std::optional<std::size_t> below;
  double best = -std::numeric_limits<double>::infinity();
  for (const auto& [point, entry] : entries) {
    if (point >= header.grid()) break;
    const double speed = entry.row.point.input_speed;
    if (!header.holds(point) || !on_one_line(entry.row, row)) continue;
    if (speed > row.point.input_speed || speed < best) continue;
    best = speed;
    below = point;
  }
  return below.value_or(0);
}

/// Added rows by the number of the grid's point that they follow, in ascending order of speed.
std::multimap<std::size_t, const SweepRow*> added_rows(const ManifestHeader& header, const Entries& entries) {
  std::vector<const SweepRow*> added;
  for (const auto& [point, entry] : entries)
    if (header.adds(point)) added.push_back(&entry.row);
  std::sort(added.begin(), added.end(), [&](const SweepRow* one, const SweepRow* other) {
    return one->point.input_speed < other->point.input_speed;
  });
  std::multimap<std::size_t, const SweepRow*> following;
  for (const SweepRow* row : added) following.emplace(grid_point_below(header, entries, *row), row);
  return following;
}

}  // namespace

std::vector<SweepRow> rows_in_table_order(const ManifestHeader& header, const Entries& entries) {
  const auto following = added_rows(header, entries);
  std::vector<SweepRow> rows;
  for (const auto& [point, entry] : entries) {
    if (point >= header.grid()) break;
    rows.push_back(entry.row);
    const auto [begin, end] = following.equal_range(point);
    for (auto next = begin; next != end; ++next) rows.push_back(*next->second);
  }
  return rows;
}

std::string point_file_name(std::size_t point) {
  return fmt::format("points/{:05}.nc", point);
}

std::string header_line(const ManifestHeader& header) {
  Json object = {{"orbearing_results", manifest_format},
                 {"case", header.case_name},
                 {"case_hash", header.case_hash},
                 {"program_version", header.program_version},
                 {"instruction_set", header.instruction_set},
                 {"fidelity", header.fidelity},
                 {"points", header.points},
                 {"shard", nullptr},
                 {"axes", Json::array()},
                 {"refined", header.refined},
                 {"resonances", header.resonances},
                 {"life", header.life}};
  if (header.shard) object["shard"] = to_string(*header.shard);
  for (const SweptAxis& axis : header.axes)
    object["axes"].push_back({{"column", axis.column}, {"units", axis.units}, {"meaning", axis.meaning}});
  if (header.continued) object["continue"] = to_string(*header.continued);
  if (!header.sets.empty()) object["sets"] = header.sets;
  if (!header.table.empty()) object["table"] = header.table;
  if (header.spectrum.lines > 0) object["spectrum"] = spectrum_line(header.spectrum);
  return sealed_line(object.dump());
}

std::string entry_line(const ManifestHeader& header, std::size_t point, const ManifestEntry& entry) {
  Json object = {{"point", point},
                 {"file", entry.file},
                 {"checksum", entry.checksum},
                 {"row", row_json(header, entry.row)}};
  if (!entry.others.empty()) object["others"] = entry.others;
  return sealed_line(object.dump());
}

Manifest parse_manifest(std::string_view text, const std::string& location) {
  Manifest manifest;
  for (std::size_t line = 1; manifest.sound_bytes < text.size(); ++line) {
    const std::size_t end = text.find('\n', manifest.sound_bytes);
    if (end == std::string_view::npos) break;
    const DamagedLine here{line, manifest.sound_bytes, end - manifest.sound_bytes};
    const std::string_view content = text.substr(here.begin, here.length);
    if (manifest.header && !is_sealed(content)) {
      if (!is_blank(content)) manifest.damaged.push_back(here);
      // After a loss of power the last line may have its end, yet not its content.
      if (!is_blank(content) && end + 1 == text.size()) break;
    } else {
      try {
        if (!is_sealed(content)) throw Damaged{};
        add_line(manifest, content);
      } catch (const std::exception&) {
        throw BadInput(
            fmt::format("{}:{}:1: not a line that this version of the program wrote; an undamaged result "
                        "folder is required, or an empty one for a new start",
                        location, line));
      }
    }
    manifest.sound_bytes = end + 1;
  }
  return manifest;
}

}  // namespace orbearing::app
