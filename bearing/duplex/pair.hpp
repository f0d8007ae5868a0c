// Two like rows of balls on one shaft, each pressed by the preload.
//
//            first row                 second row          shaft: origin at its mass centre, z towards the
//          |<-- first lever --->|<-- second lever -->|     first row; x and y across
//     -----+--------------------o--------------------+---> -z
//
// The outer rings are fixed. Both rows are those of bearing/equilibrium/row_group.hpp, Eq. (1), without a
// motion of the balls where nothing else is said.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "bearing/equilibrium/row_group.hpp"
#include "mechanics/described.hpp"

namespace orbearing::bearing::duplex {

using Stiffness = Eigen::Matrix<double, 5, 5>;  // [N/m], [N/rad], [N m/m], [N m/rad]

/// Arrangement of both bearings.
enum class Arrangement {
  face_to_face,  // lines of contact meet the axis between the rows
  back_to_back,  // beyond them
  tandem,        // both rows bear loads of one direction: a load along the shaft presses them
};

constexpr described::Names<Arrangement, 3> names_of(Arrangement) {
  return {{{Arrangement::face_to_face, "face-to-face"},
           {Arrangement::back_to_back, "back-to-back"},
           {Arrangement::tandem, "tandem"}}};
}

/// Distances [m] of the planes of both rows' inner groove centres from the shaft's mass centre.
struct RowLevers {
  double first = 0.0;
  double second = 0.0;
};

/// A pair of equal bearings; `bearing` is one of them.
struct Pair {
  Bearing bearing;
  Arrangement arrangement = Arrangement::face_to_face;
  RowLevers levers;
  /// [m]  by which the inner ring of each row is pressed along its axis from where it is centred without load
  double approach = 0.0;
};

/// Axial displacement [m] of one row's inner ring under the axial load `preload` [N]. Throws
/// std::invalid_argument as BallRow does or for a negative load, mechanics::NoResult if no static equilibrium
/// is found.
double approach_under(const Bearing& bearing, double preload);

/// Both rows on the shaft.
std::vector<equilibrium::RowOnShaft> rows_of(const Pair& pair, const equilibrium::RowMotion& motion = {});

/// A pair in static equilibrium.
struct PairState {
  equilibrium::RingState ring;  // of the shaft against the outer rings; balls of the first row come first
  std::vector<Stiffness> rows;  // (rows)  in coordinates of their own, at the equilibrium of the shaft
};

/// Equilibrium of the shaft under `load` and the preload. In a tandem the preload is a load of twice its
/// approach_under along the shaft, which this function adds. Throws as RowGroup does.
PairState balance_pair(const Pair& pair, const equilibrium::RingLoad& load = {});

/// The same with a rotating shaft: balls have a centrifugal load and are held against their gyroscopic
/// moments. Rows that face each other keep the approach with which they were mounted, those of a tandem their
/// load.
equilibrium::RingState balance_pair_at_speed(const Pair& pair, const equilibrium::RowMotion& motion,
                                             const equilibrium::RingLoad& load = {});

/// Stiffness of the shaft about its mass centre from that of its rows: Eq. (1) on both sides.
Stiffness pair_stiffness(const std::vector<Stiffness>& rows, Arrangement arrangement,
                         const RowLevers& levers);

// Stiffness of a face-to-face pair by the linear formulas (9) to (14) of [FangDuplex], with the contact angle
// that the preload makes. Literature variant: the axial approach has one sign in both rows, as the source
// prints it; two rows that face each other have opposite ones. It leaves out the geometric stiffness too.

/// Preload of one row, the same at each ball.
struct PressedRow {
  double angle = 0.0;             // [rad]  contact angle under preload
  double normal_stiffness = 0.0;  // [N/m]  1.5 k delta^0.5 of one ball, Eq. (12)
  double groove_circle = 0.0;     // [m]    radius of the inner groove's centres, R_i
  double load = 0.0;              // [N]    on one ball
  Eigen::ArrayXd ball_angle;      // [rad]  (balls)
};

/// The row pressed along its axis by `approach` [m]. Throws std::invalid_argument as BallRow does.
PressedRow pressed_row(const Bearing& bearing, double approach);

/// In the coordinates of pair.hpp, about the shaft's mass centre.
Stiffness linear_stiffness(const PressedRow& row, const RowLevers& levers);

}  // namespace orbearing::bearing::duplex
