#include "gearset/drivetrain/arrangement_problem_text.hpp"

#include <algorithm>

namespace orbearing::gearset {

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
