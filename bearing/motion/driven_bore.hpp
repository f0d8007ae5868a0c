// The planet bearing whose bore others move: rates of the same state, and what the bearing does to the bore.
#pragma once

#include <Eigen/Core>

#include "bearing/motion/bore_motion.hpp"
#include "bearing/motion/model.hpp"
#include "bearing/motion/snapshot.hpp"

namespace orbearing::bearing::motion {

/// The carrier's frame in `motion`, with the inertial terms that `model` has switched on.
CarrierFrame frame_of(const BearingModel& model, const BoreMotion& motion);

/// Rate `dx` of the state `x`, both in the order of StateLayout, under `motion` [SI]. The bore stands where
/// `motion` says, whatever its four entries of `x` hold; their rates are the given velocity and acceleration.
/// Loads, speeds and frame that `model` was made with are not used, nor are its excitation and its run-up.
/// The pin ring does not turn. @return what the bearing does to the bore
BoreReaction driven_derivative(const BearingModel& model, const BoreMotion& motion,
                               const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> dx);

/// Force and moment on the bore in the state `x`; entries of the bore as above.
BoreReaction reaction(const BearingModel& model, const BoreMotion& motion,
                      const Eigen::Ref<const Eigen::VectorXd>& x);

/// What can be read off the bearing in the state `x` under `motion`.
Snapshot driven_snapshot(const BearingModel& model, const BoreMotion& motion,
                         const Eigen::Ref<const Eigen::VectorXd>& x);

/// `model` as it is at the instant of `motion`, for functions that take a model and a state: its speeds and
/// its frame are those of `motion`, its time is zero, and waves of the bore are turned to where they stand.
BearingModel model_at(const BearingModel& model, const BoreMotion& motion);
/// `x` with the bore where `motion` says.
Eigen::VectorXd state_at(const BearingModel& model, const BoreMotion& motion,
                         const Eigen::Ref<const Eigen::VectorXd>& x);

}  // namespace orbearing::bearing::motion
