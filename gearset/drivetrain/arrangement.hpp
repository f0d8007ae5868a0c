// Several planetary sets on common shafts: their connections, and the shafts of power input and output.
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

/// Data of a set that determine speeds and torques. A parallel stage is one whose carrier is the housing, its
/// first gear the sun and its second the ring: z_1 w_1 + z_2 w_2 = 0.
struct ArrangedSet {
  std::string name;  // for messages
  int sun_teeth = 0;
  int planet_teeth = 0;  // of a parallel stage 0
  int ring_teeth = 0;    // negative: of planets in pairs, behind which the ring turns as the sun does

  bool is_parallel() const { return planet_teeth == 0; }
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

/// Every member is on one shaft; one shaft has the motor.
struct Arrangement {
  std::vector<ArrangedSet> sets;
  std::vector<Shaft> shafts;
};

/// The arrangement with pairs of gears between its motor and the shaft that had it, and before its load. Sets
/// and shafts that were there keep their numbers; the pairs follow in the order in which the power passes
/// them. Eq. (40) of gearset/README.md.
Arrangement with_parallel_stages(Arrangement arrangement, const ParallelStages& stages);

/// The word for a member: "sun", "ring" or "carrier".
const char* member_word(Member member);
/// Members of a parallel stage: "first", "second" or "housing".
const char* member_word(const ArrangedSet& set, Member member);

/// "reduction.sun".
std::string name_of(const Arrangement& arrangement, const SetMember& member);

// The words for what is wrong with an arrangement.

/// "a, b and c".
std::string listed(const std::vector<std::string>& words);

/// "'first' and 'second'", of shafts.
std::string shaft_names(const Arrangement& arrangement, const std::vector<std::size_t>& shafts);

/// "reduction.sun (on 'input') and reduction.ring (on 'housing')": members with their shafts.
std::string member_positions(const Arrangement& arrangement, const std::vector<SetMember>& members);

/// All members of a set.
std::vector<SetMember> members_of_set(std::size_t set);

}  // namespace orbearing::gearset
