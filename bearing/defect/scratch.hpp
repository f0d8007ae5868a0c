// A scratch across a race or a rolling element: by how much it takes back the approach of the races while it
// is in a contact.
#pragma once

#include <vector>

#include "bearing/contact/scratch_law.hpp"
#include "bearing/geometry.hpp"
#include "bearing/parameters.hpp"
#include "mechanics/described.hpp"

namespace orbearing::bearing {

constexpr described::Names<ScratchForm, 5> names_of(ScratchForm) {
  return {{{ScratchForm::raised_cosine, "raised-cosine"},
           {ScratchForm::half_cosine, "half-cosine"},
           {ScratchForm::edges, "edges"},
           {ScratchForm::literature_variant, "as-printed"},
           {ScratchForm::profile, "profile"}}};
}

}  // namespace orbearing::bearing

namespace orbearing::bearing::defect {

/// The scratched body.
enum class Scratched { none, outer, inner, ball, roller };

constexpr described::Names<Scratched, 5> names_of(Scratched) {
  return {{{Scratched::outer, "outer"},
           {Scratched::inner, "inner"},
           {Scratched::ball, "ball"},
           {Scratched::none, "none"},
           {Scratched::roller, "roller"}}};
}

/// Scratches that are alike, across the whole width of the track.
struct Scratch {
  Scratched race = Scratched::none;
  double width = 0.0;               // [m]    along the track
  double depth = 0.0;               // [m]    of its bottom
  double angle = 0.0;               // [rad]  of its middle when the motion begins
  std::vector<double> more_angles;  // [rad]  of further ones
  ScratchForm form = ScratchForm::raised_cosine;
  std::vector<double> profile;  // [-]    of ScratchForm::profile: depths over `depth`, even from edge to edge
  int element = 1;              // number of the scratched ball or roller, from 1
};

template <class Visitor>
void describe(Visitor& visit, Scratch& m) {
  using namespace described;
  constexpr Where scratched{"defect.race", "outer|inner|ball|roller"};
  members(
      visit, m, input(m.race, "defect.race", "scratched part: a race, one ball, one roller or none", {}),
      input(m.width, "defect.width", "width of the scratch along the track",
            {.dimension = dimension::length,
             // 1 um: an element sinks into a narrower one by less than the size of an atom.
             .range = {.least = 1e-3, .most = 100.0},
             .where = scratched}),
      input(m.depth, "defect.depth", "depth of the scratch",
            {.dimension = dimension::length, .range = positive(100.0), .where = scratched}),
      input(
          m.angle, "defect.angle",
          "angle of the middle of the scratch from the middle of the load zone when the motion begins; of a "
          "ball from its contact with the outer race",
          {.dimension = dimension::angle,
           .range = {-360.0, 360.0},
           .reason = "in the middle of the load zone",
           .where = scratched}),
      input(m.more_angles, "defect.more_angles", "angles of further scratches like the first",
            {.dimension = dimension::angle, .range = {-360.0, 360.0}, .where = scratched}),
      input(m.form, "defect.form", "form of the ball's displacement between the edges of the scratch",
            {.reason = "the published period of one width, continuous at both edges", .where = scratched}),
      input(m.profile, "defect.profile",
            "depths of a measured scratch divided by defect.depth, at equal distances from edge to edge",
            {.range = {0.0, 1.0}, .where = {"defect.form", "profile"}}),
      input(m.element, "defect.element", "number of the scratched ball or roller",
            {.range = {1, 1000},
             .reason = "the first one: all are alike",
             .where = {"defect.race", "ball|roller"}}));
}

/// By how much an element on a scratch sinks at the most where it does not touch the bottom [m], eq. 4 of
/// [ScratchVibration]: the height of its own arc over the width, more by that of the convex inner race and
/// less by that of the concave outer one. For a scratch of the element itself `race` is the one it meets.
double greatest_depth(double width, Race race, const BearingGeometry& geometry);

/// Angles of the middles of all scratches [rad].
std::vector<double> angles_of(const Scratch& scratch);

/// Throws std::invalid_argument where they have no width or no depth.
void require_sound(const Scratch& scratch);

/// Whether the scratch is one of a rolling element.
inline bool of_element(Scratched scratched) {
  return scratched == Scratched::ball || scratched == Scratched::roller;
}

/// Depth of an element on a scratch whose depths were measured at equal distances from edge to edge: as deep
/// as its own arc, relative to that of `race`, allows without cutting any measured point. The first and the
/// last depth are those of the edges and count as zero.
DefectDepthTable rolled_over(const std::vector<double>& depths, double width, Race race,
                             const BearingGeometry& geometry);

/// Law of an element that meets `race` of a bearing of this geometry on the scratch. Throws
/// std::invalid_argument for a measured scratch of less than three depths, or with one below zero.
ScratchLaw scratch_law(const Scratch& scratch, Race race, const BearingGeometry& geometry);

}  // namespace orbearing::bearing::defect
