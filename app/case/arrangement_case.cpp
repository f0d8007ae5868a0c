#include "app/case/arrangement_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "app/case/described_case.hpp"
#include "app/case/field_table.hpp"
#include "app/case/printable.hpp"
#include "app/case/spectrum_case.hpp"
#include "gearset/drivetrain/arrangement_checks.hpp"
#include "gearset/drivetrain/power_flow.hpp"
#include "gearset/planet_pair.hpp"
#include "gearset/stepped_planet.hpp"

namespace orbearing::app {

namespace {

using gearset::Arrangement;
using gearset::SetMember;

constexpr std::array members{gearset::Member::sun, gearset::Member::ring, gearset::Member::carrier};

std::optional<gearset::Member> member_of(std::string_view word) {
  for (const gearset::Member member : members)
    if (word == gearset::member_word(member)) return member;
  return std::nullopt;
}

std::optional<SetMember> set_member_of(const CaseShape& shape, const std::string& text) {
  const std::size_t dot = text.find('.');
  if (dot == std::string::npos) return std::nullopt;
  const auto set = std::find(shape.sets.begin(), shape.sets.end(), text.substr(0, dot));
  const std::optional<gearset::Member> member = member_of(text.substr(dot + 1));
  if (set == shape.sets.end() || !member) return std::nullopt;
  return SetMember{static_cast<std::size_t>(set - shape.sets.begin()), *member};
}

// Puts one word of a shaft's list onto the shaft; false for a word that means nothing.
bool put(const CaseShape& shape, const std::string& text, gearset::Shaft& shaft) {
  if (text == "motor") return shaft.motor = true;
  if (text == "load") return shaft.load = true;
  if (text == "ground") return shaft.ground = true;
  const std::optional<SetMember> member = set_member_of(shape, text);
  if (member) shaft.members.push_back(*member);
  return member.has_value();
}

std::string joint_hint(const CaseShape& shape, const std::string& text) {
  std::vector<std::string> known{"motor", "load", "ground"};
  for (const std::string& set : shape.sets)
    for (const gearset::Member member : members) known.push_back(set + "." + gearset::member_word(member));
  const std::string near = nearest_word(text, known);
  return fmt::format("motor, load, ground or a member of a set, as in '{}', is required",
                     near.empty() && known.size() > 3 ? known[3] : near);
}

bool has_teeth(const ResolvedCase& resolved, const std::string& set) {
  for (const char* gear : {"sun", "planet", "ring"})
    if (!resolved.has(set_prefix(set) + "gearset.teeth." + gear)) return false;
  return true;
}

// Teeth alone, of a set at the top of a case or, by its prefix, of one of several.
gearset::PlanetarySet toothed_set(const ResolvedCase& resolved, const std::string& prefix) {
  const auto teeth = [&](const char* gear) { return resolved.integer(prefix + "gearset.teeth." + gear); };
  gearset::PlanetarySet set{
      .sun_teeth = teeth("sun"), .planet_teeth = teeth("planet"), .ring_teeth = teeth("ring")};
  if (const std::string second = prefix + "gearset.stepped_planet.teeth"; resolved.has(second))
    set.stepped.teeth = resolved.integer(second);
  return set;
}

gearset::ArrangedSet arranged_set(const ResolvedCase& resolved, const std::string& set) {
  const gearset::WillisTeeth teeth = gearset::willis_teeth(toothed_set(resolved, set_prefix(set)));
  return {set, teeth.sun, teeth.planet, teeth.ring};
}

gearset::Shaft shaft_of(const ResolvedCase& resolved, const std::string& name) {
  gearset::Shaft shaft{.name = name};
  for (const std::string& text : resolved.texts(shaft_path(name))) put(resolved.shape(), text, shaft);
  return shaft;
}

Arrangement several(const ResolvedCase& resolved) {
  Arrangement arrangement;
  for (const std::string& set : resolved.shape().sets)
    arrangement.sets.push_back(arranged_set(resolved, set));
  for (const std::string& shaft : resolved.shape().shafts)
    arrangement.shafts.push_back(shaft_of(resolved, shaft));
  return arrangement;
}

Arrangement one(const ResolvedCase& resolved) {
  gearset::PlanetarySet set = toothed_set(resolved, "");
  set.fixed_member = *member_of(resolved.choice("gearset.fixed"));
  Arrangement arrangement =
      gearset::arrangement_of(set, *member_of(resolved.choice("input.member")), "gearset");
  if (resolved.has("gearset.second_planet.teeth"))
    arrangement.sets.front().ring_teeth = gearset::willis_teeth_of_pairs(set).ring;
  return arrangement;
}

// Whether every word of every shaft is valid and unique; adds mistakes for the others.
bool check_words(CheckedCase& resolved) {
  const std::size_t before = resolved.mistakes.size();
  for (const std::string& name : resolved.shape().shafts) {
    const std::string path = shaft_path(name);
    if (!resolved.has(path)) return false;
    gearset::Shaft shaft;
    for (std::size_t i = 0; i < resolved.texts(path).size(); ++i) {
      const std::string& text = resolved.texts(path)[i];
      if (!put(resolved.shape(), text, shaft))
        resolved.mistakes.push_back(
            {resolved.item_location(path, i),
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
    location = resolved.location(prefix + "gearset.teeth.sun");
  }
  return {location, path, {problem.found, problem.required}};
}

}  // namespace

Arrangement arrangement_of(const ResolvedCase& resolved) {
  return with_parallel_stages(resolved.shape().several ? several(resolved) : one(resolved),
                              from_case<gearset::ParallelStages>(resolved));
}

namespace {

using gearset::SpeedOf;

/// Speed of the member divided by the speed of the motor. [-]  0: the member is stationary
double ratio_to_motor(const ResolvedCase& resolved, SpeedOf member) {
  const Arrangement arrangement = arrangement_of(resolved);
  const gearset::PowerFlow flow = gearset::power_flow(arrangement);
  const gearset::Speeds& speeds = flow.sets.front().speed;
  switch (member) {
    case SpeedOf::motor:
      break;
    case SpeedOf::load: {
      const auto load = std::ranges::find_if(arrangement.shafts, &gearset::Shaft::load);
      return flow.shafts.at(static_cast<std::size_t>(load - arrangement.shafts.begin())).speed;
    }
    case SpeedOf::sun:
      return speeds.sun;
    case SpeedOf::ring:
      return speeds.ring;
    case SpeedOf::carrier:
      return speeds.carrier;
    case SpeedOf::planet:
      return speeds.planet_relative;
  }
  return 1.0;
}

bool is_of_several(SpeedOf member) {
  return member == SpeedOf::motor || member == SpeedOf::load;
}

constexpr double kStill = 1e-9;  // [-]  of the motor's speed: round-off of a zero speed

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

gearset::Drive drive_of(const ResolvedCase& resolved) {
  auto drive = from_case<gearset::Drive>(resolved);
  const bool whole = resolved.shape().several || resolved.has("input.member");
  if (whole && drive.speed_of != SpeedOf::motor)
    drive.motor_ratio = 1.0 / std::abs(ratio_to_motor(resolved, drive.speed_of));
  return drive;
}

void check_speed_of(CheckedCase& resolved) {
  if (!resolved.has(kSpeedOfPath) || !resolved.mistakes.empty()) return;
  const SpeedOf member = from_case<gearset::Drive>(resolved).speed_of;
  if (member == SpeedOf::motor) return;
  const std::string& name = resolved.choice(kSpeedOfPath);
  if (resolved.shape().several && !is_of_several(member))
    return resolved.add_error_at(kSpeedOfPath, name + " of several sets", "motor or load is required");
  if (const std::string torque = stated_torque(resolved); member == SpeedOf::planet && !torque.empty())
    return resolved.add_error_at(kSpeedOfPath, "planet together with " + torque,
                                 "the speed of a shaft, whose torque it is, or input.power is required");
  if (std::abs(ratio_to_motor(resolved, member)) < kStill)
    resolved.add_error_at(kSpeedOfPath, name + ", which is stationary", "a member that rotates is required");
}

void check_arrangement(CheckedCase& resolved) {
  const CaseShape& shape = resolved.shape();
  if (!check_words(resolved) || shape.sets.empty() || shape.shafts.empty()) return;
  for (const std::string& set : shape.sets)
    if (!has_teeth(resolved, set)) return;
  const Arrangement arrangement = several(resolved);
  for (const gearset::ArrangementProblem& problem : gearset::arrangement_problems(arrangement))
    resolved.mistakes.push_back(mistake_of(resolved, arrangement, problem));
}

}  // namespace orbearing::app
