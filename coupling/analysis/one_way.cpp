#include "coupling/analysis/one_way.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "coupling/system/bearing_steps.hpp"
#include "coupling/system/motion_progress.hpp"
#include "mechanics/linear_algebra.hpp"

namespace orbearing::analysis {

namespace {

constexpr double kKept = 0.5;  // [-]  of the weight of earlier motions

using Eigen::Index;
using Eigen::MatrixXd;
using gearset::dynamics::AffineBearing;
using Unknowns =
    Eigen::Matrix<double, 4, 2>;  // stiffness over damping, transposed: force = -motion x unknowns

Unknowns unknowns_of(const AffineBearing& law) {
  Unknowns unknowns;
  unknowns << law.stiffness.transpose(), law.damping.transpose();
  return unknowns;
}

// The shortest of the least squares, so that what no motion shows stays zero. Departure from what is
// expected, in units of `known`: first as if nothing were known, for the scatter of the forces; then drawn to
// zero by as much as that scatter leaves open. `weight`: of all rows, of which those of the last motion have
// one each.
MatrixXd departure(const MatrixXd& motion, const MatrixXd& unexplained, double weight) {
  const MatrixXd free = mechanics::least_squares(motion, unexplained);
  const double scatter =
      (unexplained - motion * free).norm() / std::sqrt(static_cast<double>(unexplained.cols()) * weight);
  MatrixXd matrix(motion.rows() + 4, 4), right = MatrixXd::Zero(motion.rows() + 4, 2);
  matrix << motion, scatter * Eigen::Matrix4d::Identity();
  right.topRows(motion.rows()) = unexplained;
  return mechanics::least_squares(matrix, right);
}

// Dampers that give energy are chance, of a motion too short or too small: their symmetric part becomes the
// nearest one that gives none.
void take_energy(Unknowns& law) {
  const Eigen::Matrix2d damping = law.bottomRows<2>(), even = 0.5 * (damping + damping.transpose());
  const mechanics::SymmetricModes modes = mechanics::symmetric_modes(even);
  law.bottomRows<2>() +=
      modes.vectors * modes.values.cwiseMin(0.0).cwiseAbs().asDiagonal() * modes.vectors.transpose();
}

}  // namespace

AffineFit::AffineFit(double angular_frequency, int orders)
    : angular_frequency_(angular_frequency), orders_(static_cast<std::size_t>(orders)) {
  if (orders < 1) throw std::invalid_argument("orders of a fit: found none; required: at least 1");
}

void AffineFit::add(const system::BoreSample& sample) {
  Row row;
  row << sample.position.transpose(), sample.velocity.transpose(), sample.force.transpose();
  weight_ += sample.weight;
  sum_ += sample.weight * row;
  const double angle = std::fmod(angular_frequency_ * sample.time, 2.0 * M_PI);
  const double c = std::cos(angle), s = std::sin(angle);
  double cosine = sample.weight, sine = 0.0;
  for (Order& order : orders_) {
    const double turned = cosine * c - sine * s;
    sine = cosine * s + sine * c;
    cosine = turned;
    order.cosine += cosine * row;
    order.sine += sine * row;
    order.cosine_weight += cosine;
    order.sine_weight += sine;
  }
}

MatrixXd AffineFit::harmonics() const {
  const Row mean = sum_ / weight_;
  MatrixXd rows(2 * static_cast<Index>(orders_.size()), 6);
  for (Index k = 0; k < rows.rows() / 2; ++k) {
    const Order& order = orders_[static_cast<std::size_t>(k)];
    rows.row(2 * k) = 2.0 / weight_ * (order.cosine - order.cosine_weight * mean);
    rows.row(2 * k + 1) = 2.0 / weight_ * (order.sine - order.sine_weight * mean);
  }
  return rows;
}

void AffineFit::begin_motion() {
  const MatrixXd rows = std::sqrt(weight_) * harmonics();
  before_.conservativeResize(before_.rows() + rows.rows(), Eigen::NoChange);
  before_.bottomRows(rows.rows()) = rows;
  before_ *= std::sqrt(kKept);
  before_weight_ = kKept * (before_weight_ + weight_ * static_cast<double>(rows.rows()));
  orders_.assign(orders_.size(), {});
  sum_.setZero();
  weight_ = 0.0;
}

FittedBearing AffineFit::law(const AffineBearing& expected, const AffineBearing& before) const {
  const double stiffness = kExpectedStiffness * expected.stiffness.norm(), damping = expected.damping.norm();
  const Eigen::Vector4d known(stiffness, stiffness, damping, damping);
  const Unknowns prior = unknowns_of(expected);
  const auto fitted_to = [&](const MatrixXd& rows, double weight) {
    Unknowns found =
        prior + known.asDiagonal() * departure(rows.leftCols<4>() * known.asDiagonal(),
                                               -rows.rightCols<2>() - rows.leftCols<4>() * prior, weight);
    take_energy(found);
    return found;
  };
  const MatrixXd last = harmonics();
  MatrixXd all(before_.rows() + last.rows(), 6);
  all << before_ / std::sqrt(weight_), last;
  const double of_last = static_cast<double>(last.rows());
  const Unknowns found = fitted_to(all, of_last + before_weight_ / weight_);
  const MatrixXd motion = last.leftCols<4>(), force = last.rightCols<2>();
  const Row mean = sum_ / weight_;
  FittedBearing result;
  result.bearing.stiffness = found.topRows<2>().transpose();
  result.bearing.damping = found.bottomRows<2>().transpose();
  result.bearing.force = (mean.tail<2>() + mean.head<4>() * found).transpose();
  result.residual = (force + motion * found).norm() / force.norm();
  const Unknowns own = fitted_to(last, of_last), change = own - unknowns_of(before);
  const auto share = [&](const Unknowns& part, Index from) {
    return (motion.middleCols<2>(from) * part.middleRows<2>(from)).norm() /
           (motion.middleCols<2>(from) * own.middleRows<2>(from)).norm();
  };
  result.stiffness_change = share(change, 0);
  result.damping_change = share(change, 2);
  return result;
}

namespace {

using system::SteadyStateResult;

// [-]  of the observed windows, after which the law is looked at: what leads near it need not be reported.
constexpr int kLookShare = 3;
constexpr double kLookMargin = 2.0;  // [-]  on the changes that are allowed: less motion scatters more

AffineBearing times(double factor, const AffineBearing& law) {
  return {factor * law.force, factor * law.stiffness, factor * law.damping};
}

// With its own outer ring, where it has one, for a bore: the planet's body stays with the gears. The support
// keeps its damper, which is stated as a ratio of what moves.
bearing::motion::DynamicsParameters on_its_ring(const PlanetaryDrivetrain& drivetrain,
                                                const DrivetrainGeometry& geometry,
                                                bearing::motion::DynamicsParameters parameters) {
  const double pin = geometry.bearing.inner_ring_mass, ring = geometry.bearing.outer_ring_mass;
  if (!has_outer_ring(drivetrain.bearing, geometry.bearing)) return parameters;
  parameters.support.damping_ratio *= std::sqrt((parameters.bore_mass + pin) / (ring + pin));
  parameters.bore_mass = ring;
  return parameters;
}

// Gears and bearing in turn: their states, and the present law.
class OneWay {
 public:
  OneWay(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry, const BearingDuty& duty,
         const std::optional<Eigen::VectorXd>& start, const OneWayOptions& options)
      : drivetrain_(drivetrain),
        geometry_(geometry),
        duty_(duty),
        options_(options),
        parameters_(on_its_ring(drivetrain, geometry, bearing_dynamics_of(duty, drivetrain, geometry))),
        slow_(system::is_slow(bearing_model(drivetrain.bearing, duty.point, parameters_))),
        bearing_state_(start) {}

  /// Until a run agrees with the law that it was driven on, or there is no better law to go to.
  OneWayRun run(const GearsOnTangent& gears) {
    tangent_ = gears.tangent;
    if (!drive(tangent_, gears.run))
      return {run_bearing(bearing_dynamics_of(duty_, drivetrain_, geometry_), drivetrain_.steady_state),
              std::nullopt, difference_at_rest()};
    OneWayRun result;
    do {
      last_ = ++record_.runs >= options_.most_runs || last_;
      const system::RunInTurn turn(record_.runs, options_.most_runs);
      result.bearing = run_driven();
      if (!result.bearing.completed) return result;
      record_.accepted = is_close(1.0);
    } while (!record_.accepted && !last_ && go_to_fitted_law());
    record_.accepted = record_.accepted && record_.load_difference <= options_.load_difference;
    result.fit = record_;
    result.load_difference = record_.load_difference;
    return result;
  }

 private:
  // [-]  of `on_planet`, the mean force [N] of all bearings on the planet, from the load of the run.
  double difference_of(const Eigen::Vector2d& on_planet) const {
    const Eigen::Vector2d load = drivetrain_.bearings_per_planet * duty_.point.bore_load;
    return (on_planet + load).norm() / load.norm();
  }

  // For gears without excitation: the effect of displaced planets on the load is known at rest.
  std::optional<double> difference_at_rest() const {
    const std::optional<Eigen::Vector2d> force = bearing_force_at_rest(drivetrain_, geometry_, duty_.planet);
    if (!force) return std::nullopt;
    return difference_of(*force);
  }

  // By gears that moved on `law`; false where they give nothing but their mean loads.
  bool drive(const AffineBearing& law, const GearRunResult& gears) {
    law_ = law;
    gear_state_ = gears.final_state;
    parameters_.excitation = excitation_of(gears, drivetrain_, duty_, law, parameters_.bore_mass);
    if (parameters_.excitation.harmonics.empty()) return false;
    const PlanetStatistics& planet = gears.planets[static_cast<std::size_t>(duty_.planet)];
    record_.load_difference = difference_of({planet.radial_force.mean, planet.tangential_force.mean});
    return true;
  }

  SteadyStateResult run_bearing(const bearing::motion::DynamicsParameters& parameters,
                                const system::SteadyStateOptions& options) const {
    return run_to_steady_state(drivetrain_.bearing, duty_.point, parameters, options, bearing_state_);
  }

  // The bearing as it is driven now, looked at on the way.
  SteadyStateResult run_driven() {
    begin_motion();
    system::SteadyStateOptions options = drivetrain_.steady_state;
    options.on_bore = [this](const system::BoreSample& sample) { fit_->add(sample); };
    options.look = {std::max(1, options.observed_windows / kLookShare), [this] { return goes_on(); }};
    SteadyStateResult result = run_bearing(parameters_, options);
    if (!result.completed) return result;
    bearing_state_ = result.final_state;
    if (whole_) fit();  // else to what the look saw
    return result;
  }

  // The first motion only leads near the law: it is forgotten.
  void begin_motion() {
    if (record_.runs > 2) return fit_->begin_motion();
    fit_.emplace(parameters_.excitation.angular_frequency, excitation_orders(drivetrain_, geometry_, law_));
  }

  // The tangent is what is known beforehand, in each run alike: drawn to the law before, what no motion shows
  // would wander.
  void fit() {
    const double number = drivetrain_.bearings_per_planet;
    record_.fitted = fit_->law(times(1.0 / number, tangent_), times(1.0 / number, law_));
    record_.fitted.bearing = times(number, record_.fitted.bearing);
  }

  // Asked in a run: is it to be observed to its end?
  bool goes_on() {
    fit();
    next_.reset();
    whole_ = last_ || is_close(kLookMargin);
    if (whole_) return true;
    next_.emplace(drivetrain_, geometry_, record_.fitted.bearing);
    return whole_ = last_ = !next_->stay_on();  // there is no better law to go to
  }

  // False where gears run away on it, and the last run was observed to its end.
  bool go_to_fitted_law() {
    if (!next_) next_.emplace(drivetrain_, geometry_, record_.fitted.bearing);
    if (!next_->stay_on()) return false;
    const GearRunResult gears = next_->run(gear_state_);
    if (gears.completed) {
      drive(record_.fitted.bearing, gears);
      return true;
    }
    last_ = true;  // driven as before, once more
    return !whole_;
  }

  /// In slow motion the dampers' force is too small to be fitted, and to matter.
  /// @param margin on what is allowed
  bool is_close(double margin) const {
    return record_.fitted.stiffness_change <= margin * options_.stiffness_change &&
           (slow_ || record_.fitted.damping_change <= margin * options_.damping_change);
  }

  const PlanetaryDrivetrain& drivetrain_;
  const DrivetrainGeometry& geometry_;
  const BearingDuty& duty_;
  const OneWayOptions& options_;
  bearing::motion::DynamicsParameters parameters_;
  bool slow_;
  AffineBearing tangent_, law_;  // law_: that the gears moved on
  std::optional<Eigen::VectorXd> gear_state_, bearing_state_;
  std::optional<AffineFit> fit_;
  OneWayRecord record_;
  std::optional<GearsOnLaw> next_;  // on the fitted law, if requested
  bool last_ = false;               // of the runs, whatever comes of it
  bool whole_ = false;              // the run was observed to its end
};

}  // namespace

OneWayRun run_one_way(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                      const BearingDuty& duty, const GearsOnTangent& gears,
                      const std::optional<Eigen::VectorXd>& start, const OneWayOptions& options) {
  return OneWay(drivetrain, geometry, duty, start, options).run(gears);
}

}  // namespace orbearing::analysis
