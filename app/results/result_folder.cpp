#include "app/results/result_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <system_error>

#include "app/errors.hpp"
#include "app/results/spectrum_life.hpp"
#include "app/standard_error.hpp"
#include "orbearing/files.hpp"
#include "orbearing/results.hpp"

namespace orbearing::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* points_name = "points";
constexpr const char* table_name = "sweep.csv";
constexpr const char* spectrum_name = "spectrum.csv";

/// Names in `folder`; none where it is missing. Throws BadInput where it is no folder or cannot be read.
std::vector<std::string> names_in(const fs::path& folder) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (status.type() == fs::file_type::not_found) return {};
  if (status.type() != fs::file_type::none && status.type() != fs::file_type::directory)
    throw BadInput(folder.string() + ": is not a folder; a new or empty folder is required");
  std::vector<std::string> names;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error))
    names.push_back(entry->path().filename().string());
  if (error)
    throw BadInput(fmt::format("{}: cannot be looked into: {}; a folder open to you is required",
                               folder.string(), error.message()));
  std::sort(names.begin(), names.end());
  return names;
}

/// True for the start of a header that a kill cut short.
bool is_torn_header(const std::string& text) {
  const std::string opening = header_line({}).substr(0, header_line({}).find(','));
  const std::size_t common = std::min(opening.size(), text.size());
  return text.find('\n') == std::string::npos && text.compare(0, common, opening, 0, common) == 0;
}

[[noreturn]] void refuse_foreign(const fs::path& folder, const std::string& name) {
  throw BadInput(
      fmt::format("{}: holds '{}', which is no result of a sweep; a new or empty folder is required",
                  folder.string(), name));
}

void require_same(const fs::path& folder, const ManifestHeader& found, const ManifestHeader& required) {
  std::vector<std::string> lines = differences(found, required);
  if (found.shard != required.shard)
    lines.push_back(fmt::format("{} was found; {} is required",
                                found.shard ? "shard " + to_string(*found.shard) : "the whole sweep",
                                required.shard ? "shard " + to_string(*required.shard) : "the whole sweep"));
  for (std::string& line : lines)
    line = fmt::format("{}: --resume: {}; use another folder, or the case of these results", folder.string(),
                       line);
  if (!lines.empty()) throw BadInput(lines);
}

/// Throws BadInput unless `folder` may be written to in this mode. Changes nothing.
void require_usable(const fs::path& folder, const ManifestHeader& header, OpenMode mode) {
  const std::vector<std::string> names = names_in(folder);
  if (names.empty()) return;
  for (const char* name : {manifest_name, points_name}) require_no_link(folder / name);
  const bool has_manifest = std::binary_search(names.begin(), names.end(), manifest_name);
  if (!has_manifest) refuse_foreign(folder, names.front());
  if (mode == OpenMode::fresh)
    throw BadInput(fmt::format(
        "{}: holds results; a new or empty folder is required, or --resume to continue with these",
        folder.string()));
  const fs::path file = folder / manifest_name;
  const std::string text = read_file(file);
  const Manifest manifest = parse_manifest(text, file.string());
  if (manifest.header) return require_same(folder, *manifest.header, header);
  if (names.size() > 1 || !is_torn_header(text)) refuse_foreign(folder, manifest_name);
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  // A trailing separator makes the call report no folder made; only the state afterwards matters.
  if (fs::is_directory(folder)) return;
  throw BadInput(
      fmt::format("{}: cannot be made: {}; a writable path is required", folder.string(), error.message()));
}

void remove_leftovers(const fs::path& folder) {
  for (const std::string& name : names_in(folder)) {
    std::error_code ignored;
    if (name.ends_with(aside_ending)) fs::remove(folder / name, ignored);
  }
}

void write_where_unlike(const fs::path& file, const std::string& content) {
  if (!fs::exists(file) || read_file(file) != content) write_aside_and_rename(file, content);
}

std::string fault_of_file(const fs::path& file, const std::string& sum) {
  std::error_code error;
  const char* fault = nullptr;
  if (!fs::exists(file, error))
    fault = "is missing";
  else if (!fs::is_regular_file(file, error))
    fault = "is not a file";
  else if (fs::file_size(file, error) == 0)
    fault = "is empty";
  else if (checksum(read_file(file)) != sum)
    fault = "differs from what its sweep wrote";
  return fault == nullptr ? "" : fmt::format("{}: {}", file.string(), fault);
}

}  // namespace

std::string fault_of_point(const fs::path& folder, const ManifestEntry& entry) {
  std::string fault = entry.file.empty() ? "" : fault_of_file(folder / entry.file, entry.checksum);
  for (const auto& [name, sum] : entry.others)
    if (fault.empty()) fault = fault_of_file(folder / name, sum);
  return fault;
}

ResultFolder::ResultFolder(fs::path folder, const ManifestHeader& header, const std::string& resolved_case,
                           OpenMode mode)
    : folder_(std::move(folder)), header_(header) {
  require_usable(folder_, header, mode);
  make_folder(folder_);
  manifest_ = AppendOnlyFile(folder_ / manifest_name);
  const bool was_empty = manifest_.content().empty();
  try {
    begin(header, resolved_case);
  } catch (...) {
    if (was_empty) discard();
    throw;
  }
}

void ResultFolder::begin(const ManifestHeader& header, const std::string& resolved_case) {
  Manifest manifest = parse_manifest(manifest_.content(), (folder_ / manifest_name).string());
  // Another sweep may have begun between the first check and the lock.
  if (manifest.header) require_same(folder_, *manifest.header, header);
  for (const DamagedLine& line : manifest.damaged) {
    damaged_.push_back(fmt::format("{}:{}:1: differs from what its sweep wrote",
                                   (folder_ / manifest_name).string(), line.number));
    if (line.begin < manifest.sound_bytes) manifest_.blank(line.begin, line.length);
  }
  manifest_.truncate(manifest.sound_bytes);
  if (!manifest.header) manifest_.append(header_line(header));
  make_folder(folder_ / points_name);
  remove_leftovers(folder_);
  remove_leftovers(folder_ / points_name);
  write_where_unlike(folder_ / resolved_case_name, resolved_case);
  sync_folder(folder_);
  finished_ = std::move(manifest.entries);
  std::erase_if(finished_, [&](const auto& entry) {
    const std::string fault = fault_of_point(folder_, entry.second);
    if (!fault.empty()) damaged_.push_back(fault);
    return !fault.empty();
  });
}

void ResultFolder::keep(std::vector<FinishedPoint> points) {
  std::vector<FileContent> files;
  const auto name_of = [&](const FinishedPoint& point) {
    return point.content.empty() && !in_memory() ? std::string() : point_file_name(point.index);
  };
  for (const FinishedPoint& point : points)
    if (!point.content.empty()) files.push_back({folder_ / name_of(point), point.content});
  if (!in_memory()) {
    write_aside_and_rename(files);
    sync_folder(folder_ / points_name);
  }
  std::string lines;
  std::map<std::size_t, ManifestEntry> kept;
  for (FinishedPoint& point : points) {
    ManifestEntry entry{name_of(point), checksum(point.content), std::move(point.row),
                        std::move(point.others)};
    lines += entry_line(header_, point.index, entry);
    kept.insert_or_assign(point.index, std::move(entry));
  }
  if (!in_memory()) manifest_.append(lines);
  for (auto& [index, entry] : kept) finished_.insert_or_assign(index, std::move(entry));
}

void ResultFolder::discard() {
  std::error_code ignored;
  for (const char* name : {points_name, resolved_case_name, table_name, spectrum_name, manifest_name})
    fs::remove_all(folder_ / name, ignored);
  remove_leftovers(folder_);
  finished_.clear();
}

void ResultFolder::write_table() const {
  if (in_memory()) return;
  std::string text = csv_head(header_);
  for (const SweepRow& row : rows_in_table_order(header_, finished_)) text += csv_line(header_, row);
  write_aside_and_rename(folder_ / table_name, text);
  const std::vector<SpectrumResult> spectra = spectrum_results(header_, finished_);
  if (!spectra.empty()) write_aside_and_rename(folder_ / spectrum_name, spectrum_csv(header_, spectra));
  sync_folder(folder_);
}

ResultFolder open_results(const fs::path& folder, const ManifestHeader& header,
                          const std::string& resolved_case, bool resume, bool quiet) {
  if (folder.empty()) return ResultFolder(header);
  ResultFolder opened(folder, header, resolved_case, resume ? OpenMode::resume : OpenMode::fresh);
  for (const std::string& file : opened.damaged())
    if (!quiet) print_to_standard_error("{}; its point is computed again\n", file);
  return opened;
}

std::map<std::string, std::string> checksums_of(const fs::path& folder,
                                                const std::vector<std::string>& names) {
  std::map<std::string, std::string> sums;
  for (const std::string& name : names) sums[name] = checksum(read_file(folder / name));
  return sums;
}

Manifest read_results(const fs::path& folder) {
  const fs::path file = folder / manifest_name;
  std::error_code error;
  if (!fs::is_regular_file(file, error))
    throw BadInput(fmt::format("{}: no {} was found; the folder of a sweep's results is required",
                               folder.string(), manifest_name));
  Manifest manifest = parse_manifest(read_file(file), file.string());
  if (!manifest.header)
    throw BadInput(
        fmt::format("{}: holds no results yet; run its sweep with --resume first", folder.string()));
  if (!manifest.header->table.empty())
    throw BadInput(fmt::format("{}: found the points of a table; required: the results of a run or sweep",
                               folder.string()));
  return manifest;
}

std::string fault_of_case(const fs::path& folder, const ManifestHeader& header) {
  const fs::path resolved = folder / resolved_case_name;
  return checksum(read_file(resolved)) == header.case_hash
             ? ""
             : resolved.string() + ": differs from what its run wrote";
}

void require_undamaged(std::vector<std::string> faults) {
  std::erase(faults, "");
  for (std::string& fault : faults)
    fault += "; required: an undamaged result. Give its command again with --resume, or into another folder";
  if (!faults.empty()) throw BadInput(faults);
}

}  // namespace orbearing::app
