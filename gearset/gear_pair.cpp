#include "gearset/gear_pair.hpp"

#include <cmath>
#include <stdexcept>

#include "gearset/checks.hpp"
#include "gearset/involute.hpp"
#include "gearset/tooth_form.hpp"
#include "gearset/warning.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::gearset {

namespace {

constexpr const char* kPairShift = "pair.profile_shift";

void check_pointed(const ExternalTooth& tooth, const std::string& gear, Warnings& problems) {
  if (half_thickness_angle(tooth, tooth.tip_radius) > 0.0) return;
  problems.push_back({kPairShift, "found flanks that cross before the tip circle of the " + gear +
                                      "; a tooth with a tip is required; lower its shift or the addendum"});
}

void check_bore(const GearPair& pair, std::size_t of, const ExternalTooth& tooth, const std::string& gear,
                Warnings& problems) {
  const double bore = pair.bore_of(of);
  const double root_diameter = 2.0 * tooth.root_radius;
  constexpr double round_off = 1e-9;  // of a bore that equals the root diameter on paper
  if (bore > 0.0 && bore <= root_diameter * (1.0 + round_off)) return;
  problems.push_back({bore_key(pair, of), "found a bore of " + millimetres(bore) +
                                              "; more than zero and at most the root diameter of the " +
                                              gear + ", " + millimetres(root_diameter) + ", is required"});
}

void check_internal(const GearPair& pair, Warnings& problems) {
  if (pair.teeth[0] == pair.teeth[1]) {
    problems.push_back({"pair.teeth",
                        "found a ring with as many teeth as the gear inside it; fewer teeth of that "
                        "gear are required"});
    return;
  }
  const InternalMesh mesh = internal_mesh(pair);
  check_pointed(mesh.inside, "inner gear", problems);
  if (half_thickness_angle(mesh.ring, mesh.ring.tip_radius) <= 0.0)
    problems.push_back({kPairShift,
                        "found flanks that cross before the tip circle of the ring; a tooth with a tip "
                        "is required; raise its shift or lower the addendum"});
  check_bore(pair, pair.inside(), mesh.inside, "inner gear", problems);
  if (mesh.mesh.path.length() <= 0.0)
    problems.push_back({kPairShift, "found no path of contact; teeth that reach each other are required"});
}

void check_external(const GearPair& pair, Warnings& problems) {
  const PairGeometry geometry = pair_geometry(pair);
  check_pointed(geometry.gears[0], "first gear", problems);
  check_pointed(geometry.gears[1], "second gear", problems);
  check_bore(pair, 0, geometry.gears[0], "first gear", problems);
  if (problems.empty()) check_bore(pair, 1, geometry.gears[1], "second gear", problems);
  if (geometry.path.length() <= 0.0)
    problems.push_back({kPairShift, "found no path of contact; teeth that reach each other are required"});
}

void check_tips(const PairGeometry& g, int gear, int other, const std::string& name,
                const std::string& other_name, ToothWarnings& warnings) {
  const auto& tooth = g.gears[static_cast<std::size_t>(gear)];
  const auto& mate = g.gears[static_cast<std::size_t>(other)];
  warnings.undercut(tooth, name);
  warn_of_external_mesh(tooth, mate, g.centre_distance, g.working_pressure_angle, name, other_name, warnings);
}

}  // namespace

PairGeometry pair_geometry(const GearPair& pair) {
  PairGeometry geometry;
  for (std::size_t i = 0; i < 2; ++i)
    geometry.gears[i] =
        make_external_tooth(pair.teeth[i], pair.shift[i], pair.module, pair.rack, pair.helix_angle);
  const auto& [first, second] = geometry.gears;
  geometry.working_pressure_angle =
      angle_without_backlash(first, pair.teeth[0] + pair.teeth[1], pair.shift[0] + pair.shift[1]);
  geometry.centre_distance =
      (first.base_radius + second.base_radius) / std::cos(geometry.working_pressure_angle);
  geometry.path = external_contact_path(first, second, geometry.centre_distance);
  geometry.contact_ratio = contact_ratio(geometry.path, second);
  geometry.base_helix_angle = base_helix_angle(pair.rack.pressure_angle, pair.helix_angle);
  geometry.overlap_ratio = overlap_ratio(pair.face_width, pair.module, pair.helix_angle);
  return geometry;
}

InternalMesh internal_mesh(const GearPair& pair) {
  const std::size_t ring = pair.ring(), inside = pair.inside();
  return mesh_without_backlash(
      make_ring_tooth(pair.teeth[ring], pair.shift[ring], pair.module, pair.rack, pair.helix_angle),
      make_external_tooth(pair.teeth[inside], pair.shift[inside], pair.module, pair.rack, pair.helix_angle));
}

std::string bore_key(const GearPair& pair, std::size_t gear) {
  return gear == 1 && pair.driven_bore() ? "pair.driven_bore" : "pair.bore";
}

Warnings pair_problems(const GearPair& pair) {
  Warnings problems = rack_problems(pair.rack, "pair");
  if (!problems.empty()) return problems;
  try {
    pair.is_internal() ? check_internal(pair, problems) : check_external(pair, problems);
  } catch (const std::domain_error& error) {
    problems.push_back({kPairShift, error.what()});
  }
  return problems;
}

Warnings pair_warnings(const PairGeometry& geometry) {
  ToothWarnings warnings{kPairShift, {}};
  check_tips(geometry, 0, 1, "first gear", "second gear", warnings);
  check_tips(geometry, 1, 0, "second gear", "first gear", warnings);
  warnings.contact_ratio(geometry.contact_ratio, "pair");
  return warnings.list;
}

Warnings pair_warnings(const InternalMesh& mesh) {
  ToothWarnings warnings{kPairShift, {}};
  warnings.undercut(mesh.inside, "inner gear");
  warn_of_internal_mesh(mesh, "inner gear", warnings);
  warnings.contact_ratio(mesh.mesh.contact_ratio, "pair");
  return warnings.list;
}

}  // namespace orbearing::gearset
