#include "app/case/arrangement_case.hpp"

#include <fmt/format.h>

#include <string>

#include "app/case/drivetrain_reader.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/spectrum_case.hpp"
#include "coupling/analysis/set_problems.hpp"
#include "gearset/drivetrain/arrangement_checks.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

using gearset::Arrangement;

std::string joint_hint(const CaseShape& shape, const std::string& text) {
  std::vector<std::string> known{"motor", "load", "ground"};
  for (const std::string& set : shape.sets)
    for (const auto& [member, word] : names_of(gearset::Member{}))
      known.push_back(set + "." + std::string(word));
  const std::string near = nearest_word(text, known);
  return fmt::format("motor, load, ground or a member of a set, as in '{}', is required",
                     near.empty() && known.size() > 3 ? known[3] : near);
}

bool has_teeth(const ResolvedCase& resolved, const std::string& set) {
  for (const char* gear : {"sun", "planet", "ring"})
    if (!resolved.has(set_prefix(set) + "gearset.teeth." + gear)) return false;
  return true;
}

// Whether every word of every shaft is valid and unique; adds mistakes for the others.
bool check_words(CheckedCase& resolved) {
  const std::size_t before = resolved.mistakes.size();
  for (const std::string& name : resolved.shape().shafts) {
    const std::string path = shaft_path(name);
    if (!resolved.has(path)) return false;
    for (const std::size_t i : shaft_of(resolved, name).unknown) {
      const std::string& text = resolved.texts(path)[i];
      resolved.mistakes.push_back({resolved.item_location(path, i),
                                   path,
                                   {quote(text) + " cannot be joined", joint_hint(resolved.shape(), text)}});
    }
  }
  return resolved.mistakes.size() == before;
}

// Location of the problem for the message: its first shaft, else a member that is on none, else the shafts.
Mistake mistake_of(const ResolvedCase& resolved, const Arrangement& arrangement,
                   const gearset::ArrangementProblem& problem) {
  if (!problem.shafts.empty()) {
    const std::string path = shaft_path(arrangement.shafts[problem.shafts.front()].name);
    return {resolved.location(path), path, {problem.found, problem.required}};
  }
  std::string path = "shafts";
  Location location = resolved.location(shaft_path(resolved.shape().shafts.front()));
  if (!problem.members.empty()) {
    const std::string prefix = set_prefix(arrangement.sets[problem.members.front().set].name);
    path = prefix.substr(0, prefix.size() - 1);
    location = resolved.location(prefix + keys().sun_teeth);
  }
  return {location, path, {problem.found, problem.required}};
}

// Path of the input that states the torque of the shaft whose speed is input.speed; empty: no input does.
std::string stated_torque(const ResolvedCase& in) {
  for (const std::string* path : {&kTorquePath, &kTorqueCurvePath})
    if (is_stated(in, *path)) return *path;
  if (!in.has(kSpectrumPath)) return {};
  constexpr std::size_t torque = 1;
  const std::size_t columns = find_field(kSpectrumPath)->columns.size();
  const std::vector<double>& rows = in.list(kSpectrumPath);
  for (std::size_t i = torque; i < rows.size(); i += columns)
    if (rows[i] != 0.0) return kSpectrumPath;
  return {};
}

}  // namespace

void check_speed_of(CheckedCase& resolved) {
  if (!resolved.has(keys().speed_of) || !resolved.mistakes.empty() ||
      stated_drivetrain(resolved, Missing::left_out).drive.speed_of == gearset::SpeedOf::motor)
    return;
  for (const mechanics::Problem& problem :
       analysis::speed_problems(stated_drivetrain(resolved, Missing::left_out), stated_torque(resolved)))
    resolved.add_error(problem.key, problem.text);
}

void check_arrangement(CheckedCase& resolved) {
  const CaseShape& shape = resolved.shape();
  if (!check_words(resolved) || shape.sets.empty() || shape.shafts.empty()) return;
  for (const std::string& set : shape.sets)
    if (!has_teeth(resolved, set)) return;
  const Arrangement arrangement = arrangement_of_sets(stated_drivetrain(resolved, Missing::left_out));
  for (const gearset::ArrangementProblem& problem : gearset::arrangement_problems(arrangement))
    resolved.mistakes.push_back(mistake_of(resolved, arrangement, problem));
}

}  // namespace orbearing::app
