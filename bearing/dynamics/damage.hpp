// What rollers that pass do to the races of a bearing, and the life that it leaves: the one place where loads
// in motion are counted. A passage counts where and when it happens: rollers that stand closer together, or
// a cage that runs ahead or lags, load a race more or less often than pure rolling would.
#pragma once

#include <Eigen/Core>

#include "bearing/geometry.hpp"
#include "bearing/lundberg_palmgren.hpp"

namespace orbearing::bearing::dynamics {

/// The bin, of `places` on a race, in which `angle` [rad] lies. Bins are evenly spaced in the carrier frame,
/// the first centred on the outward direction.
Eigen::Index place_of(double angle, Eigen::Index places);

/// Speeds of the races, and of the cage were all rollers to roll without slip [rad/s], relative to the
/// carrier.
struct RaceSpeeds {
  double inner = 0.0;
  double outer = 0.0;
  double cage = 0.0;
};
RaceSpeeds race_speeds(const RollerBearingGeometry& geometry, double inner, double outer);

/// All rollers at one instant: arrays are over rollers.
struct RollerLoads {
  const double* angle = nullptr;          // [rad]
  const double* orbital_speed = nullptr;  // [rad/s]  relative to the carrier
  const double* inner = nullptr;          // [N]
  const double* outer = nullptr;          // [N]
  RaceSpeeds races;
};

/// Sums of one race. Places stand in the carrier frame, as loads do.
struct RacePassages {
  Eigen::ArrayXd way;           // [rad]      (places)  that rollers went over the race while at a place
  Eigen::ArrayXd load;          // [N rad]    (places)
  Eigen::ArrayXd fourth_power;  // [N^4 rad]  (places)
  double rolling = 0.0;         // [rad]  way of all rollers at pure rolling

  explicit RacePassages(Eigen::Index places);
  void add(Eigen::Index place, double passed, double force);

  /// Passages that happened over those of pure rolling [-]  (places)
  Eigen::ArrayXd passages() const;
  /// Mean over the passages at each place [N]; zero where there were none  (places)
  Eigen::ArrayXd mean_load() const;
  /// Fourth powers of all passages over the number of passages at pure rolling [N^4]  (places)
  Eigen::ArrayXd damage() const;

 private:
  Eigen::ArrayXd over_rolling(const Eigen::ArrayXd& sums) const;
};

/// Life by Lundberg and Palmgren from both races' damage, as if each place were loaded evenly by its fourth
/// root: the standing race takes each place's own life, [(1/2pi) integral D^(4.5/4)]^(1/4.5); the turning
/// race shares all passages, [(1/2pi) integral D]^(1/4). Arguments as in lundberg_palmgren_life().
BearingLife life_under(const CylindricalRollerBearing& bearing, double lambda, Race standing,
                       const Eigen::Ref<const Eigen::ArrayXd>& inner_damage,
                       const Eigen::Ref<const Eigen::ArrayXd>& outer_damage);

/// Sums of both races since the start.
struct DamageSums {
  RacePassages inner;
  RacePassages outer;

  explicit DamageSums(Eigen::Index places) : inner(places), outer(places) {}

  /// `rollers` rollers whose loads last for `time` [s].
  void add(double time, Eigen::Index rollers, const RollerLoads& loads);
  /// Life [rev] were it to go on like this; infinite where nothing was loaded or nothing turned.
  BearingLife life(const CylindricalRollerBearing& bearing, double lambda, Race standing) const;

  /// Every number in turn, for `visit(double* first, long size)`.
  template <class Visit>
  void each(Visit visit) {
    for (RacePassages* race : {&inner, &outer}) {
      for (Eigen::ArrayXd* sums : {&race->way, &race->load, &race->fourth_power})
        visit(sums->data(), static_cast<long>(sums->size()));
      visit(&race->rolling, 1);
    }
  }
};

}  // namespace orbearing::bearing::dynamics
