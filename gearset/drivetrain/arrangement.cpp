#include "gearset/drivetrain/arrangement.hpp"

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

std::string name_of(const Arrangement& arrangement, const SetMember& member) {
  return arrangement.sets[member.set].name + "." + member_word(member.member);
}

}  // namespace orbearing::gearset
