// What a folder of results lacks of its sweep: points that a shard leaves to others or that were not computed yet.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/results/manifest.hpp"

namespace orbearing::app {

struct MissingPoints {
  std::size_t of = 0;               // points of grid and spectrum of the whole sweep
  std::vector<std::string> labels;  // "input.speed = 6000 rpm", of each that is missing
  bool peak_unfinished = false;     // the grid is whole, and points that refine its peak are missing

  bool none() const { return labels.empty() && !peak_unfinished; }
};

/// Of the results of a sweep or of one point. Reads `manifest` alone, and computes nothing.
MissingPoints missing_points(const ResolvedCase& resolved, const Manifest& manifest);

/// In a sentence with what to do; empty where nothing is missing.
std::string missing_text(const MissingPoints& missing, const Manifest& manifest);

/// {of, found, shard, points, peak_unfinished, text}; null where nothing is missing.
nlohmann::ordered_json missing_json(const MissingPoints& missing, const Manifest& manifest);

}  // namespace orbearing::app
