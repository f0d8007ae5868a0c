#include "gearset/rim/sector_body.hpp"

#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "mechanics/checks.hpp"
#include "mechanics/constants.hpp"
#include "mechanics/linear_algebra.hpp"

namespace orbearing::gearset::rim {

namespace {

using constants::pi;

// A point of the outline above the rim, by its angle from the middle of the tooth.
struct OutlinePoint {
  double angle = 0.0;   // [rad]
  double radius = 0.0;  // [m]
};

// Places on the lattice of half elements. The rim reaches over all columns, from -half_columns to
// half_columns; the tooth is on those between -tooth_columns and tooth_columns. Tooth and rim meet on the
// arc at which the normal of the fillet has turned halfway: its corners are wide on either side.
class Lattice {
 public:
  Lattice(const RimSection& section, const Fineness& fineness)
      : section_(section),
        fineness_(fineness),
        half_turn_(0.5 * trochoid_normal_angle(section.tooth, section.tooth.form_radius)),
        foot_(trochoid_point(section.tooth, half_turn_)) {}

  int tooth_columns() const { return 2 * fineness_.below_half_tooth; }
  int half_columns() const { return tooth_columns() + 2 * fineness_.below_half_gap; }
  int ring_rows() const { return has_ring() ? 2 * fineness_.through_ring : 0; }
  int rim_rows() const { return ring_rows() + 2 * fineness_.through_rim; }
  int rows() const { return rim_rows() + 2 * fineness_.along_tooth; }

  Eigen::Vector2d position(int column, int row) const {
    const OutlinePoint point =
        row <= rim_rows() ? in_rim(std::abs(column), row) : in_tooth(std::abs(column), row);
    const double angle = column < 0 ? -point.angle : point.angle;
    return {point.radius * std::cos(angle), point.radius * std::sin(angle)};
  }

 private:
  bool has_ring() const { return section_.seat_radius > section_.race_radius; }

  // Point at which a column leaves the rim: under the tooth, along the lower half of the fillet, along the
  // root circle.
  OutlinePoint top_of_rim(int column) const {
    if (column <= tooth_columns()) return {foot_.half_angle * column / tooth_columns(), foot_.radius};
    const double share = static_cast<double>(column - tooth_columns()) / (half_columns() - tooth_columns());
    const double end = pi / section_.tooth.teeth;
    const TrochoidPoint bottom = trochoid_point(section_.tooth, 0.0);
    const double land = std::max(end - bottom.half_angle, 0.0), fillet = bottom.half_angle - foot_.half_angle;
    const double gone = share * (land + fillet);  // angle from the foot
    if (gone >= fillet) return {std::min(foot_.half_angle + gone, end), section_.tooth.root_radius};
    const double angle = foot_.half_angle + gone;
    return {angle, section_.tooth.root_radius + fillet_height(angle)};
  }

  // The fillet falls with the angle from the middle of the tooth: by bisection on its normal.
  double fillet_height(double angle) const {
    double low = 0.0, high = half_turn_;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (trochoid_point(section_.tooth, middle).half_angle > angle ? low : high) = middle;
    }
    return trochoid_point(section_.tooth, 0.5 * (low + high)).radius - section_.tooth.root_radius;
  }

  OutlinePoint in_rim(int column, int row) const {
    const OutlinePoint top = top_of_rim(column);
    if (row < ring_rows()) {
      const double share = static_cast<double>(row) / ring_rows();
      return {top.angle, section_.race_radius + share * (section_.seat_radius - section_.race_radius)};
    }
    const double share = static_cast<double>(row - ring_rows()) / (rim_rows() - ring_rows());
    return {top.angle, section_.seat_radius + share * (top.radius - section_.seat_radius)};
  }

  OutlinePoint in_tooth(int column, int row) const {
    const double share = static_cast<double>(row - rim_rows()) / (rows() - rim_rows());
    const double radius = foot_.radius + share * (section_.tooth.tip_radius - foot_.radius);
    const double flank = std::max(half_thickness_angle(section_.tooth, radius), 1e-3 * foot_.half_angle);
    return {flank * column / tooth_columns(), radius};
  }

  const RimSection& section_;
  const Fineness& fineness_;
  double half_turn_;    // [rad]
  TrochoidPoint foot_;  // of the tooth on the rim
};

// Numbers the nodes of the lattice as elements use them.
class Numbering {
 public:
  Numbering(const Lattice& lattice, SectorMesh& mesh) : lattice_(lattice), mesh_(mesh) {}

  int operator()(int column, int row) {
    const auto [entry, is_new] = number_.try_emplace({column, row}, static_cast<int>(mesh_.node.size()));
    if (is_new) mesh_.node.push_back(lattice_.position(column, row));
    return entry->second;
  }

 private:
  const Lattice& lattice_;
  SectorMesh& mesh_;
  std::map<std::pair<int, int>, int> number_;
};

}  // namespace

Fineness operator*(int times, const Fineness& f) {
  return {times * f.below_half_tooth, times * f.below_half_gap, times * f.through_ring, times * f.through_rim,
          times * f.along_tooth};
}

SectorMesh sector_mesh(const RimSection& section, const Fineness& fineness) {
  mechanics::require(section.race_radius > 0.0 && section.race_radius <= section.seat_radius,
                     "radius of the race", section.race_radius,
                     "positive and at most that of the ring's seat");
  mechanics::require(section.seat_radius < section.tooth.root_radius, "radius of the ring's seat",
                     section.seat_radius, "less than that of the root circle");
  const Lattice lattice(section, fineness);
  SectorMesh mesh;
  Numbering node(lattice, mesh);
  // Radius grows with the row, angle with the column: (row, column) is a right-handed pair.
  const auto add = [&](int column, int row, double width) {
    mesh.element.push_back({node(column, row), node(column, row + 2), node(column + 2, row + 2),
                            node(column + 2, row), node(column, row + 1), node(column + 1, row + 2),
                            node(column + 2, row + 1), node(column + 1, row)});
    mesh.width.push_back(width);
  };
  const int all = lattice.half_columns(), tooth = lattice.tooth_columns();
  for (int row = 0; row < lattice.rim_rows(); row += 2)
    for (int column = -all; column < all; column += 2)
      add(column, row, row < lattice.ring_rows() ? section.ring_width : section.face_width);
  for (int row = lattice.rim_rows(); row < lattice.rows(); row += 2)
    for (int column = -tooth; column < tooth; column += 2) add(column, row, section.face_width);
  for (int row = 0; row <= lattice.rim_rows(); ++row) {
    mesh.first_side.push_back(node(-all, row));
    mesh.last_side.push_back(node(all, row));
  }
  for (int column = -all; column <= all; ++column) mesh.race.push_back(node(column, 0));
  for (int row = lattice.rim_rows(); row <= lattice.rows(); ++row) {
    mesh.flank[0].push_back(node(-tooth, row));
    mesh.flank[1].push_back(node(tooth, row));
  }
  return mesh;
}

namespace {

using constants::two_pi;
using Wave = std::complex<double>;
using ElementMatrix = Eigen::Matrix<double, 16, 16>;
constexpr Wave kTurn(0.0, 1.0);

struct GaussPoint {
  double position = 0.0;
  double weight = 0.0;
};

const std::array<GaussPoint, 3> kGauss{
    {{-std::sqrt(0.6), 5.0 / 9.0}, {0.0, 8.0 / 9.0}, {std::sqrt(0.6), 5.0 / 9.0}}};

// Slopes (8, 2) of the shape functions of an element of eight nodes over its own coordinates.
Eigen::Matrix<double, 8, 2> shape_slopes(double x, double y) {
  constexpr std::array<std::array<double, 2>, 8> at{
      {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
  Eigen::Matrix<double, 8, 2> slopes;
  for (int i = 0; i < 8; ++i) {
    const double a = at[static_cast<std::size_t>(i)][0], b = at[static_cast<std::size_t>(i)][1];
    if (i < 4)
      slopes.row(i) << 0.25 * a * (1 + b * y) * (2 * a * x + b * y),
          0.25 * b * (1 + a * x) * (a * x + 2 * b * y);
    else if (a == 0.0)
      slopes.row(i) << -x * (1 + b * y), 0.5 * b * (1 - x * x);
    else
      slopes.row(i) << 0.5 * a * (1 - y * y), -y * (1 + a * x);
  }
  return slopes;
}

Eigen::Matrix3d plane_strain(const mechanics::Material& material) {
  const double nu = material.poisson_ratio;
  Eigen::Matrix3d law;
  law << 1 - nu, nu, 0, nu, 1 - nu, 0, 0, 0, 0.5 - nu;
  return law * material.youngs_modulus / ((1 + nu) * (1 - 2 * nu));
}

// Stiffness of one element, by displacements along x and y.
ElementMatrix element_stiffness(const SectorMesh& mesh, std::size_t e, const Eigen::Matrix3d& law) {
  Eigen::Matrix<double, 2, 8> corners;
  for (int i = 0; i < 8; ++i)
    corners.col(i) = mesh.node[static_cast<std::size_t>(mesh.element[e][static_cast<std::size_t>(i)])];
  ElementMatrix stiffness = ElementMatrix::Zero();
  for (const GaussPoint& x : kGauss)
    for (const GaussPoint& y : kGauss) {
      const Eigen::Matrix<double, 8, 2> own = shape_slopes(x.position, y.position);
      const Eigen::Matrix2d jacobian = corners * own;  // d(position)/d(own)
      const double determinant = jacobian.determinant();
      if (!(determinant > 0.0)) throw std::domain_error("a tooth whose form cannot be cut into elements");
      const Eigen::Matrix<double, 8, 2> slopes = own * jacobian.inverse();
      Eigen::Matrix<double, 3, 16> strain = Eigen::Matrix<double, 3, 16>::Zero();
      for (int i = 0; i < 8; ++i) {
        strain(0, 2 * i) = slopes(i, 0);
        strain(1, 2 * i + 1) = slopes(i, 1);
        strain(2, 2 * i) = slopes(i, 1);
        strain(2, 2 * i + 1) = slopes(i, 0);
      }
      stiffness += x.weight * y.weight * determinant * mesh.width[e] * strain.transpose() * law * strain;
    }
  return stiffness;
}

// Columns: directions along the radius and the circumference at a node.
Eigen::Matrix2d polar_axes(const Eigen::Vector2d& node) {
  const Eigen::Vector2d outward = node.normalized();
  Eigen::Matrix2d axes;
  axes << outward.x(), -outward.y(), outward.y(), outward.x();
  return axes;
}

using Entries = std::vector<Eigen::Triplet<double>>;

// Stiffness of the whole sector, by displacements along radius and circumference of each node.
Entries sector_stiffness(const SectorMesh& mesh, const mechanics::Material& material) {
  const Eigen::Matrix3d law = plane_strain(material);
  Entries entries;
  for (std::size_t e = 0; e < mesh.element.size(); ++e) {
    const ElementMatrix stiffness = element_stiffness(mesh, e, law);
    for (std::size_t i = 0; i < 8; ++i)
      for (std::size_t j = 0; j < 8; ++j) {
        const int a = mesh.element[e][i], b = mesh.element[e][j];
        const Eigen::Matrix2d block =
            polar_axes(mesh.node[static_cast<std::size_t>(a)]).transpose() *
            stiffness.block<2, 2>(2 * static_cast<int>(i), 2 * static_cast<int>(j)) *
            polar_axes(mesh.node[static_cast<std::size_t>(b)]);
        for (int r = 0; r < 2; ++r)
          for (int c = 0; c < 2; ++c) entries.emplace_back(2 * a + r, 2 * b + c, block(r, c));
      }
  }
  return entries;
}

void append_freedoms(const std::vector<int>& nodes, std::vector<int>& freedoms) {
  for (const int node : nodes)
    for (int component = 0; component < 2; ++component) freedoms.push_back(2 * node + component);
}

// Solves a complex system as a real one of twice its size.
Eigen::MatrixXcd solved(const Eigen::MatrixXcd& matrix, const Eigen::MatrixXcd& right) {
  const Eigen::Index n = matrix.rows();
  Eigen::MatrixXd real(2 * n, 2 * n), loads(2 * n, right.cols());
  real << matrix.real(), -matrix.imag(), matrix.imag(), matrix.real();
  loads << right.real(), right.imag();
  const Eigen::MatrixXd x = mechanics::solution(real, loads);
  return x.topRows(n) + kTurn * x.bottomRows(n);
}

double angle_of(const Eigen::Vector2d& node) {
  return std::atan2(node.y(), node.x());
}

// Weights of the three nodes of a side at a position between -1 and 1.
Eigen::Vector3d side_shapes(double x) {
  return {0.5 * x * (x - 1.0), 1.0 - x * x, 0.5 * x * (x + 1.0)};
}

// The side of a chain of nodes and the position on it where `measure(node)` has the value.
struct PositionOnSide {
  std::size_t first = 0;  // its first node in the chain
  double position = 0.0;  // -1 to 1
};

PositionOnSide where_radius_is(const SectorMesh& mesh, const std::vector<int>& chain, double radius) {
  const auto radius_at = [&](std::size_t first, double position) {
    Eigen::Vector2d point = Eigen::Vector2d::Zero();
    for (int i = 0; i < 3; ++i)
      point += side_shapes(position)[i] *
               mesh.node[static_cast<std::size_t>(chain[first + static_cast<std::size_t>(i)])];
    return point.norm();
  };
  std::size_t first = 0;
  while (first + 4 < chain.size() && radius_at(first, 1.0) < radius) first += 2;
  double low = -1.0, high = 1.0;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (radius_at(first, middle) < radius ? low : high) = middle;
  }
  return {first, 0.5 * (low + high)};
}

}  // namespace

struct SectorBody::Factors {
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> inner;
};

SectorBody::SectorBody(SectorMesh mesh, const mechanics::Material& material, int sectors)
    : mesh_(std::move(mesh)), sectors_(sectors) {
  mechanics::require(sectors >= 3, "sectors of a body", sectors, "at least 3");
  append_freedoms(mesh_.first_side, kept_);
  append_freedoms(mesh_.last_side, kept_);
  append_freedoms({mesh_.race.begin() + 1, mesh_.race.end() - 1}, kept_);
  std::vector<int> position(2 * mesh_.node.size(),
                            -1);  // among the kept ones, or -1 - index among the inner ones
  for (std::size_t i = 0; i < kept_.size(); ++i)
    position[static_cast<std::size_t>(kept_[i])] = static_cast<int>(i);
  for (std::size_t i = 0; i < position.size(); ++i) {
    if (position[i] >= 0) continue;
    position[i] = -1 - static_cast<int>(inner_.size());
    inner_.push_back(static_cast<int>(i));
  }
  const auto kept = static_cast<Eigen::Index>(kept_.size()), inner = static_cast<Eigen::Index>(inner_.size());
  stiffness_ = Eigen::MatrixXd::Zero(kept, kept);
  Eigen::MatrixXd coupling = Eigen::MatrixXd::Zero(inner, kept);
  Entries within;
  for (const Eigen::Triplet<double>& entry : sector_stiffness(mesh_, material)) {
    const int row = position[static_cast<std::size_t>(entry.row())],
              column = position[static_cast<std::size_t>(entry.col())];
    if (row >= 0 && column >= 0)
      stiffness_(row, column) += entry.value();
    else if (row < 0 && column < 0)
      within.emplace_back(-1 - row, -1 - column, entry.value());
    else if (column >= 0)
      coupling(-1 - row, column) += entry.value();
  }
  Eigen::SparseMatrix<double> matrix(inner, inner);
  matrix.setFromTriplets(within.begin(), within.end());
  auto factors = std::make_shared<Factors>();
  factors->inner.compute(matrix);
  following_ = -factors->inner.solve(coupling);
  stiffness_ += coupling.transpose() * following_;
  factors_ = std::move(factors);
}

NodalLoad SectorBody::race_traction(int order, int component) const {
  NodalLoad load = NodalLoad::Zero(2 * static_cast<Eigen::Index>(mesh_.node.size()));
  for (std::size_t first = 0; first + 2 < mesh_.race.size(); first += 2) {
    const double begin = angle_of(mesh_.node[static_cast<std::size_t>(mesh_.race[first])]);
    const double end = angle_of(mesh_.node[static_cast<std::size_t>(mesh_.race[first + 2])]);
    for (const GaussPoint& gauss : kGauss) {
      const double angle = 0.5 * (begin + end) + 0.5 * gauss.position * (end - begin);
      const Wave traction = 0.5 * gauss.weight * (end - begin) * std::exp(kTurn * (order * angle));
      const Eigen::Vector3d share = side_shapes(gauss.position);
      for (int i = 0; i < 3; ++i)
        load[2 * mesh_.race[first + static_cast<std::size_t>(i)] + component] += share[i] * traction;
    }
  }
  return load;
}

NodalLoad SectorBody::race_wave(int order) const {
  return race_traction(order, 0);
}

NodalLoad SectorBody::race_shear(int order) const {
  return race_traction(order, 1);
}

NodalLoad SectorBody::flank_force(int flank, double radius, double pressure_angle) const {
  const std::vector<int>& chain = mesh_.flank.at(static_cast<std::size_t>(flank));
  const PositionOnSide at = where_radius_is(mesh_, chain, radius);
  const Eigen::Vector3d share = side_shapes(at.position);
  const Eigen::Vector2d polar(-std::sin(pressure_angle),
                              (flank == 0 ? 1.0 : -1.0) * std::cos(pressure_angle));
  std::array<Eigen::Vector2d, 3> node;
  Eigen::Vector2d contact = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    node[i] = mesh_.node[static_cast<std::size_t>(chain[at.first + i])];
    contact += share[static_cast<int>(i)] * node[i];
  }
  const Eigen::Vector2d force = polar_axes(contact) * polar;
  NodalLoad load = NodalLoad::Zero(2 * static_cast<Eigen::Index>(mesh_.node.size()));
  for (std::size_t i = 0; i < 3; ++i)
    load.segment<2>(2 * chain[at.first + i]) =
        share[static_cast<int>(i)] * polar_axes(node[i]).transpose() * force;
  return load;
}

SectorBody::Reduced SectorBody::reduced(const std::vector<NodalLoad>& loads) const {
  const auto kept = static_cast<Eigen::Index>(kept_.size()), inner = static_cast<Eigen::Index>(inner_.size());
  const auto count = static_cast<Eigen::Index>(loads.size());
  Reduced all{Eigen::MatrixXcd(kept, count), Eigen::MatrixXcd(inner, count), {}};
  for (Eigen::Index column = 0; column < count; ++column) {
    const NodalLoad& load = loads[static_cast<std::size_t>(column)];
    for (Eigen::Index i = 0; i < kept; ++i) all.kept(i, column) = load[kept_[static_cast<std::size_t>(i)]];
    for (Eigen::Index i = 0; i < inner; ++i) all.inner(i, column) = load[inner_[static_cast<std::size_t>(i)]];
  }
  const Eigen::MatrixXd real = all.inner.real(), imaginary = all.inner.imag();
  all.within = factors_->inner.solve(real) + kTurn * factors_->inner.solve(imaginary);
  all.kept += following_.transpose() * all.inner;
  return all;
}

// Weights of the average displacement that must be zero, for orders in which the body could otherwise move
// freely; empty for others.
Eigen::VectorXcd SectorBody::average(int order) const {
  const int wave = ((order % sectors_) + sectors_) % sectors_;
  if (wave == 0) return reduced({race_shear(0)}).kept;
  if (wave == 1) return reduced({race_wave(1)}).kept;
  if (wave == sectors_ - 1) return reduced({race_wave(-1)}).kept;
  return {};
}

// Displacements of the kept freedoms, for loads and displacements that continue from sector to sector.
Eigen::MatrixXcd SectorBody::displacements(int order, const Eigen::MatrixXcd& loads,
                                           RaceConstraint constraint) const {
  const bool rigid = constraint == RaceConstraint::rigidly;
  const auto cut = static_cast<Eigen::Index>(2 * mesh_.first_side.size());
  const Eigen::Index kept = loads.rows(), race = kept - 2 * cut;
  const Eigen::Index begin = rigid ? 2 : 0;  // the cut's own node on the race comes first
  const Eigen::Index free = cut - begin + (rigid ? 0 : race);
  const Wave ahead = std::exp(kTurn * (two_pi * order / sectors_));
  Eigen::MatrixXcd all = Eigen::MatrixXcd::Zero(kept, free);  // kept freedoms by the free ones
  for (Eigen::Index i = begin; i < cut; ++i) {
    all(i, i - begin) = 1.0;
    all(cut + i, i - begin) = ahead;
  }
  if (!rigid) all.bottomRightCorner(race, race).setIdentity();
  const Eigen::VectorXcd averages = rigid ? Eigen::VectorXcd() : average(order);
  const Eigen::Index conditions = averages.size() == 0 ? 0 : 1;
  Eigen::MatrixXcd matrix = Eigen::MatrixXcd::Zero(free + conditions, free + conditions);
  matrix.topLeftCorner(free, free) = all.adjoint() * (stiffness_ * all);
  Eigen::MatrixXcd right = Eigen::MatrixXcd::Zero(free + conditions, loads.cols());
  right.topRows(free) = all.adjoint() * loads;
  if (conditions == 1) {
    const double scale = stiffness_.cwiseAbs().maxCoeff();  // so that all rows are of one size
    matrix.col(free).head(free) = scale * (all.adjoint() * averages);
    matrix.row(free).head(free) = scale * (averages.adjoint() * all);
  }
  return all * solved(matrix, right).topRows(free);
}

Eigen::MatrixXcd SectorBody::works(int order, const std::vector<NodalLoad>& loads,
                                   RaceConstraint constraint) const {
  const Reduced by = reduced(loads);
  return by.inner.adjoint() * by.within + by.kept.adjoint() * displacements(order, by.kept, constraint);
}

}  // namespace orbearing::gearset::rim
