#include "app/commands/film_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/case/resolved_writer.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/commands/lone_result.hpp"
#include "app/errors.hpp"
#include "app/results/result_folder.hpp"
#include "app/study/film_study.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

int run_film_case(const ResolvedCase& resolved, const Options& options) {
  if (options.fidelity != "quasi-static")
    throw BadInput("--fidelity: found " + options.fidelity +
                   "; required: none for the model spin-film, which is steady");
  const std::vector<std::string> unused = require_used(resolved, use::spin_film);
  const ManifestHeader header = manifest_header(resolved, "film");
  ResultFolder folder =
      open_results(options.output, header, write_resolved(resolved), options.resume, options.quiet);
  FilmStudy study = film_study(resolved);
  study.warnings.insert(study.warnings.begin(), unused.begin(), unused.end());
  if (!folder.finished().contains(0)) {
    if (!folder.path().empty()) {
      write_aside_and_rename(folder.path() / "film.csv", film_csv(study));
      for (std::size_t i = 0; i < study.points.size(); ++i) {
        const FilmPoint& point = study.points[i];
        if (point.lost()) continue;
        if (point.solution)
          write_aside_and_rename(folder.path() / fmt::format("film_map_{}.csv", i + 1),
                                 film_map_csv(*point.solution));
        if (point.line)
          write_aside_and_rename(folder.path() / fmt::format("film_line_{}.csv", i + 1),
                                 film_line_csv(*point.line));
      }
    }
    folder.keep(
        {{0, lone_result_file(header, "film of a contact", film_content(study)), lone_row(folder.head())}});
  }
  present_lone_result(lone_result_json(resolved, film_json(study), study.warnings), film_text(study),
                      options);
  const auto lost = [](const FilmPoint& point) { return point.lost(); };
  return std::any_of(study.points.begin(), study.points.end(), lost) ? 1 : 0;
}

}  // namespace orbearing::app
