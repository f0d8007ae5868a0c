// A pair of gears on two fixed shafts: two external ones, or a ring and the gear inside it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "gearset/contact_path.hpp"
#include "gearset/parameters.hpp"
#include "gearset/tooth_form.hpp"
#include "gearset/warning.hpp"
#include "gearset/working_geometry.hpp"

namespace orbearing::gearset {

/// Two gears with their teeth outside.
struct ExternalPair {
  static constexpr std::string_view name = "external";
  std::optional<double> driven_bore{};  // [m]  diameter, of the second gear; none: as the first
};

template <class Visitor>
void describe(Visitor& visit, ExternalPair& m) {
  using namespace described;
  members(visit, m,
          input(m.driven_bore, "driven_bore", "bore of the second gear, which is driven; pair.bore if absent",
                {.dimension = dimension::length, .range = positive(1e5)}));
}

/// A ring around the other gear.
struct InternalPair {
  static constexpr std::string_view name = "internal";
  double ring_outside = 1.15;  // [-]  outside diameter / root diameter of the ring
};

template <class Visitor>
void describe(Visitor& visit, InternalPair& m) {
  using namespace described;
  members(visit, m,
          input(m.ring_outside, "ring_outside_ratio",
                "outside diameter of the ring, where it is held, as a multiple of its root diameter",
                {.range = {1.005, 20.0}, .reason = "a rim of some five modules"}));
}

/// Parameters of a gear pair; the first gear drives. In an internal pair the gear with more teeth is the
/// ring.
struct GearPair {
  std::array<int, 2> teeth = {0, 0};
  std::array<double, 2> shift = {0.0, 0.0};  // [module]
  double module = 0.0;                       // [m]
  double face_width = 0.0;                   // [m]
  double bore = 0.0;                         // [m]  diameter, of both gears; of the one inside a ring
  BasicRack rack;
  double helix_angle = 0.0;  // [rad]  at the reference circle; positive: the first gear is right-handed
  Web web;                   // of the softer gear
  std::variant<ExternalPair, InternalPair> kind{};

  bool is_internal() const { return std::holds_alternative<InternalPair>(kind); }
  /// [m]  of two external gears, where it has a bore of its own
  std::optional<double> driven_bore() const {
    return is_internal() ? std::nullopt : std::get<ExternalPair>(kind).driven_bore;
  }
  /// Index of the ring; internal pairs only.
  std::size_t ring() const { return teeth[0] > teeth[1] ? 0 : 1; }
  std::size_t inside() const { return 1 - ring(); }
  /// [m]  diameter of a gear that is no ring
  double bore_of(std::size_t gear) const { return gear == 1 ? driven_bore().value_or(bore) : bore; }
};

template <class Visitor>
void describe(Visitor& visit, GearPair& m) {
  using namespace described;
  const auto length = [](double& member, std::string key, std::string meaning, double most) {
    return input(member, std::move(key), std::move(meaning),
                 {.dimension = dimension::length, .range = positive(most)});
  };
  members(
      visit, m, input(m.teeth, "teeth", "teeth of both gears, the driving one first", {.range = {5, 2000}}),
      length(m.module, "module", "normal module", 100.0),
      length(m.face_width, "face_width", "width of the teeth", 1e4),
      length(m.bore, "bore", "bore of both gears, or of the one inside a ring, held by a rigid shaft", 1e5),
      part(m.rack, [&] { describe_rack(visit, m.rack, ""); }),
      input(m.shift, "profile_shift",
            "profile shifts of both gears, in modules; that of a ring positive outward",
            {.range = {-2.0, 2.0}, .reason = "standard gears"}),
      helix_row(m.helix_angle, "", "first gear"), part(m.web, [&] { describe_web(visit, m.web, ""); }),
      choice(m.kind, "kind",
             "external: both gears have their teeth outside; internal: the one with more teeth is a "
             "ring around the other",
             {.reason = "two external gears"}));
}

/// A pair of external gears as assembled without backlash.
struct PairGeometry {
  std::array<ExternalTooth, 2> gears;
  double centre_distance = 0.0;         // [m]
  double working_pressure_angle = 0.0;  // [rad]
  ContactPath path;                     // from the tangent point on the second gear's base circle
  double contact_ratio = 0.0;           // [-]    transverse
  double base_helix_angle = 0.0;        // [rad]  positive: the first gear is right-handed
  double overlap_ratio = 0.0;           // [-]
};

/// Centre distance from the shifts by Eq. (2) of gearset/README.md.
/// @throws std::domain_error if the shifts leave no working pressure angle, or a tooth cannot be formed
PairGeometry pair_geometry(const GearPair& pair);

/// The same of an internal pair, whose shift of the ring less that of the gear inside makes the distance by
/// Eq. (3).
/// @throws std::domain_error as above, or if the gear inside has as many teeth
InternalMesh internal_mesh(const GearPair& pair);

/// The input that states the bore of a gear.
std::string bore_key(const GearPair& pair, std::size_t gear);

/// Reasons why the pair cannot be built; empty if it can. Places are "pair.teeth" and so on.
Warnings pair_problems(const GearPair& pair);

/// Faults of a pair that can still run.
Warnings pair_warnings(const PairGeometry& geometry);
Warnings pair_warnings(const InternalMesh& mesh);

}  // namespace orbearing::gearset
