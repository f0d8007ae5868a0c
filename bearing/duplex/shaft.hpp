// A rigid shaft on a pair: natural frequencies, shapes and frequency response.
#pragma once

#include <array>
#include <complex>
#include <optional>
#include <vector>

#include "bearing/duplex/pair.hpp"
#include "mechanics/record.hpp"

namespace orbearing::bearing::duplex {

/// The shaft with all that moves as one with it.
struct Shaft {
  double mass = 0.0;       // [kg]
  RowLevers levers;        // [m]
  double inertia_x = 0.0;  // [kg m^2]  about its diameter x, through the mass centre
  double inertia_y = 0.0;  // [kg m^2]
};

inline void describe(described::Record& record, const Shaft& shaft) {
  using namespace described;
  record.value("mass_kg", dimension::mass, "of the shaft with all that moves as one with it", shaft.mass);
  record.value("first_lever_mm", dimension::length, "mass centre to the first row's groove centres",
               shaft.levers.first);
  record.value("second_lever_mm", dimension::length, "the same of the second row", shaft.levers.second);
  record.value("inertia_x_kg_m2", dimension::inertia, "about the diameter x", shaft.inertia_x);
  record.value("inertia_y_kg_m2", dimension::inertia, "about the diameter y", shaft.inertia_y);
}

/// A housing that is free to move too, its mass centre where the shaft's is.
struct Housing {
  double mass = 0.0;     // [kg]
  double inertia = 0.0;  // [kg m^2]  about any diameter
};

template <class Visitor>
void describe(Visitor& visit, Housing& m) {
  using namespace described;
  members(visit, m,
          input(m.mass, "housing.mass", "mass of a housing that is free to move; left out: fixed housing",
                {.dimension = dimension::mass, .range = positive(1e6)}),
          input(m.inertia, "housing.inertia", "its inertia about a diameter through its mass centre",
                {.dimension = dimension::inertia, .range = positive(1e6)}));
}

/// Inertia [kg m^2] about a diameter of a solid cylinder of `mass` [kg], `diameter` [m], `density` [kg/m^3]:
/// m (d^2/16 + l^2/12), whose length l follows from the mass.
double cylinder_inertia(double mass, double diameter, double density);

enum class ModeKind { tilt_x, tilt_y, axial_z, radial_x, radial_y };
inline constexpr std::array<ModeKind, 5> mode_kinds{ModeKind::tilt_x, ModeKind::tilt_y, ModeKind::axial_z,
                                                    ModeKind::radial_x, ModeKind::radial_y};
const char* name_of(ModeKind kind);

/// Which tilt moves the shaft in the plane of x and z.
enum class TiltPlanes {
  physical,  // that about y
  // About x: the calculated column of [FangDuplex] pairs the inertia about x with motion in x.
  literature_variant,
};

/// One natural mode: the freedom that holds most of its energy names it.
struct PairMode {
  ModeKind kind = ModeKind::tilt_x;
  double frequency = 0.0;                 // [Hz]
  Eigen::Vector<double, 5> shape;         // [m], [rad]  in the order of pair.hpp, of modal mass 1 kg
  Eigen::Vector<double, 5> energy_share;  // [-]  of each freedom
};
using PairModes = std::array<PairMode, 5>;

inline void describe(described::Record& record, const PairMode& mode) {
  using namespace described;
  const Along freedoms{"freedom", {"x", "y", "z", "tilt_in_xz", "tilt_in_yz"}};
  record
      .value("frequency_Hz", dimension::cycles, "tilt_x, tilt_y, axial_z, radial_x, radial_y", mode.frequency)
      .variable = "natural_frequency";
  record.value("kind", "degree of freedom with most of its energy", name_of(mode.kind));
  record.value("multiplicity", "modes of this frequency and kind", 1);
  record
      .array("shape", {}, "x, y, z [m], tilts in the planes of x and z, y and z [rad], of modal mass 1 kg",
             {freedoms}, mode.shape)
      .variable = "mode_shape";
  record.array("energy_share", dimension::ratio, "of each freedom", {freedoms}, mode.energy_share).variable =
      "mode_energy_share";
}

/// Modes in the order of `mode_kinds`, each kind once, of the shaft against the housing where that is free.
/// A stiffness below zero by round-off counts as none. Modes that are alike in x and y are distinguished by
/// their planes.
PairModes modes_of(const Stiffness& stiffness, const Shaft& shaft, const std::optional<Housing>& housing = {},
                   TiltPlanes planes = TiltPlanes::physical);

/// Point of the frequency response.
struct ResponsePoint {
  double position = 0.0;       // [m]  along z from the mass centre, for directions x and y
  double loss_factor = 0.005;  // [-]  eta of the structural damping: stiffness (1 + i eta)
};

template <class Visitor>
void describe(Visitor& visit, ResponsePoint& m) {
  using namespace described;
  members(visit, m,
          input(m.loss_factor, "loss_factor",
                "structural damping of the frequency response: loss factor eta of all stiffness",
                {.range = positive(1.0), .reason = "steel, by the source of the model"}),
          input(m.position, "position",
                "position of the impact and of the measured motion across the shaft, from its mass centre "
                "towards the first row",
                {.dimension = dimension::length, .range = {-1e4, 1e4}, .reason = "at the mass centre"}));
}

/// Acceleration over force [1/kg] of the shaft along x, y and z at one frequency [Hz].
std::array<std::complex<double>, 3> accelerance(const Stiffness& stiffness, const Shaft& shaft,
                                                const std::optional<Housing>& housing, TiltPlanes planes,
                                                const ResponsePoint& point, double frequency);

}  // namespace orbearing::bearing::duplex
