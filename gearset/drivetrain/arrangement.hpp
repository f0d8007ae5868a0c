// Several planetary sets on common shafts: who is joined to whom, and where power enters and leaves.
//
//      motor                                  load
//        |                                      |
//     [ sun ]     shaft      [ sun ]         [carrier]      a shaft joins members rigidly;
//     [ring ]-+   [carrier]--+[ring ]-+                     the ground holds a shaft at rest
//             |                       |
//           ground                  ground
//
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "gearset/parameters.hpp"

namespace orbearing::gearset {

/// What of a set decides speeds and torques.
struct ArrangedSet {
  std::string name;  // for messages
  int sun_teeth = 0;
  int planet_teeth = 0;
  int ring_teeth = 0;
};

/// A member of one of the sets.
struct SetMember {
  std::size_t set = 0;  // index among the sets
  Member member = Member::sun;

  bool operator==(const SetMember&) const = default;
};

/// Members that turn as one, and what acts on them from outside.
struct Shaft {
  std::string name;
  std::vector<SetMember> members;
  bool motor = false;   // power enters here
  bool load = false;    // power leaves here
  bool ground = false;  // held by the housing
};

/// Every member stands on one shaft; one shaft has the motor.
struct Arrangement {
  std::vector<ArrangedSet> sets;
  std::vector<Shaft> shafts;
};

/// The word for a member: "sun", "ring" or "carrier".
const char* member_word(Member member);

/// "reduction.sun".
std::string name_of(const Arrangement& arrangement, const SetMember& member);

}  // namespace orbearing::gearset
