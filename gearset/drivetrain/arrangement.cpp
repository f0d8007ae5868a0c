#include "gearset/drivetrain/arrangement.hpp"

#include <algorithm>

namespace orbearing::gearset {

const char* member_word(Member member) {
  switch (member) {
    case Member::sun:
      return "sun";
    case Member::ring:
      return "ring";
    case Member::carrier:
      break;
  }
  return "carrier";
}

const char* member_word(const ArrangedSet& set, Member member) {
  if (!set.is_parallel()) return member_word(member);
  return member == Member::sun ? "first" : member == Member::ring ? "second" : "housing";
}

std::string name_of(const Arrangement& arrangement, const SetMember& member) {
  const ArrangedSet& set = arrangement.sets[member.set];
  return set.name + "." + member_word(set, member.member);
}

namespace {

constexpr StageTeeth kNoStage{1, 1};

// "front", or "front_1" where there are several.
void add_stage_sets(const std::string& side, const std::vector<StageTeeth>& stages,
                    Arrangement& arrangement) {
  for (std::size_t i = 0; i < stages.size(); ++i)
    if (stages[i] != kNoStage)
      arrangement.sets.push_back(
          {stages.size() == 1 ? side : side + "_" + std::to_string(i + 1), stages[i][0], 0, stages[i][1]});
}

// Adds a gear pair: the gear `inner` joins the shaft that had the motor or the load; the motor or the load
// moves to the shaft of its mate.
void join_stage(std::size_t set, Member inner, bool Shaft::*role, Arrangement& arrangement) {
  const auto had = std::find_if(arrangement.shafts.begin(), arrangement.shafts.end(),
                                [&](const Shaft& shaft) { return shaft.*role; });
  if (had == arrangement.shafts.end()) return;  // reported by arrangement_problems
  const std::string name = arrangement.sets[set].name;
  (*had).*role = false;
  had->members.push_back({set, inner});
  Shaft outer{.name = name, .members = {{set, inner == Member::sun ? Member::ring : Member::sun}}};
  outer.*role = true;
  arrangement.shafts.push_back(outer);
  arrangement.shafts.push_back(
      {.name = "housing of " + name, .members = {{set, Member::carrier}}, .ground = true});
}

}  // namespace

Arrangement with_parallel_stages(Arrangement arrangement, const ParallelStages& stages) {
  const std::size_t front = arrangement.sets.size();
  add_stage_sets("front", stages.front, arrangement);
  const std::size_t behind = arrangement.sets.size();
  add_stage_sets("behind", stages.behind, arrangement);
  // From the planetary sets outward: each finds the motor or the load on the shaft that it joins.
  for (std::size_t set = behind; set > front; --set)
    join_stage(set - 1, Member::ring, &Shaft::motor, arrangement);
  for (std::size_t set = behind; set < arrangement.sets.size(); ++set)
    join_stage(set, Member::sun, &Shaft::load, arrangement);
  return arrangement;
}

namespace {

std::string quoted(const std::string& name) {
  return "'" + name + "'";
}

std::string position_of(const Arrangement& arrangement, const SetMember& member) {
  for (const Shaft& shaft : arrangement.shafts)
    if (std::find(shaft.members.begin(), shaft.members.end(), member) != shaft.members.end())
      return "on " + quoted(shaft.name);
  return "on no shaft";
}

}  // namespace

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " and " : ", ";
    text += words[i];
  }
  return text;
}

std::string shaft_names(const Arrangement& arrangement, const std::vector<std::size_t>& shafts) {
  std::vector<std::string> names;
  for (const std::size_t shaft : shafts) names.push_back(quoted(arrangement.shafts[shaft].name));
  return listed(names);
}

std::string member_positions(const Arrangement& arrangement, const std::vector<SetMember>& members) {
  std::vector<std::string> names;
  for (const SetMember& member : members)
    names.push_back(name_of(arrangement, member) + " (" + position_of(arrangement, member) + ")");
  return listed(names);
}

std::vector<SetMember> members_of_set(std::size_t set) {
  return {{set, Member::sun}, {set, Member::ring}, {set, Member::carrier}};
}

}  // namespace orbearing::gearset
