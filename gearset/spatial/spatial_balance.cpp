#include "gearset/spatial/spatial_balance.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <stdexcept>

#include "gearset/spatial/housing_stiffness.hpp"
#include "mechanics/linear_algebra.hpp"

namespace orbearing::gearset::spatial {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Row = Eigen::Matrix<double, 1, 6>;  // of a body's six coordinates
using Imbalance = mechanics::Imbalance<Eigen::Dynamic>;

enum Body : int { housing = -1, carrier = 0, sun = 1, first_planet = 2 };

// Displacement of a point of a body along a direction, by its coordinates.
struct Motion {
  int body = housing;
  Row row = Row::Zero();
};

// A spring along one direction between two bodies.
struct Spring {
  Motion one, other;       // deflection: one - other
  double stiffness = 0.0;  // [N/m]
};

// The flanks on one side of a mesh, cut into slices over the face width, which only press. Their approach is
// linear in the height over the middle of the face.
struct Flanks {
  Motion one, other;           // approach in the middle: one - other
  Row one_slope, other_slope;  // [1/m]  of it by the height
  double stiffness = 0.0;      // [N/m]  of a slice
  double gap = 0.0;            // [m]    of flanks that are not deflected
};

// Both sides of the meshes of a planet.
struct MeshFlanks {
  Flanks driving, back;
};

// A radial bearing with clearance.
struct RadialSpring {
  Motion one[2], other[2];
  Vector2d offset = Vector2d::Zero();  // [m]  of `other` where it is assembled
  double stiffness = 0.0;              // [N/m]
  double clearance = 0.0;              // [m]
};

// The bearings of a planet on a pin whose compliance links them; without clearance.
struct PinnedPlanet {
  std::vector<std::array<Motion, 2>> one, other;  // (bearings)  radial and tangential
  Vector2d offset = Vector2d::Zero();             // [m]  of `other` where it is assembled
};

struct Assembly {
  std::vector<Spring> springs;
  std::vector<MeshFlanks> meshes;    // per planet that of the sun, then that of the ring
  Eigen::ArrayXd height;             // [m]  (slices)  of their middles
  std::vector<RadialSpring> radial;  // rows of planets, planet by planet, then those of carrier and sun
  std::vector<PinnedPlanet> pinned;  // all planets, instead of their rows among `radial`; or none
  Eigen::MatrixXd pin_stiffness;     // [N/m]  (rows, rows)  of those, in either direction
  std::vector<Eigen::Index> seats;   // coordinates of the housing's seats: none where it is rigid
  Eigen::MatrixXd housing;           // [N/m]  (seats, seats)
  VectorXd force;                    // [N]  applied
  double lever = 1.0;                // [m]  of the rotations
  double scale = 0.0;                // [N]
};

Vector3d radial_of(double angle) {
  return {std::cos(angle), std::sin(angle), 0.0};
}
Vector3d tangential_of(double angle) {
  return {-std::sin(angle), std::cos(angle), 0.0};
}

// Displacement along `direction` of the point at `arm` from the middle of the body.
Motion motion_of(int body, const Vector3d& direction, const Vector3d& arm, double lever) {
  Motion motion{.body = body};
  motion.row << direction.transpose(), arm.cross(direction).transpose() / lever;
  return motion;
}

class Builder {
 public:
  Builder(const SpatialSet& set, const SpatialLoad& load, double angle, int slices, bool ring_moves = false)
      : set_(set),
        load_(load),
        angle_(angle),
        ring_(ring_moves ? first_planet + planets() : int{housing}),
        first_seat_(first_planet + planets() + (ring_moves ? 1 : 0)) {
    made_.lever = set.centre_distance;
    made_.force = VectorXd::Zero(6 * (first_seat_ + seats()));
    const double width = set.face_width / slices;
    made_.height = Eigen::ArrayXd::LinSpaced(slices, 0.5, slices - 0.5) * width - 0.5 * set.face_width;
    made_.scale = std::abs(load.torque) / set.centre_distance;
  }

  Assembly built() {
    for (int p = 0; p < planets(); ++p) add_meshes(p);
    put_pin_stiffness();
    for (int p = 0; p < planets(); ++p) add_pin(p);
    for (int b = 0; b < static_cast<int>(set_.carrier_bearings.size()); ++b)
      add_housing_bearing(carrier, set_.carrier_bearings[static_cast<std::size_t>(b)],
                          seats() > 0 ? first_seat_ + b : int{housing});
    add_housing_bearing(sun, {.radial_stiffness = set_.sun_radial_stiffness}, housing);
    add_sun_tilt();
    add_housing();
    add_axial(sun, housing, Vector3d::Zero(), Vector3d::Zero(), set_.sun_axial_stiffness);
    add_loads();
    return made_;
  }

 private:
  int planets() const { return static_cast<int>(set_.angles.size()); }
  // Seats of carrier bearings in an elastic housing are bodies of which the displacements count.
  int seats() const { return static_cast<int>(set_.housing_stiffness.rows()) / kSeatDirections; }

  void add_housing() {
    if (seats() == 0) return;
    for (int b = 0; b < seats(); ++b)
      for (int i = 0; i < kSeatDirections; ++i) made_.seats.push_back(6 * (first_seat_ + b) + i);
    made_.housing = housing_stiffness_at(set_.housing_stiffness, angle_);
  }

  void add_meshes(int planet) {
    const double drive = load_.torque < 0.0 ? -1.0 : 1.0;
    for (const bool inner : {true, false}) {
      const SpatialMesh& mesh = inner ? set_.sun : set_.ring;
      made_.meshes.push_back({flanks_of(planet, inner, drive, 0.0),
                              flanks_of(planet, inner, -drive, mesh.backlash * std::cos(mesh.base_helix))});
    }
  }

  // The force of a flank on the planet: against the sense in which the carrier is driven, apart from the
  // other gear, and along the axis by the helix, opposite in the two meshes. On the back flank the sense
  // is the other one.
  Flanks flanks_of(int planet, bool inner, double sense, double gap) const {
    const SpatialMesh& mesh = inner ? set_.sun : set_.ring;
    const double angle = set_.angles[static_cast<std::size_t>(planet)];
    const Vector3d outward = radial_of(angle);
    const double side = inner ? 1.0 : -1.0;
    const Vector3d transverse = -sense * std::cos(mesh.pressure_angle) * tangential_of(angle) +
                                side * std::sin(mesh.pressure_angle) * outward;
    const Vector3d normal =
        std::cos(mesh.base_helix) * transverse + side * sense * std::sin(mesh.base_helix) * Vector3d::UnitZ();
    const double radius = set_.planet_base_radius / std::cos(mesh.pressure_angle);  // working
    const Vector3d on_planet = -side * radius * outward;
    const auto moves = [&](int body, const Vector3d& arm) {
      return motion_of(body, -normal, arm, made_.lever);
    };
    Row slope = Row::Zero();
    slope.tail<3>() = Vector3d::UnitZ().cross(-normal).transpose() / made_.lever;
    return {.one = moves(first_planet + planet, on_planet),
            .other = moves(inner ? int{sun} : ring_, set_.centre_distance * outward + on_planet),
            .one_slope = slope,
            .other_slope = slope,
            .stiffness = mesh.stiffness * set_.face_width / static_cast<double>(made_.height.size()),
            .gap = gap};
  }

  // Rows and pin in series.
  void put_pin_stiffness() {
    if (set_.pin_compliance.size() == 0) return;
    Eigen::MatrixXd compliance = set_.pin_compliance;
    for (std::size_t r = 0; r < set_.planet_bearings.size(); ++r)
      compliance.diagonal()[static_cast<Eigen::Index>(r)] += 1.0 / set_.planet_bearings[r].radial_stiffness;
    made_.pin_stiffness =
        mechanics::solution(compliance, Eigen::MatrixXd::Identity(compliance.rows(), compliance.cols()));
    made_.pinned.resize(set_.angles.size());
  }

  void add_pin(int planet) {
    const double angle = set_.angles[planet];
    const Vector3d pin = set_.centre_distance * radial_of(angle);
    const int body = first_planet + planet;
    for (const PlanetBearing& bearing : set_.planet_bearings) {
      const Vector3d height = bearing.position * Vector3d::UnitZ();
      RadialSpring spring{.stiffness = bearing.radial_stiffness, .clearance = bearing.clearance};
      if (set_.pin_errors.cols() > planet) spring.offset = set_.pin_errors.col(planet);
      const Vector3d directions[2]{radial_of(angle), tangential_of(angle)};
      for (int i = 0; i < 2; ++i) {
        spring.one[i] = motion_of(body, directions[i], height, made_.lever);
        spring.other[i] = motion_of(carrier, directions[i], pin + height, made_.lever);
      }
      if (made_.pinned.empty()) {
        made_.radial.push_back(spring);
        continue;
      }
      PinnedPlanet& pinned = made_.pinned[static_cast<std::size_t>(planet)];
      pinned.one.push_back({spring.one[0], spring.one[1]});
      pinned.other.push_back({spring.other[0], spring.other[1]});
      pinned.offset = spring.offset;
    }
    add_axial(body, carrier, Vector3d::Zero(), pin, set_.planet_axial_stiffness);
  }

  void add_housing_bearing(int body, const CarrierBearing& bearing, int seat) {
    const Vector3d height = bearing.position * Vector3d::UnitZ();
    RadialSpring spring{.stiffness = bearing.radial_stiffness, .clearance = bearing.clearance};
    spring.one[0] = motion_of(body, Vector3d::UnitX(), height, made_.lever);
    spring.one[1] = motion_of(body, Vector3d::UnitY(), height, made_.lever);
    spring.other[0] = motion_of(seat, Vector3d::UnitX(), Vector3d::Zero(), made_.lever);
    spring.other[1] = motion_of(seat, Vector3d::UnitY(), Vector3d::Zero(), made_.lever);
    made_.radial.push_back(spring);
    add_axial(body, seat, height, Vector3d::Zero(), bearing.axial_stiffness);
  }

  void add_sun_tilt() {
    if (set_.sun_tilt_stiffness == 0.0) return;
    for (const Eigen::Index about : {0, 1}) {
      Motion tilt{.body = sun};
      tilt.row[3 + about] = 1.0;
      made_.springs.push_back(
          {.one = tilt, .other = {}, .stiffness = set_.sun_tilt_stiffness / (made_.lever * made_.lever)});
    }
  }

  void add_axial(int one, int other, const Vector3d& at_one, const Vector3d& at_other, double stiffness) {
    if (stiffness == 0.0) return;
    made_.springs.push_back({.one = motion_of(one, Vector3d::UnitZ(), at_one, made_.lever),
                             .other = motion_of(other, Vector3d::UnitZ(), at_other, made_.lever),
                             .stiffness = stiffness});
  }

  // From the housing's frame into the carrier's.
  Vector3d turned(const Vector3d& standing) const {
    return Eigen::AngleAxisd(-angle_, Vector3d::UnitZ()) * standing;
  }

  void add_force(int body, const Vector3d& force, const Vector3d& arm, const Vector3d& moment) {
    made_.force.segment<3>(6 * body) += force;
    made_.force.segment<3>(6 * body + 3) += (arm.cross(force) + moment) / made_.lever;
  }

  void add_loads() {
    const double down = load_.gravity * std::cos(load_.axis_tilt),
                 along = load_.gravity * std::sin(load_.axis_tilt);
    const Vector3d weight = turned({0.0, -down, -along});  // of a kilogram
    const Vector3d none = Vector3d::Zero();
    add_force(carrier, set_.carrier_mass * weight, set_.carrier_centre * Vector3d::UnitZ(),
              load_.torque * Vector3d::UnitZ());
    add_force(carrier, turned(load_.rotor.force), none, turned(load_.rotor.moment));
    add_force(sun, set_.sun_mass * weight, none, none);
    for (int p = 0; p < planets(); ++p)
      add_force(first_planet + p,
                set_.planet_mass *
                    (weight + load_.speed * load_.speed * set_.centre_distance * radial_of(set_.angles[p])),
                none, none);
    made_.scale = std::max(made_.scale, made_.force.norm());
  }

  const SpatialSet& set_;
  const SpatialLoad& load_;
  double angle_;
  int ring_;        // its body, or the housing
  int first_seat_;  // body of the first carrier bearing's seat, behind all others
  Assembly made_;
};

double moved(const Motion& motion, const VectorXd& position) {
  return motion.body == housing ? 0.0 : motion.row.dot(position.segment<6>(6 * motion.body));
}

double deflection(const Spring& spring, const VectorXd& position) {
  return moved(spring.one, position) - moved(spring.other, position);
}

// [m]  (slices)  by which flanks press into each other.
Eigen::ArrayXd compression(const Flanks& flanks, const Eigen::ArrayXd& height, const VectorXd& position) {
  const double middle = moved(flanks.one, position) - moved(flanks.other, position) - flanks.gap;
  const double slope = moved({flanks.one.body, flanks.one_slope}, position) -
                       moved({flanks.other.body, flanks.other_slope}, position);
  return (middle + slope * height).max(0.0);
}

Vector2d deflection(const RadialSpring& spring, const VectorXd& position) {
  Vector2d apart;
  for (int i = 0; i < 2; ++i)
    apart[i] = moved(spring.one[i], position) - moved(spring.other[i], position) - spring.offset[i];
  return apart;
}

// [m]  (bearings)  of the planet against its pin in direction `i`.
VectorXd deflections(const PinnedPlanet& planet, std::size_t i, const VectorXd& position) {
  VectorXd apart(static_cast<Eigen::Index>(planet.one.size()));
  for (std::size_t r = 0; r < planet.one.size(); ++r)
    apart[static_cast<Eigen::Index>(r)] =
        moved(planet.one[r][i], position) - moved(planet.other[r][i], position);
  return apart.array() - planet.offset[static_cast<Eigen::Index>(i)];
}

// Compression beyond the clearance.
double compression(const RadialSpring& spring, const Vector2d& apart) {
  return std::max(0.0, apart.norm() - spring.clearance);
}

void add_row(const Motion& one, const Motion& other, double force, VectorXd& forces) {
  if (one.body != housing) forces.segment<6>(6 * one.body) -= force * one.row.transpose();
  if (other.body != housing) forces.segment<6>(6 * other.body) += force * other.row.transpose();
}

// Stiffness between two directions of a pair of bodies.
void add_stiffness(const Motion& one, const Motion& other, const Motion& one2, const Motion& other2,
                   double stiffness, Eigen::MatrixXd& matrix) {
  const auto add = [&](const Motion& a, const Motion& b, double sign) {
    if (a.body == housing || b.body == housing) return;
    matrix.block<6, 6>(6 * a.body, 6 * b.body) += sign * stiffness * a.row.transpose() * b.row;
  };
  add(one, one2, 1.0);
  add(other, other2, 1.0);
  add(one, other2, -1.0);
  add(other, one2, -1.0);
}

void add_spring(const Spring& spring, const VectorXd& position, Imbalance& sum) {
  add_row(spring.one, spring.other, spring.stiffness * deflection(spring, position), sum.force);
  add_stiffness(spring.one, spring.other, spring.one, spring.other, spring.stiffness, sum.stiffness);
}

void add_pinned(const PinnedPlanet& planet, const Eigen::MatrixXd& stiffness, const VectorXd& position,
                Imbalance& sum) {
  for (std::size_t i = 0; i < 2; ++i) {
    const VectorXd force = stiffness * deflections(planet, i, position);
    for (std::size_t r = 0; r < planet.one.size(); ++r) {
      const auto row = static_cast<Eigen::Index>(r);
      add_row(planet.one[r][i], planet.other[r][i], force[row], sum.force);
      for (std::size_t s = 0; s < planet.one.size(); ++s)
        add_stiffness(planet.one[r][i], planet.other[r][i], planet.one[s][i], planet.other[s][i],
                      stiffness(row, static_cast<Eigen::Index>(s)), sum.stiffness);
    }
  }
}

// Stiffness of slices that press, where `pressing` is 1 and not 0.
void add_pressing(const Flanks& flanks, const Eigen::ArrayXd& height, const Eigen::ArrayXd& pressing,
                  Eigen::MatrixXd& matrix) {
  const double first = (pressing * height).sum();
  Eigen::Matrix2d moments;
  moments << pressing.sum(), first, first, (pressing * height.square()).sum();
  moments *= flanks.stiffness;
  const auto rows_of = [](const Motion& motion, const Row& slope) {
    Eigen::Matrix<double, 2, 6> rows;
    rows << motion.row, slope;
    return rows;
  };
  const Eigen::Matrix<double, 2, 6> one = rows_of(flanks.one, flanks.one_slope),
                                    other = rows_of(flanks.other, flanks.other_slope);
  const auto add = [&](int a, const auto& left, int b, const auto& right, double sign) {
    if (a != housing && b != housing)
      matrix.block<6, 6>(6 * a, 6 * b) += sign * left.transpose() * moments * right;
  };
  add(flanks.one.body, one, flanks.one.body, one, 1.0);
  add(flanks.other.body, other, flanks.other.body, other, 1.0);
  add(flanks.one.body, one, flanks.other.body, other, -1.0);
  add(flanks.other.body, other, flanks.one.body, one, -1.0);
}

void add_flanks(const Flanks& flanks, const Eigen::ArrayXd& height, const VectorXd& position,
                Imbalance& sum) {
  const Eigen::ArrayXd compressed = compression(flanks, height, position);
  if (!(compressed.maxCoeff() > 0.0)) return;
  add_row(flanks.one, flanks.other, flanks.stiffness * compressed.sum(), sum.force);
  add_row({flanks.one.body, flanks.one_slope}, {flanks.other.body, flanks.other_slope},
          flanks.stiffness * (compressed * height).sum(), sum.force);
  add_pressing(flanks, height, (compressed > 0.0).cast<double>(), sum.stiffness);
}

void add_radial(const RadialSpring& spring, const VectorXd& position, Imbalance& sum) {
  const Vector2d apart = deflection(spring, position);
  const double distance = apart.norm(), compressed = compression(spring, apart);
  // Without clearance it is a plain spring, also where its parts are concentric.
  const double across = spring.clearance == 0.0 ? spring.stiffness
                        : compressed > 0.0      ? spring.stiffness * compressed / distance
                                                : 0.0;
  if (across == 0.0) return;
  const Vector2d line = distance > 0.0 ? Vector2d(apart / distance) : Vector2d::Zero();
  Eigen::Matrix2d local = across * Eigen::Matrix2d::Identity();
  local += (spring.stiffness - across) * line * line.transpose();
  for (int i = 0; i < 2; ++i) {
    add_row(spring.one[i], spring.other[i], spring.stiffness * compressed * line[i], sum.force);
    for (int j = 0; j < 2; ++j)
      add_stiffness(spring.one[i], spring.other[i], spring.one[j], spring.other[j], local(i, j),
                    sum.stiffness);
  }
}

VectorXd seats_moved(const Assembly& assembly, const VectorXd& position) {
  return position(assembly.seats);
}

void add_housing(const Assembly& assembly, const VectorXd& position, Imbalance& sum) {
  if (assembly.seats.empty()) return;
  sum.force(assembly.seats) -= assembly.housing * seats_moved(assembly, position);
  sum.stiffness(assembly.seats, assembly.seats) += assembly.housing;
}

// Without its last coordinates, on which no force acts.
Eigen::MatrixXd condensed(const Eigen::MatrixXd& stiffness, Eigen::Index kept) {
  const Eigen::Index rest = stiffness.rows() - kept;
  if (rest == 0) return stiffness;
  const Eigen::MatrixXd across = stiffness.bottomLeftCorner(rest, kept),
                        within = stiffness.bottomRightCorner(rest, rest);
  Eigen::MatrixXd moved(rest, kept);
  for (Eigen::Index i = 0; i < kept; ++i)
    moved.col(i) = mechanics::lengths_under<Eigen::Dynamic>(across.col(i), within);
  const Eigen::MatrixXd taken = across.transpose() * moved;
  return stiffness.topLeftCorner(kept, kept) - 0.5 * (taken + taken.transpose());
}

constexpr int kHeld = 6 * sun + 5;  // the sun's rotation about its axis: its shaft bears the torque

Imbalance imbalance_of(const Assembly& assembly, const VectorXd& position) {
  Imbalance sum{.force = assembly.force,
                .stiffness = Eigen::MatrixXd::Zero(assembly.force.size(), assembly.force.size()),
                .scale = assembly.scale};
  for (const Spring& spring : assembly.springs) add_spring(spring, position, sum);
  for (const MeshFlanks& mesh : assembly.meshes)
    for (const Flanks* flanks : {&mesh.driving, &mesh.back})
      add_flanks(*flanks, assembly.height, position, sum);
  for (const RadialSpring& spring : assembly.radial) add_radial(spring, position, sum);
  for (const PinnedPlanet& planet : assembly.pinned)
    add_pinned(planet, assembly.pin_stiffness, position, sum);
  add_housing(assembly, position, sum);
  return sum;
}

Imbalance searched(const Assembly& assembly, const VectorXd& position) {
  Imbalance sum = imbalance_of(assembly, position);
  sum.force[kHeld] = 0.0;
  sum.stiffness.row(kHeld).setZero();
  sum.stiffness.col(kHeld).setZero();
  return sum;
}

void read_bearings(const Assembly& assembly, const SpatialSet& set, SpatialBalance& found) {
  const auto planets = static_cast<Eigen::Index>(set.angles.size());
  const auto rows = static_cast<Eigen::Index>(set.planet_bearings.size());
  found.bearing_radial.resize(rows, planets);
  found.bearing_tangential.resize(rows, planets);
  const auto force_of = [&](Eigen::Index i) {
    const RadialSpring& spring = assembly.radial[static_cast<std::size_t>(i)];
    const Vector2d apart = deflection(spring, found.position);
    const double compressed = compression(spring, apart);
    return compressed > 0.0 ? Vector2d(-spring.stiffness * compressed * apart.normalized())
                            : Vector2d(0.0, 0.0);
  };
  for (Eigen::Index p = 0; p < planets; ++p) {
    if (!assembly.pinned.empty()) {
      const PinnedPlanet& planet = assembly.pinned[static_cast<std::size_t>(p)];
      found.bearing_radial.col(p) = -assembly.pin_stiffness * deflections(planet, 0, found.position);
      found.bearing_tangential.col(p) = -assembly.pin_stiffness * deflections(planet, 1, found.position);
      continue;
    }
    for (Eigen::Index r = 0; r < rows; ++r) {
      const Vector2d force = force_of(p * rows + r);
      found.bearing_radial(r, p) = force[0];
      found.bearing_tangential(r, p) = force[1];
    }
  }
  const Eigen::Index in_housing = assembly.pinned.empty() ? planets * rows : 0;
  found.bearing_load =
      (found.bearing_radial.array().square() + found.bearing_tangential.array().square()).sqrt();
  found.carrier_bearing.resize(static_cast<Eigen::Index>(set.carrier_bearings.size()));
  for (Eigen::Index i = 0; i < found.carrier_bearing.size(); ++i)
    found.carrier_bearing[i] = force_of(in_housing + i).norm();
}

// The sun's meshes where `first` is 0, the ring's where it is 1.
void read_meshes(const Assembly& assembly, const VectorXd& position, std::size_t first, MeshForces& found) {
  const auto planets = static_cast<Eigen::Index>(assembly.meshes.size() / 2);
  found.force = found.back = found.face_load = Eigen::ArrayXd::Zero(planets);
  const double width =
      assembly.height.size() > 1 ? assembly.height[1] - assembly.height[0] : -2.0 * assembly.height[0];
  found.by_width.resize(assembly.height.size(), planets);
  for (Eigen::Index p = 0; p < planets; ++p) {
    const MeshFlanks& mesh = assembly.meshes[2 * static_cast<std::size_t>(p) + first];
    const auto force = [&](const Flanks& flanks) {
      return Eigen::ArrayXd(flanks.stiffness * compression(flanks, assembly.height, position));
    };
    const Eigen::ArrayXd driving = force(mesh.driving);
    found.by_width.col(p) = driving / width;
    found.force[p] = driving.sum();
    found.back[p] = force(mesh.back).sum();
    if (found.force[p] > 0.0) found.face_load[p] = driving.maxCoeff() / driving.mean();
  }
}

// Tilts of the bore's axis against the pin's: a rotation r takes an axis to (r_y, -r_x, 1).
Eigen::Matrix2Xd planet_tilts(const SpatialSet& set, const VectorXd& position, double lever) {
  Eigen::Matrix2Xd tilts(2, static_cast<Eigen::Index>(set.angles.size()));
  for (int p = 0; p < tilts.cols(); ++p) {
    const Vector3d turn =
        (position.segment<3>(6 * (first_planet + p) + 3) - position.segment<3>(6 * carrier + 3)) / lever;
    const Vector3d axis(turn.y(), -turn.x(), 0.0);
    const double angle = set.angles[static_cast<std::size_t>(p)];
    tilts.col(p) << axis.dot(radial_of(angle)), axis.dot(tangential_of(angle));
  }
  return tilts;
}

}  // namespace

mechanics::Imbalance<Eigen::Dynamic> imbalance(const SpatialSet& set, const SpatialLoad& load, double angle,
                                               int slices, const VectorXd& position) {
  return imbalance_of(Builder(set, load, angle, slices).built(), position);
}

SpatialBalance balance(const SpatialSet& set, const SpatialLoad& load, double angle, int slices,
                       const VectorXd& start) {
  const Assembly assembly = Builder(set, load, angle, slices).built();
  SpatialBalance found;
  found.position =
      start.size() == assembly.force.size() ? start : VectorXd::Zero(assembly.force.size()).eval();
  const mechanics::SearchLimits limits{.reach = 0.01 * set.centre_distance,
                                       .size = 1e-6 * set.centre_distance};
  Imbalance at;
  found.search = mechanics::find_balance<Eigen::Dynamic>(
      [&](const VectorXd& position) { return searched(assembly, position); }, limits, found.position, at);
  if (!found.search.converged)
    throw std::runtime_error(
        "the set in three dimensions finds no balance: weight, rotor or pin errors lift gears off their "
        "driving "
        "flanks or tilt a planet; required: more torque on the carrier, or wider bearings");
  read_meshes(assembly, found.position, 0, found.sun_mesh);
  read_meshes(assembly, found.position, 1, found.ring_mesh);
  found.planet_tilt = planet_tilts(set, found.position, assembly.lever);
  read_bearings(assembly, set, found);
  found.carrier_shift = found.position.segment<3>(0);
  found.carrier_tilt = found.position.segment<3>(3) / assembly.lever;
  found.sun_torque = -imbalance_of(assembly, found.position).force[kHeld] * assembly.lever;
  return found;
}

Eigen::MatrixXd closed_stiffness(const SpatialSet& set, int slices, bool ring_moves) {
  SpatialSet closed = set;
  for (CarrierBearing& bearing : closed.carrier_bearings) bearing.clearance = 0.0;
  for (PlanetBearing& bearing : closed.planet_bearings) bearing.clearance = 0.0;
  const Assembly assembly = Builder(closed, {}, 0.0, slices, ring_moves).built();
  Imbalance sum{.force = VectorXd::Zero(assembly.force.size()),
                .stiffness = Eigen::MatrixXd::Zero(assembly.force.size(), assembly.force.size())};
  const VectorXd nowhere = VectorXd::Zero(assembly.force.size());
  for (const Spring& spring : assembly.springs) add_spring(spring, nowhere, sum);
  for (const RadialSpring& spring : assembly.radial) add_radial(spring, nowhere, sum);
  for (const PinnedPlanet& planet : assembly.pinned) add_pinned(planet, assembly.pin_stiffness, nowhere, sum);
  for (const MeshFlanks& mesh : assembly.meshes)
    add_pressing(mesh.driving, assembly.height, Eigen::ArrayXd::Ones(slices), sum.stiffness);
  add_housing(assembly, nowhere, sum);
  const auto seats = static_cast<Eigen::Index>(assembly.seats.size()) / kSeatDirections;
  return condensed(sum.stiffness, sum.stiffness.rows() - 6 * seats);
}

}  // namespace orbearing::gearset::spatial
