// Where the search for an equilibrium starts: close enough for Newton's method to need three or four steps.
// Lengths as in EquilibriumConstants, one operating point a lane.
#pragma once

#include "bearing/contact/line_law.hpp"
#include "mechanics/packs/aligned_array.hpp"
#include "mechanics/packs/powers.hpp"

namespace orbearing::bearing::vectorised::ORBEARING_PACKS {

using namespace mechanics::ORBEARING_PACKS;

/// A roller between two passes over all of them.
struct RollerUnknown {
  Pack e_x, e_y;  // [-]  direction
  Pack inertial;  // [N]
  Pack x;         // [N^0.9]  approach of the race that feels the squeeze alone
  Pack step;      // [N^0.9]  its correction at the present displacement of the rings
  Pack slope;     // [-]      d(x)/d(A)
  Pack squeeze;   // [N]      load of that race
};

/// A vector in the plane, a lane for each operating point.
struct PlaneVector {
  Pack x{}, y{};
};

inline Pack dot(const PlaneVector& a, const PlaneVector& b) {
  return a.x * b.x + a.y * b.y;
}

/// Two rollers of each lane.
struct FacingRollers {
  Pack e_x[2], e_y[2];  // [-]
  Pack inertial[2];     // [N]
};

/// Force [N] on the outer ring, with `force` from outside, while no roller is squeezed.
inline PlaneVector unsqueezed_force(const AlignedArray<RollerUnknown>& rollers, int count,
                                    PlaneVector force) {
  for (int j = 0; j < count; ++j) {
    const Pack outward = larger(rollers[j].inertial, Pack{});
    force.x += outward * rollers[j].e_x;
    force.y += outward * rollers[j].e_y;
  }
  return force;
}

/// The two rollers that a displacement along `d` meets first.
inline FacingRollers facing(const AlignedArray<RollerUnknown>& rollers, int count, const PlaneVector& d) {
  FacingRollers found{};
  Pack most = spread(-2.0), next = most;
  for (int j = 0; j < count; ++j) {
    const RollerUnknown& roller = rollers[j];
    const Pack towards = -(d.x * roller.e_x + d.y * roller.e_y);
    const Mask first = towards > most, second = towards > next;
    const auto keep = [&](const Pack& value, Pack(&of)[2]) {
      of[1] = select(first, of[0], select(second, value, of[1]));
      of[0] = select(first, value, of[0]);
    };
    keep(roller.e_x, found.e_x);
    keep(roller.e_y, found.e_y);
    keep(roller.inertial, found.inertial);
    next = select(first, most, larger(next, towards));
    most = larger(most, towards);
  }
  return found;
}

/// Where a small force along the facing rollers' bisector holds the ring: both gaps are closed.
inline PlaneVector closed_gaps(const FacingRollers& two, double half_clearance) {
  Pack gap[2];
  for (int i = 0; i < 2; ++i)
    gap[i] = larger(half_clearance + rough_power(absolute(two.inertial[i]) + 1e-200, kLineApproachExponent),
                    Pack{});
  const Pack scale = -1.0 / (two.e_x[0] * two.e_y[1] - two.e_x[1] * two.e_y[0]);
  return {scale * (gap[0] * two.e_y[1] - gap[1] * two.e_y[0]),
          scale * (gap[1] * two.e_x[0] - gap[0] * two.e_x[1])};
}

/// Approach under the load `force` [N] beyond a gap: the load of the most loaded roller from the integral of
/// the load zone for line contacts [Harris2006], here a straight line over the zone's extent; with
/// interference from the stiffness of all rollers.
inline Pack rough_approach(const Pack& force, const Pack& gap, int count) {
  const double share = 1.0 / count;
  const Pack centred = 2.0 * rough_power(4.08 * share * force, kLineApproachExponent);
  const Pack open = larger(gap, Pack{});
  Pack approach = centred;
  for (int i = 0; i < 2; ++i) {
    const Pack extent = 0.5 * approach / (approach + open);
    const Pack zone = root(extent) * (0.4139 - 0.134 * extent);
    approach = centred * rough_power(0.2453 / larger(zone, spread(share)), kLineApproachExponent);
  }
  const Pack squeeze = larger(-0.5 * gap, spread(1e-200));
  const Pack preloaded = 3.6 * share * force / rough_power(squeeze, 1.0 / 9);
  return select(gap > 0.0, approach, smaller(preloaded, centred));
}

/// A displacement [N^0.9] of the outer ring under `load` [N] that brings the rollers under the load into
/// contact.
inline PlaneVector starting_displacement(const AlignedArray<RollerUnknown>& rollers, int count,
                                         double half_clearance, const PlaneVector& load) {
  const PlaneVector force = unsqueezed_force(rollers, count, load);
  const Pack size = root(dot(force, force));
  const Pack safe = larger(size, spread(1e-200));
  const PlaneVector d{force.x / safe, force.y / safe};
  const FacingRollers two = facing(rollers, count, d);
  const Pack gap = half_clearance + rough_power(absolute(two.inertial[0]) + 1e-200, kLineApproachExponent);
  const Pack approach = rough_approach(safe, gap, count);
  const PlaneVector closed = closed_gaps(two, half_clearance);
  return {only(size > 0.0, closed.x + approach * d.x), only(size > 0.0, closed.y + approach * d.y)};
}

}  // namespace orbearing::bearing::vectorised::ORBEARING_PACKS
