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

// A pair whose gear `inner` sits on the shaft that had the motor or the load, and whose other has it now.
void add_parallel_stage(const std::string& name, const std::array<int, 2>& teeth, Member inner,
                        bool Shaft::*role, Arrangement& arrangement) {
  const auto had = std::find_if(arrangement.shafts.begin(), arrangement.shafts.end(),
                                [&](const Shaft& shaft) { return shaft.*role; });
  if (had == arrangement.shafts.end()) return;  // reported by arrangement_problems
  const std::size_t set = arrangement.sets.size();
  arrangement.sets.push_back({name, teeth[0], 0, teeth[1]});
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
  if (stages.has_front()) add_parallel_stage("front", stages.front, Member::ring, &Shaft::motor, arrangement);
  if (stages.has_behind())
    add_parallel_stage("behind", stages.behind, Member::sun, &Shaft::load, arrangement);
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
