#include "orbearing/results.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "app/case/case_file.hpp"
#include "app/commands/presentation.hpp"
#include "app/results/result_folder.hpp"
#include "app/study/analysis.hpp"
#include "app/study/crown/crown_study.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/report_data.hpp"
#include "orbearing/files.hpp"

namespace orbearing {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

bool is_sweep(const app::Manifest& manifest) {
  const std::vector<std::string>& names = app::fidelity_names();
  return std::ranges::find(names, manifest.header->fidelity) != names.end();
}

// As --json printed it, where the folder holds it.
Json printed_result(const fs::path& folder, const app::ResolvedCase& resolved) {
  if (app::holds_crown(folder)) return app::read_crown(folder).object;
  const app::Analysis* analysis = app::analysis_of(resolved);
  if (analysis == nullptr || analysis->names.json_file == nullptr) return nullptr;
  const fs::path file = folder / analysis->names.json_file;
  return fs::exists(file) ? Json::parse(read_file(file)) : Json();
}

// Options by which `sweep --resume` continues.
Json options_of(const app::ManifestHeader& header) {
  Json options{{"fidelity", header.fidelity}, {"grid_only", !header.refined}};
  if (header.continued) options["continue"] = to_string(*header.continued);
  return options;
}

Json sweep_json(const app::ResolvedCase& resolved, const app::Manifest& manifest) {
  Json object{{"fidelity", manifest.header->fidelity}};
  const app::SweepOutcome outcome = app::outcome_of(*manifest.header, manifest.entries);
  Json points = Json::array();
  for (const app::SweepRow& row : outcome.rows) points.push_back(app::row_json(outcome.header, row));
  const app::MissingPoints missing = app::missing_points(resolved, manifest);
  object["finished"] = missing.none();
  object["missing"] = app::missing_json(missing, manifest);
  object["points"] = std::move(points);
  app::Record form;
  if (missing.none())
    object["result"] = app::sweep_object(resolved, outcome, form);
  else if (!manifest.header->shard)
    object["options"] = options_of(*manifest.header);
  return object;
}

std::string text_of(const Json& object) {
  return object.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

ResultsInBrief results_in_brief(const fs::path& folder) {
  const app::Manifest manifest = app::read_results(folder);
  return {manifest.header->case_name, manifest.header->fidelity, manifest.entries.size(),
          std::max(manifest.header->own_points(), manifest.entries.size())};
}

void require_case_of_results(const fs::path& folder) {
  const fs::path file = folder / manifest_name;
  const app::Manifest manifest = app::parse_manifest(read_file(file), file.string());
  app::require_undamaged({manifest.header ? app::fault_of_case(folder, *manifest.header) : ""});
}

std::string results_json(const fs::path& folder) {
  const app::Manifest manifest = app::read_results(folder);
  app::require_undamaged({app::fault_of_case(folder, *manifest.header)});
  const app::ResolvedCase resolved =
      app::parse_case(read_file(folder / resolved_case_name), resolved_case_name);
  if (is_sweep(manifest)) return text_of(sweep_json(resolved, manifest));
  return text_of({{"fidelity", manifest.header->fidelity},
                  {"finished", !manifest.entries.empty()},
                  {"result", printed_result(folder, resolved)}});
}

}  // namespace orbearing
