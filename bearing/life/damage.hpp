// Damage of the races by the passages of the rollers, and the resulting life. This is the only file that
// counts loads in motion. A passage counts where and when it happens: rollers with smaller distances, or a
// cage that runs ahead or lags, load a race more or less often than pure rolling would.
#pragma once

#include <Eigen/Core>

#include "bearing/contact/lamina_races.hpp"
#include "bearing/geometry.hpp"
#include "bearing/life/lamina_life.hpp"
#include "bearing/life/lundberg_palmgren.hpp"

namespace orbearing::bearing::motion {

/// Laminae whose loads must be counted one by one [-]: none where contacts are not cut (null), or carry
/// evenly all along whatever the load.
Eigen::Index uneven_laminae(const LaminaRaces* laminae);

/// The bin, of `bins` on a race, in which `angle` [rad] lies. Bins are evenly spaced in the carrier frame,
/// the first centred on the outward direction.
Eigen::Index bin_of(double angle, Eigen::Index bins);

/// Speeds of the races, and of the cage were all rollers to roll without slip [rad/s], relative to the
/// carrier.
struct RaceSpeeds {
  double inner = 0.0;
  double outer = 0.0;
  double cage = 0.0;
};
RaceSpeeds race_speeds(const BearingGeometry& geometry, double inner, double outer);

/// All rollers at one instant: arrays are over rollers.
struct RollerLoads {
  const double* angle = nullptr;          // [rad]
  const double* orbital_speed = nullptr;  // [rad/s]  relative to the carrier
  const double* inner = nullptr;          // [N]
  const double* outer = nullptr;          // [N]
  RaceSpeeds races;
  /// Approaches of the contacts [m], of a bearing whose laminae are counted one by one; else null.
  const LaminaRaces* laminae = nullptr;
  const double* inner_approach = nullptr;
  const double* outer_approach = nullptr;
  const double* end_displacement = nullptr;
};

/// Power of a load by which its passages count: of lines, rollers; of points, balls. [LundbergPalmgren1947]
/// [LundbergPalmgren1952]
enum class DamagePower { of_points = 3, of_lines = 4 };

/// Sums of one race. Bins are fixed in the carrier frame, as loads do. N^p: by the damage power.
struct RacePassages {
  Eigen::ArrayXd way;    // [rad]      (bins)  that elements went over the race while at a bin
  Eigen::ArrayXd load;   // [N rad]    (bins)
  Eigen::ArrayXd power;  // [N^p rad]  (bins)
  double rolling = 0.0;  // [rad]  way of all elements at pure rolling
  Eigen::ArrayXXd lamina_fourth_power;  // [N^4 rad]  (laminae, bins)  no rows: laminae are not counted
  double lamina_largest = 0.0;          // [N]

  explicit RacePassages(Eigen::Index bins, Eigen::Index laminae = 0,
                        DamagePower damage_power = DamagePower::of_lines);
  void add(Eigen::Index bin, double passed, double force) { add(bin, share_of(passed, force)); }
  /// `forces` [N] (laminae) are those of the elastic contact, whose sum the damping turns into `force`.
  void add_laminae(Eigen::Index bin, double passed, double force,
                   const Eigen::Ref<const Eigen::ArrayXd>& forces);

  /// Passages that happened over those of pure rolling [-]  (bins)
  Eigen::ArrayXd passages() const;
  /// Mean over the passages at each bin [N]; zero where there were none  (bins)
  Eigen::ArrayXd mean_load() const;
  /// Powers of all passages over the number of passages at pure rolling [N^p]  (bins)
  Eigen::ArrayXd damage() const;
  /// Fourth powers of single laminae likewise [N^4]  (laminae, bins)
  Eigen::ArrayXXd lamina_damage() const;

  /// Whether these are of as many bins and laminae, and of the same power, as `other`.
  bool is_counted_as(const RacePassages& other) const {
    return way.size() == other.way.size() && damage_power_ == other.damage_power_ &&
           lamina_fourth_power.rows() == other.lamina_fourth_power.rows();
  }

  /// Contribution of one element to its bin.
  struct Share {
    double way, load, power;  // [rad], [N rad], [N^p rad]
  };
  Share share_of(double passed, double force) const {
    const double square = force * force;
    return {passed, passed * force,
            passed * square * (damage_power_ == DamagePower::of_points ? force : square)};
  }
  void add(Eigen::Index bin, const Share& share) {
    way[bin] += share.way;
    load[bin] += share.load;
    power[bin] += share.power;
  }

 private:
  Eigen::ArrayXXd over_rolling(const Eigen::Ref<const Eigen::ArrayXXd>& sums) const;

  DamagePower damage_power_;
};

/// Results of damage() of both races, and of lamina_damage() if laminae are counted.
struct RaceDamage {
  Eigen::ArrayXd whole;     // [N^4]  (bins)
  Eigen::ArrayXXd laminae;  // [N^4]  (laminae, bins)  no rows: every lamina carries alike
};

/// Views of the same values, which must outlive this.
struct RaceDamageView {
  Eigen::Ref<const Eigen::ArrayXd> whole;
  Eigen::Ref<const Eigen::ArrayXXd> laminae;

  RaceDamageView(const Eigen::ArrayXd& of_whole, const Eigen::ArrayXXd& of_laminae)
      : whole(of_whole), laminae(of_laminae) {}
  RaceDamageView(const RaceDamage& damage) : RaceDamageView(damage.whole, damage.laminae) {}
};

/// Means over the bins, lamina by lamina; contacts that are not cut are those of one lamina.
life::LaminaMeans means_of(const RaceMotions& motions, const RaceDamageView& inner,
                           const RaceDamageView& outer);

/// Life by Lundberg and Palmgren from both races' damage, as if each bin were loaded evenly by its fourth
/// root: the standing race takes each bin's own life, [(1/2pi) integral D^(4.5/4)]^(1/4.5); the turning
/// race shares all passages, [(1/2pi) integral D]^(1/4). By bearing/life, lamina by lamina, where laminae are
/// counted. `reduction_factor` as in contact_capacity().
BearingLife life_under(const Bearing& bearing, double reduction_factor, const RaceDamageView& inner,
                       const RaceDamageView& outer);

/// Sums of both races since the start.
class DamageSums {
 public:
  RacePassages inner;
  RacePassages outer;

  /// `laminae` as returned by uneven_laminae().
  explicit DamageSums(Eigen::Index bins, Eigen::Index laminae = 0, DamagePower power = DamagePower::of_lines)
      : inner(bins, laminae, power), outer(bins, laminae, power), lamina_forces_(laminae) {}

  /// `rollers` rollers whose loads last for `time` [s]; also into `other`, where there is one: the same
  /// numbers as one after the other, for less work.
  void add(double time, Eigen::Index rollers, const RollerLoads& loads, DamageSums* other = nullptr);
  /// Life [rev] were it to go on like this; infinite where nothing was loaded or nothing turned.
  BearingLife life(const Bearing& bearing, double reduction_factor) const;

  /// Every number in turn, for `visit(double* first, long size)`.
  template <class Visit>
  void each(Visit visit) {
    for (RacePassages* race : {&inner, &outer}) {
      for (Eigen::ArrayXd* sums : {&race->way, &race->load, &race->power})
        visit(sums->data(), static_cast<long>(sums->size()));
      visit(&race->rolling, 1);
      visit(race->lamina_fourth_power.data(), static_cast<long>(race->lamina_fourth_power.size()));
      visit(&race->lamina_largest, 1);
    }
  }

 private:
  Eigen::ArrayXd lamina_forces_;  // [N]  of one contact: workspace
};

}  // namespace orbearing::bearing::motion
