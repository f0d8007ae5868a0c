#include "app/study/branches.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>

#include "app/errors.hpp"
#include "app/results/row_text.hpp"

namespace orbearing::app {

namespace {

using Json = nlohmann::ordered_json;

std::string name_of(const Manifest& manifest) {
  return manifest.header->continued ? to_string(*manifest.header->continued) : "own start";
}

Json rows_of(const Manifest& manifest) {
  const TableHead head = head_of(*manifest.header);
  Json rows = Json::array();
  // Points that only one of two sweeps added to their common grid have nothing beside them.
  for (const auto& [index, entry] : manifest.entries)
    if (index < manifest.header->grid()) rows.push_back(row_json(head, entry.row));
  return rows;
}

}  // namespace

void require_two_branches(const Branch& one, const Branch& other) {
  std::vector<std::string> messages;
  ManifestHeader alike = *other.manifest.header;
  alike.continued = one.manifest.header->continued;
  alike.refined = one.manifest.header->refined;
  for (const std::string& line : differences(alike, *one.manifest.header))
    messages.push_back(
        fmt::format("--with: {}: {}, as in {}", other.folder.string(), line, one.folder.string()));
  if (one.manifest.header->fidelity != "dynamic")
    messages.push_back(
        fmt::format("--with: {}: fidelity '{}' was found; dynamic is required, which alone has branches",
                    one.folder.string(), one.manifest.header->fidelity));
  if (other.manifest.header->continued == one.manifest.header->continued)
    messages.push_back(
        fmt::format("--with: {}: direction of --continue '{}' was found, as in {}; another is required",
                    other.folder.string(), name_of(other.manifest), one.folder.string()));
  if (!messages.empty()) throw BadInput(messages);
}

Json branches_json(const ResolvedCase& resolved, const std::vector<Branch>& branches) {
  if (std::none_of(branches.begin(), branches.end(),
                   [](const Branch& branch) { return branch.manifest.header->continued.has_value(); }))
    return nullptr;
  Json runs = Json::array();
  for (const Branch& branch : branches)
    runs.push_back({{"name", name_of(branch.manifest)}, {"points", rows_of(branch.manifest)}});
  return {{"load_drift", resolved.number("simulation.load_drift")}, {"runs", runs}};
}

}  // namespace orbearing::app
