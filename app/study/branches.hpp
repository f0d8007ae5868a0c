// Branches of steady states over speed: continued sweeps up and down, laid side by side.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/results/manifest.hpp"

namespace orbearing::app {

/// A dynamic sweep and the folder it stands in.
struct Branch {
  std::filesystem::path folder;
  Manifest manifest;
};

/// Throws BadInput, with every reason, unless both are dynamic sweeps of one case that differ in the
/// direction of --continue and in nothing else.
void require_two_branches(const Branch& one, const Branch& other);

/// `load_drift` (rms loads that differ by less are one state) and `runs`: `name` ("up", "down" or "own
/// start") and `points`, the rows of the sweep. Null where no sweep of `branches` is continued.
nlohmann::ordered_json branches_json(const ResolvedCase& resolved, const std::vector<Branch>& branches);

}  // namespace orbearing::app
