// A model as its engines read it: plain numbers, and padded states.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "bearing/motion/bore_motion.hpp"
#include "bearing/motion/model.hpp"
#include "bearing/motion/vectorised/observed.hpp"

namespace orbearing::bearing::vectorised {

/// Prescribed motions and loads of `model` at `time` [s].
Surroundings surroundings_at(const motion::BearingModel& model, double time);
/// The same with a prescribed motion of its bore: the pin ring does not turn, teeth press on its waves with
/// their means.
Surroundings surroundings_of(const motion::BearingModel& model, const motion::BoreMotion& motion);

/// Whether scratches or waves turn with the race.
bool turns_unevenly(const motion::RaceModel& race);

/// Whether the prescribed motions or loads of `model` change in time.
bool surroundings_change(const motion::BearingModel& model);

/// Valid as long as the model stays at its address and unchanged.
class ModelConstants {
 public:
  explicit ModelConstants(const motion::BearingModel& model);
  ModelConstants(ModelConstants&&) = default;

  const Constants& constants() const { return constants_; }
  RollerConstants rollers() const {
    return {pocket_cosine_.data(), pocket_sine_.data(), roller_radius_.data()};
  }
  const PaddedLayout& layout() const { return layout_; }

  /// From the order of motion/layout.hpp to that of PaddedLayout and back.
  std::vector<double> padded(const Eigen::Ref<const Eigen::VectorXd>& flat) const;
  void pad(const Eigen::Ref<const Eigen::VectorXd>& flat, double* padded) const;
  void flatten(const double* padded, Eigen::Ref<Eigen::VectorXd> flat) const;

 private:
  Constants constants_;
  PaddedLayout layout_;
  double pitch_radius_;                                              // [m]
  std::vector<double> pocket_cosine_, pocket_sine_, roller_radius_;  // (lanes)
};

/// Observed values of the rollers of `model` in the state `x`, in the order of motion/layout.hpp, under
/// `now`.
std::vector<ObservedRoller> observed_rollers(const motion::BearingModel& model, const Surroundings& now,
                                             const Eigen::Ref<const Eigen::VectorXd>& x);

}  // namespace orbearing::bearing::vectorised
