#include "app/study/missing_points.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/study/peak_refinement.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

namespace {

// Rows as a refinement takes them: the grid's in their order, then those that were added.
bool wants_more(const ManifestHeader& header, const Manifest& manifest, const Refinement& refinement) {
  std::vector<ResultRow> rows;
  for (const auto& [point, entry] : manifest.entries)
    if (point < header.grid() || point >= header.points) rows.push_back(entry.row);
  return !refinement.next(head_of(header), rows).empty();
}

}  // namespace

MissingPoints missing_points(const ResolvedCase& resolved, const Manifest& manifest) {
  const ManifestHeader& header = *manifest.header;
  SweepRequest request = sweep_request(resolved, header.fidelity);
  MissingPoints missing{.of = request.points.size()};
  for (std::size_t point = 0; point < request.points.size(); ++point) {
    if (manifest.entries.contains(point)) continue;
    const std::string& label = request.points[point].label;
    missing.labels.push_back(label.empty() ? "the operating point" : label);
  }
  if (!missing.labels.empty() || !header.refined || header.shard) return missing;
  refine_peak_of(resolved, request);
  missing.peak_unfinished = request.refinement && wants_more(header, manifest, *request.refinement);
  return missing;
}

std::string missing_text(const MissingPoints& missing, const Manifest& manifest) {
  if (missing.none()) return "";
  const std::optional<Shard>& shard = manifest.header->shard;
  if (missing.peak_unfinished)
    return "the sweep was interrupted while its peak was refined: the speed of the longest life is that of the points so "
           "far; go on with --resume";
  constexpr std::size_t most_named = 12;
  std::vector<std::string> named(missing.labels.begin(),
                                 missing.labels.begin() + static_cast<std::ptrdiff_t>(
                                                              std::min(most_named, missing.labels.size())));
  if (named.size() < missing.labels.size())
    named.push_back(fmt::format("and {} more", missing.labels.size() - named.size()));
  return fmt::format("{} of {} points of the sweep are missing{}: {}; {}", missing.labels.size(), missing.of,
                     shard ? fmt::format(" (this is shard {})", to_string(*shard)) : "", fmt::join(named, "; "),
                     shard ? "merge the shards, then report on the merged folder" : "go on with --resume");
}

nlohmann::ordered_json missing_json(const MissingPoints& missing, const Manifest& manifest) {
  if (missing.none()) return nullptr;
  const std::optional<Shard>& shard = manifest.header->shard;
  return {{"of", missing.of},
          {"found", missing.of - missing.labels.size()},
          {"shard", shard ? nlohmann::ordered_json(to_string(*shard)) : nlohmann::ordered_json(nullptr)},
          {"points", missing.labels},
          {"peak_unfinished", missing.peak_unfinished},
          {"text", missing_text(missing, manifest)}};
}

}  // namespace orbearing::app
