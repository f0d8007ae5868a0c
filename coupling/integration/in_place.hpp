// Whether all bodies still are where the equations of the bearing mean anything.
#pragma once

#include <Eigen/Core>
#include <string>

#include "bearing/motion/model.hpp"

namespace orbearing::integration {

/// Empty while the cage holds its rollers and the rollers lie between the races; else what has come out, and
/// by how much. Pockets hold a cage along the pitch circle alone: one that no land guides can be thrown out
/// sideways, and its equations go on without bound.
std::string out_of_place(const bearing::dynamics::BearingModel& model,
                         const Eigen::Ref<const Eigen::VectorXd>& x);

}  // namespace orbearing::integration
