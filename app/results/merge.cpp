#include <fmt/format.h>

#include <utility>

#include "app/errors.hpp"
#include "app/results/sweep_run.hpp"

namespace orbearing::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t points_at_once = 64;

struct ShardResults {
  fs::path folder;
  Manifest manifest;
  Shard shard;  // a sweep in one piece is shard 1/1
};

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

void check_unfinished(const std::vector<ShardResults>& shards, std::vector<std::string>& messages) {
  for (const ShardResults& shard : shards)
    if (shard.manifest.entries.size() < shard.manifest.header->own_points())
      messages.push_back(fmt::format("{}: {} of {} points were found; finish it with --resume first",
                                     shard.folder.string(), shard.manifest.entries.size(),
                                     shard.manifest.header->own_points()));
}

/// Every shard once; of alike shards only.
void check_complete(const std::vector<ShardResults>& shards, std::vector<std::string>& messages) {
  std::vector<const ShardResults*> found(shards.front().shard.count, nullptr);
  for (const ShardResults& shard : shards) {
    const ShardResults*& place = found[shard.shard.index - 1];
    if (place != nullptr)
      messages.push_back(fmt::format("{}: shard {} was found, which {} holds too; each is required once",
                                     shard.folder.string(), to_string(shard.shard), place->folder.string()));
    place = &shard;
  }
  for (std::size_t i = 0; i < found.size(); ++i)
    if (found[i] == nullptr)
      messages.push_back(fmt::format("shard {} is missing; the folders of all {} shards are required",
                                     to_string(Shard{i + 1, found.size()}), found.size()));
}

void check(const std::vector<ShardResults>& shards) {
  std::vector<std::string> messages;
  check_alike(shards, messages);
  if (messages.empty()) check_complete(shards, messages);
  if (messages.empty()) check_unfinished(shards, messages);
  if (!messages.empty()) throw BadInput(messages);
}

void copy_points(const ShardResults& shard, ResultFolder& folder) {
  std::vector<FinishedPoint> points;
  for (const auto& [point, entry] : shard.manifest.entries) {
    points.push_back({point, read_file(shard.folder / entry.file), entry.row});
    if (points.size() < points_at_once) continue;
    folder.keep(std::exchange(points, {}));
  }
  folder.keep(std::move(points));
}

}  // namespace

SweepOutcome merge_shards(const std::vector<fs::path>& folders, const fs::path& folder) {
  if (folders.empty()) throw BadInput("merge: no folder was given; those of all shards are required");
  const std::vector<ShardResults> shards = read_shards(folders);
  check(shards);
  ManifestHeader header = *shards.front().manifest.header;
  header.shard.reset();
  ResultFolder merged(folder, header, read_file(folders.front() / "case.resolved.yaml"), OpenMode::fresh);
  for (const ShardResults& shard : shards) copy_points(shard, merged);
  merged.write_table();
  return outcome_of(header, merged, header.points);
}

}  // namespace orbearing::app
