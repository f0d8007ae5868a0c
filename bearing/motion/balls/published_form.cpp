#include "bearing/motion/balls/published_form.hpp"

#include <cmath>
#include <stdexcept>

#include "mechanics/checks.hpp"

namespace orbearing::bearing::balls {

namespace {

constexpr double kShift = 1e-9;     // [m]    of a position, for the slopes
constexpr double kBalanced = 1e-3;  // [N]    of loads of hundreds: some 1e-10 m
constexpr double kSlow = 0.3;       // [-]    of a step of the search: slopes are renewed
constexpr double kUntouched = 1e3;  // [N/m]  more than its inertia slopes, less than any contact does
constexpr int kMostSteps = 60;
constexpr int kMostHalves = 12;
constexpr double kLongest = 2e-5;  // [m]    of a step

BallNumbers without_friction(BallNumbers c) {
  c.shear.law = TractionLaw::regularised_coulomb;
  c.shear.friction = 0.0;
  c.inner.rolling_factor = c.outer.rolling_factor = 0.0;
  return c;
}

}  // namespace

PublishedForm::PublishedForm(BallBearing& bearing)
    : bearing_(bearing),
      smooth_(without_friction(bearing.numbers()), bearing.duty()),
      balls_(bearing.layout().balls) {
  const StateLayout& layout = bearing.layout();
  const BallNumbers& c = bearing.numbers();
  const bool inner = c.inner_ring.mass > 0.0, outer = c.outer_ring.mass > 0.0;
  mechanics::require(!(inner && outer), "free rings", 2, "at most one in the form without inertia");
  if (inner) ring_ = layout.inner();
  if (outer) ring_ = layout.outer();
  x_.assign(static_cast<std::size_t>(layout.size()), 0.0);
  rate_ = x_;
  const Eigen::Index positions = 2 * balls_ + (ring_ >= 0 ? kRingUnknowns : 0);
  inertia_ = Eigen::VectorXd::Constant(positions, c.mass);
  const BodyNumbers& body = outer ? c.outer_ring : c.inner_ring;
  for (Eigen::Index i = 2 * balls_; i < positions; ++i)
    inertia_[i] = i < 2 * balls_ + 3 ? body.mass : body.across / c.pitch_radius;
}

// Balls' radii, their axial positions, then the ring's: by so many metres, of a tilt at the pitch circle.
void PublishedForm::move(Eigen::Index i, double by) {
  const int lanes = bearing_.layout().lanes();
  const auto at = [&](Eigen::Index index) -> double& { return x_[static_cast<std::size_t>(index)]; };
  if (i < balls_)
    at(i) += by;
  else if (i < 2 * balls_)
    at(2 * lanes + i - balls_) += by;
  else
    at(ring_ + i - 2 * balls_) += i < 2 * balls_ + 3 ? by : by / bearing_.numbers().pitch_radius;
}

Eigen::VectorXd PublishedForm::unbalanced(double time) {
  const int lanes = bearing_.layout().lanes();
  smooth_.derivative(time, x_.data(), rate_.data());
  Eigen::VectorXd force(inertia_.size());
  for (int j = 0; j < balls_; ++j) {
    force[j] = rate_[static_cast<std::size_t>(3 * lanes + j)];
    force[balls_ + j] = rate_[static_cast<std::size_t>(5 * lanes + j)];
  }
  for (Eigen::Index i = 2 * balls_; i < force.size(); ++i)
    force[i] = rate_[static_cast<std::size_t>(ring_ + kRingUnknowns + i - 2 * balls_)];
  return force.cwiseProduct(inertia_);
}

void PublishedForm::differentiate(double time) {
  const Eigen::Index n = inertia_.size();
  Eigen::MatrixXd slope(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    move(i, kShift);
    const Eigen::VectorXd above = unbalanced(time);
    move(i, -2.0 * kShift);
    slope.col(i) = (above - unbalanced(time)) / (2.0 * kShift);
    move(i, kShift);
    // A ball that touches nothing goes where its inertia takes it.
    if (i < 2 * balls_) slope(i, i) -= kUntouched;
  }
  slope_.compute(slope);
  differentiated_ = true;
}

const std::vector<double>& PublishedForm::complete(double time, const double* y) {
  const StateLayout& layout = bearing_.layout();
  const int lanes = layout.lanes();
  for (int j = 0; j < balls_; ++j) {
    x_[static_cast<std::size_t>(lanes + j)] = y[j];
    x_[static_cast<std::size_t>(4 * lanes + j)] = y[balls_ + j];
    for (int i = 0; i < 3; ++i) x_[static_cast<std::size_t>((6 + i) * lanes + j)] = y[(2 + i) * balls_ + j];
  }
  const double* cage = y + 5 * balls_;
  const auto at_cage = [&](int i) -> double& { return x_[static_cast<std::size_t>(layout.cage() + i)]; };
  for (int i = 0; i < 3; ++i) {
    at_cage(i) = cage[i];
    at_cage(kCageUnknowns + i) = cage[4 + i];
  }
  at_cage(5) = cage[3];
  at_cage(kCageUnknowns + 5) = cage[7];
  if (!differentiated_) differentiate(time);
  Eigen::VectorXd force = unbalanced(time);
  for (int step = 0; force.cwiseAbs().maxCoeff() > kBalanced; ++step) {
    if (!(step < kMostSteps)) throw std::runtime_error("balls and rings find no static equilibrium");
    const double left = force.norm();
    Eigen::VectorXd change = -slope_.solve(force);
    const double longest = change.cwiseAbs().maxCoeff();
    if (longest > kLongest) change *= kLongest / longest;
    double now = INFINITY;
    // Contacts that open or close on the way: half the way, as long as it leads away.
    for (int half = 0; half < kMostHalves; ++half) {
      for (Eigen::Index i = 0; i < change.size(); ++i) move(i, change[i]);
      force = unbalanced(time);
      now = force.norm();
      if (now < left) break;
      for (Eigen::Index i = 0; i < change.size(); ++i) move(i, -change[i]);
      change *= 0.5;
    }
    if (!(now < kSlow * left)) {
      differentiate(time);
      force = unbalanced(time);
    }
  }
  return x_;
}

std::vector<double> PublishedForm::reduced(const std::vector<double>& complete) {
  const StateLayout& layout = bearing_.layout();
  const int lanes = layout.lanes();
  std::vector<double> y(static_cast<std::size_t>(size()), 0.0);
  const auto from = [&](int i) { return complete[static_cast<std::size_t>(i)]; };
  for (int j = 0; j < balls_; ++j) {
    const auto put = [&](int group, double value) {
      y[static_cast<std::size_t>(group * balls_ + j)] = value;
    };
    put(0, from(lanes + j));
    put(1, from(4 * lanes + j));
    for (int i = 0; i < 3; ++i) put(2 + i, from((6 + i) * lanes + j));
  }
  const auto cage = static_cast<std::size_t>(5 * balls_);
  for (int i = 0; i < 3; ++i) {
    y[cage + static_cast<std::size_t>(i)] = from(layout.cage() + i);
    y[cage + 4 + static_cast<std::size_t>(i)] = from(layout.cage() + kCageUnknowns + i);
  }
  y[cage + 3] = from(layout.cage() + 5);
  y[cage + 7] = from(layout.cage() + 2 * kCageUnknowns - 1);
  x_ = complete;
  // Places have no velocity here, and the cage does not lean.
  for (int j = 0; j < lanes; ++j)
    x_[static_cast<std::size_t>(3 * lanes + j)] = x_[static_cast<std::size_t>(5 * lanes + j)] = 0.0;
  for (const int ring : {layout.inner(), layout.outer()})
    for (int i = 0; i < kRingUnknowns; ++i) x_[static_cast<std::size_t>(ring + kRingUnknowns + i)] = 0.0;
  for (const int i : {3, 4})
    x_[static_cast<std::size_t>(layout.cage() + i)] =
        x_[static_cast<std::size_t>(layout.cage() + kCageUnknowns + i)] = 0.0;
  differentiated_ = false;
  return y;
}

void PublishedForm::derivative(double time, const double* y, double* dy) {
  const StateLayout& layout = bearing_.layout();
  const int lanes = layout.lanes();
  complete(time, y);
  bearing_.derivative(time, x_.data(), rate_.data());
  const auto rate = [&](int i) { return rate_[static_cast<std::size_t>(i)]; };
  for (int j = 0; j < balls_; ++j) {
    dy[j] = y[balls_ + j];
    dy[balls_ + j] = rate(4 * lanes + j);
    for (int i = 0; i < 3; ++i) dy[(2 + i) * balls_ + j] = rate((6 + i) * lanes + j);
  }
  double* cage = dy + 5 * balls_;
  const double* at = y + 5 * balls_;
  for (int i = 0; i < 3; ++i) {
    cage[i] = at[4 + i];
    cage[4 + i] = rate(layout.cage() + kCageUnknowns + i);
  }
  cage[3] = at[7];
  cage[7] = rate(layout.cage() + 2 * kCageUnknowns - 1);
}

}  // namespace orbearing::bearing::balls
