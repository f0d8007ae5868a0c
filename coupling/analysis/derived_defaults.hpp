// Inputs whose defaults follow from the size and the material of adjacent parts: for each what it follows
// from, and its rule.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "bearing/design_problems.hpp"
#include "coupling/analysis/stated_drivetrain.hpp"
#include "mechanics/part_rows.hpp"

namespace orbearing::analysis {

/// A value in SI, the digits with which a case has it, and why it is assumed.
struct DerivedDefault {
  double value = 0.0;
  std::string reason;
  int digits = 6;
};
using MaybeDefault = std::optional<DerivedDefault>;  // none: what it follows from is not there

namespace defaults {

/// Defaults of a bearing with a cage follow from its sizes.
struct OfBearing {
  using Part = bearing::BearingDesign;
  template <class Visitor>
  static void inputs(Visitor& visit, Part& part) {
    describe(visit, part);
  }
};

struct PocketClearance : OfBearing {
  static constexpr std::string_view rule =
      "a fiftieth of the diameter of a roller or ball, at most half of the gap between them";
  static constexpr bool always = true;  // given in each case that has the input
  static std::string key();
  static MaybeDefault derive(const Part& bearing);
};
struct PocketStiffness : OfBearing {
  static constexpr std::string_view rule =
      "a bar between two pockets, clamped at both ends, of the common cage material nearest in density";
  static constexpr bool always = true;
  static std::string key();
  static MaybeDefault derive(const Part& bearing);
};
struct TouchDownStiffness : OfBearing {
  static constexpr std::string_view rule =
      "a fifth of the modulus of the common cage material nearest in density times the cage's width";
  static constexpr bool always = true;
  static std::string key();
  static MaybeDefault derive(const Part& bearing);
};
struct GuideLand : OfBearing {
  static constexpr std::string_view rule =
      "a clearance of 6 % of the roller or ball diameter, at most half of that to the raceway";
  static std::string key();
  static MaybeDefault derive(const Part& bearing);
};
struct PocketDamping : OfBearing {
  static constexpr std::string_view rule =
      "1 s/m of polyamide, 0.3 s/m of metals, by the common cage material nearest in density";
  static std::string key();
  static MaybeDefault derive(const Part& bearing);
};

/// Defaults of the bodies of a set follow from its teeth.
struct OfTeeth {
  using Part = StatedSet;
  template <class Visitor>
  static void inputs(Visitor& visit, Part& set) {
    gearset::PlanetarySet& teeth = set.teeth;
    mechanics::describe_only(visit, teeth, teeth.sun_teeth, teeth.planet_teeth, teeth.ring_teeth,
                             teeth.module, teeth.helix_angle, teeth.rack.pressure_angle);
    mechanics::describe_only(visit, set.gears.material, set.gears.material.youngs_modulus);
  }
};

struct SunSupport : OfTeeth {
  static constexpr std::string_view rule =
      "an overhung shaft of half the sun's diameter, 2.5 of its diameters long: proportional to size and "
      "modulus, 1e8 N/m for a sun of 111 mm in steel";
  static std::string key();
  static MaybeDefault derive(const Part& set);
};
struct RingSupport : OfTeeth {
  static constexpr std::string_view rule =
      "a ring bolted to its housing: proportional to size and modulus, 1e9 N/m for a ring of 237 mm in steel";
  static std::string key();
  static MaybeDefault derive(const Part& set);
};
struct CarrierSupport : OfTeeth {
  static constexpr std::string_view rule =
      "two bearings of the carrier: proportional to size and modulus, 5e8 N/m at a centre distance of 88.5 "
      "mm "
      "in steel";
  static std::string key();
  static MaybeDefault derive(const Part& set);
};
struct Backlash : OfTeeth {
  static constexpr std::string_view rule =
      "least backlash recommended by ISO/TR 10064-2, 2/3 (0.06 + 0.0005 a + 0.03 m_n) mm normal to the teeth";
  static std::string key();
  static MaybeDefault derive(const Part& set);
};

/// For a set in three dimensions.
struct OfTeethOnCarrier : OfTeeth {
  template <class Visitor>
  static void inputs(Visitor& visit, Part& set) {
    OfTeeth::inputs(visit, set);
    mechanics::describe_only(visit, set.carrier, set.carrier.positions);
    mechanics::describe_only(visit, set.gears.choice, set.gears.choice.sun.support_stiffness);
  }
};
struct SunTilt : OfTeethOnCarrier {
  static constexpr std::string_view rule =
      "the same shaft under a moment: E I/l, in proportion to gearset.dynamics.sun.support_stiffness";
  static std::string key();
  static MaybeDefault derive(const Part& set);
};
struct SunAxial : OfTeethOnCarrier {
  static constexpr std::string_view rule =
      "the thrust of helical teeth needs a bearing: as stiff as the shaft of the sun is radially by default";
  static std::string key();
  static MaybeDefault derive(const Part& set);
};

/// Defaults of the pin of a planet.
struct OfPin {
  using Part = StatedSet;
  template <class Visitor>
  static void inputs(Visitor& visit, Part& set) {
    PlanetaryDrivetrain& planets = set.planets;
    mechanics::describe_only(visit, planets, planets.bearing.inner.seat_diameter, planets.bearings_per_planet,
                             planets.bearing.material.youngs_modulus, planets.bearing.material.poisson_ratio,
                             planets.seats.tilt, planets.seats.ends, planets.seats.span,
                             planets.seats.diameter);
    mechanics::describe_only(visit, set.teeth, set.teeth.face_width);
    mechanics::describe_only(visit, set.gears.choice, set.gears.choice.carrier_plate_ratio);
  }
};

struct FlexpinDiameter : OfPin {
  static constexpr std::string_view rule =
      "five eighths of the bore of the inner ring, which leaves room for a sleeve";
  static std::string key();
  static MaybeDefault derive(const Part& set);
};
struct PinStiffness : OfPin {
  static constexpr std::string_view rule =
      "a solid pin that fills the bore of the inner ring, between the middles of both walls of the carrier, "
      "shared by the bearings of a planet; each of several sets has its own. Held at one end, and as a "
      "flexpin, as support.pin_ends has it where tilts are computed";
  static constexpr bool always = true;
  static std::string key();
  static MaybeDefault derive(const Part& set);
};

}  // namespace defaults

}  // namespace orbearing::analysis
