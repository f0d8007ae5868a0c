// What a report may compare with published numbers: the case as published, at speeds that were computed.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/results/sweep_run.hpp"
#include "app/study/validation_table.hpp"

namespace orbearing::app {

/// The one line of speeds of a sweep with several axes that plots over speed show.
struct SpeedSlice {
  ResolvedCase at;                    // the case with the other axes at that place
  std::vector<std::string> settings;  // which puts it there, as with --set
  nlohmann::ordered_json columns;     // column of the table -> value, one for each other axis; null without any
};

/// The line nearest to the case's own values; the case itself where speed is not swept or nothing else is.
SpeedSlice speed_slice(const ResolvedCase& resolved);

/// Published numbers of the shipped case of the same name. They belong to it: of a case whose inputs differ there is
/// nothing to compare, and `changed` names what differs, "input.power: 75 kW (published: 150 kW)".
struct PublishedComparison {
  std::vector<std::string> changed;
  ValidationTable table;  // rows alone, of the shipped case on the speeds of its own sweep
};
PublishedComparison published_comparison(const ResolvedCase& resolved);

/// Inputs of one case that differ from another's, in the order in which they are written; not those that choose
/// operating points: speed, sweep, load spectrum.
std::vector<std::string> changed_inputs(const ResolvedCase& resolved, const ResolvedCase& shipped);

/// Published peaks of life, each with our life at its speed: of the point of the sweep there, else computed by the
/// quasi-static model where the sweep is by it, else null. Nothing is interpolated.
/// Of a sweep over more than speed, on the line of speeds that the report shows.
nlohmann::ordered_json published_points(const std::vector<ValidationRow>& rows, const SweepOutcome& outcome,
                                        const ResolvedCase& resolved);

}  // namespace orbearing::app
