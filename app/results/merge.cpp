#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/errors.hpp"
#include "app/results/point_file.hpp"
#include "app/results/sweep_run.hpp"
#include "mechanics/cancellation.hpp"
#include "orbearing/files.hpp"
#include "orbearing/results.hpp"

namespace orbearing::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t points_at_once = 64;

struct ShardResults {
  fs::path folder;
  Manifest manifest;
  Shard shard;  // a sweep in one piece is shard 1/1
};

fs::path resolved_file(const ShardResults& shard) {
  return shard.folder / resolved_case_name;
}

std::vector<ShardResults> read_shards(const std::vector<fs::path>& folders) {
  std::vector<ShardResults> shards;
  std::vector<std::string> messages;
  for (const fs::path& folder : folders) try {
      Manifest manifest = read_results(folder);
      const Shard shard = manifest.header->shard.value_or(Shard{});
      shards.push_back({folder, std::move(manifest), shard});
    } catch (const BadInput& error) {
      messages.insert(messages.end(), error.messages.begin(), error.messages.end());
    }
  if (!messages.empty()) throw BadInput(messages);
  return shards;
}

void check_alike(const std::vector<ShardResults>& shards, std::vector<std::string>& messages) {
  const ShardResults& first = shards.front();
  for (const ShardResults& other : shards) {
    std::vector<std::string> lines = differences(*other.manifest.header, *first.manifest.header);
    if (other.shard.count != first.shard.count)
      lines.push_back(fmt::format("shard {} was found; one of {} is required", to_string(other.shard),
                                  first.shard.count));
    for (const std::string& line : lines)
      messages.push_back(fmt::format("{}: {}, as in {}", other.folder.string(), line, first.folder.string()));
  }
}

/// Rows that differ from what their sweep wrote.
void check_rows(const std::vector<ShardResults>& shards, std::vector<std::string>& messages) {
  for (const ShardResults& shard : shards)
    for (const DamagedLine& line : shard.manifest.damaged)
      messages.push_back(
          fmt::format("{}:{}:1: differs from what its sweep wrote; required: run the shard's sweep with "
                      "--resume, which computes the point again",
                      (shard.folder / manifest_name).string(), line.number));
}

void check_unfinished(const std::vector<ShardResults>& shards, std::vector<std::string>& messages) {
  for (const ShardResults& shard : shards) {
    const ManifestHeader& header = *shard.manifest.header;
    const auto found = std::count_if(shard.manifest.entries.begin(), shard.manifest.entries.end(),
                                     [&](const auto& entry) { return header.holds(entry.first); });
    if (static_cast<std::size_t>(found) < header.own_points())
      messages.push_back(fmt::format("{}: {} of {} points were found; finish it with --resume first",
                                     shard.folder.string(), found, header.own_points()));
  }
}

/// Every shard once; only of equal shards.
void check_complete(const std::vector<ShardResults>& shards, std::vector<std::string>& messages) {
  std::vector<const ShardResults*> found(shards.front().shard.count, nullptr);
  for (const ShardResults& shard : shards) {
    const ShardResults*& location = found[shard.shard.index - 1];
    if (location != nullptr)
      messages.push_back(fmt::format("{}: shard {} was found, which {} holds too; each is required once",
                                     shard.folder.string(), to_string(shard.shard),
                                     location->folder.string()));
    location = &shard;
  }
  for (std::size_t i = 0; i < found.size(); ++i)
    if (found[i] == nullptr)
      messages.push_back(fmt::format("shard {} is missing; the folders of all {} shards are required",
                                     to_string(Shard{i + 1, found.size()}), found.size()));
}

/// All that is copied later, so that nothing is written where a part is damaged.
void check_files(const std::vector<ShardResults>& shards, std::vector<std::string>& messages) {
  constexpr std::size_t most_told = 20;
  const std::string resolved = read_file(resolved_file(shards.front()));
  std::size_t faults = 0;
  for (const ShardResults& shard : shards) {
    // Equal hashes were found before; so are the texts, unless one was changed since.
    if (resolved.empty() || read_file(resolved_file(shard)) != resolved)
      messages.push_back(
          fmt::format("{}: is empty or differs from {}; the file as its sweep wrote it is "
                      "required",
                      resolved_file(shard).string(), resolved_file(shards.front()).string()));
    for (const auto& [point, entry] : shard.manifest.entries) {
      const std::string fault = fault_of_point(shard.folder, entry);
      if (!fault.empty() && ++faults <= most_told)
        messages.push_back(
            fmt::format("{}; the file as its sweep wrote it is required: run the shard's sweep with "
                        "--resume, which computes the point again",
                        fault));
    }
  }
  if (faults > most_told)
    messages.push_back(fmt::format("{} more point files are damaged or missing", faults - most_told));
}

void check(const std::vector<ShardResults>& shards) {
  std::vector<std::string> messages;
  check_rows(shards, messages);
  if (messages.empty()) check_alike(shards, messages);
  if (messages.empty()) check_complete(shards, messages);
  if (messages.empty()) check_unfinished(shards, messages);
  if (messages.empty()) check_files(shards, messages);
  if (!messages.empty()) throw BadInput(messages);
}

void copy_points(const ShardResults& shard, bool grid_only, ResultFolder& folder) {
  std::vector<FinishedPoint> points;
  for (const auto& [point, entry] : shard.manifest.entries) {
    if (grid_only && !shard.manifest.header->holds(point)) continue;
    points.push_back({point, read_file(shard.folder / entry.file), entry.row});
    if (points.size() < points_at_once) continue;
    if (stop_requested())
      throw Interrupted(folder.path().string() + ": interrupted; nothing of the merge is kept: merge again");
    folder.keep(std::exchange(points, {}));
  }
  folder.keep(std::move(points));
}

/// Folders that have to be made for `folder`, innermost first.
std::vector<fs::path> missing_folders(fs::path folder) {
  std::vector<fs::path> missing;
  std::error_code ignored;
  for (; !folder.empty() && !fs::exists(folder, ignored); folder = folder.parent_path())
    missing.push_back(folder);
  return missing;
}

SweepOutcome write_merged(const std::vector<ShardResults>& shards, const fs::path& folder, bool grid_only) {
  ManifestHeader header = *shards.front().manifest.header;
  header.shard.reset();
  if (grid_only) header.refined = false;
  const std::string resolved = read_file(resolved_file(shards.front()));
  ResultFolder merged(folder, header, resolved, OpenMode::fresh);
  try {
    for (const ShardResults& shard : shards) copy_points(shard, !header.refined, merged);
    merged.write_table();
    return outcome_of(header, merged.finished(), header.points);
  } catch (...) {
    merged.discard();
    throw;
  }
}

}  // namespace

SweepOutcome merge_shards(const std::vector<fs::path>& folders, const fs::path& folder, bool grid_only) {
  if (folders.empty()) throw BadInput("merge: found no folder; required: those of all shards");
  const std::vector<ShardResults> shards = read_shards(folders);
  check(shards);
  const std::vector<fs::path> missing = missing_folders(folder);
  const auto remove_made = [&] {
    std::error_code ignored;
    for (const fs::path& made : missing) fs::remove(made, ignored);  // if empty
  };
  try {
    return write_merged(shards, folder, grid_only);
  } catch (const WriteFailed& error) {
    remove_made();
    throw ComputationFailed(error.cause + "; nothing of the merge is kept: " + error.remedy +
                            ", then merge again");
  } catch (...) {
    remove_made();
    throw;
  }
}

}  // namespace orbearing::app
