#include "bearing/equilibrium/elastic_waves.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mechanics/linear_algebra.hpp"

namespace orbearing::bearing {

namespace {

// Places of the cosine of an order among the waves; its sine comes next.
Eigen::Index position_of_order(Eigen::Index order) {
  return 2 * order - 3;
}

// `pick(order, is_sine)` for each wave.
template <class Pick>
Eigen::VectorXd of_each_wave(const ElasticRace& race, Pick&& pick) {
  Eigen::VectorXd all(wave_count(race));
  if (all.size() == 0) return all;
  all[0] = pick(0, false);
  for (Eigen::Index order = 2; order < race.compliance.size(); ++order) {
    all[position_of_order(order)] = pick(order, false);
    all[position_of_order(order) + 1] = pick(order, true);
  }
  return all;
}

}  // namespace

Eigen::Index wave_count(const ElasticRace& race) {
  return race.is_rigid() ? 0 : 1 + 2 * std::max<Eigen::Index>(race.compliance.size() - 2, 0);
}

Eigen::VectorXd waves_of_orders(const ElasticRace& race, const Eigen::ArrayXd& stated) {
  return of_each_wave(race, [&](Eigen::Index order, bool) { return stated[order]; });
}

Eigen::VectorXd wave_stiffness(const ElasticRace& race) {
  return waves_of_orders(race, race.compliance.inverse());
}

Eigen::VectorXd waves_at_rest(const ElasticRace& race) {
  return of_each_wave(race, [&](Eigen::Index order, bool is_sine) {
    return is_sine ? race.sine[order] : race.cosine[order];
  });
}

Eigen::VectorXd wave_shapes(const ElasticRace& race, double angle) {
  return of_each_wave(race, [&](Eigen::Index order, bool is_sine) {
    const double turned = static_cast<double>(order) * angle;
    return is_sine ? std::sin(turned) : std::cos(turned);
  });
}

void add_form(const Eigen::VectorXd& waves, double share, const Eigen::ArrayXd& angles,
              Eigen::ArrayXd& form) {
  if (waves.size() == 0) return;
  ElasticRace race;
  race.compliance.resize((waves.size() + 3) / 2);  // only its orders count
  for (Eigen::Index position = 0; position < angles.size(); ++position)
    form[position] += share * waves.dot(wave_shapes(race, angles[position]));
}

Eigen::MatrixXd without_waves(const Eigen::MatrixXd& stiffness, Eigen::Index kept) {
  const Eigen::Index waves = stiffness.rows() - kept;
  if (waves == 0) return stiffness;
  const Eigen::MatrixXd mixed = stiffness.bottomLeftCorner(waves, kept);
  const auto followed = mechanics::definite_solution(stiffness.bottomRightCorner(waves, waves), mixed);
  if (!followed) throw std::domain_error("stiffness: found coordinates that resist nothing");
  return stiffness.topLeftCorner(kept, kept) - mixed.transpose() * *followed;
}

}  // namespace orbearing::bearing
