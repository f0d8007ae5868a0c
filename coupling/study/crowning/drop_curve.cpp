#include "coupling/study/crowning/drop_curve.hpp"
#include "mechanics/constants.hpp"

#include <algorithm>
#include <cmath>

namespace orbearing::study::crowning {

Eigen::ArrayXd curve_nodes(double greatest, int intervals) {
  Eigen::ArrayXd nodes(intervals + 1);
  for (int k = 0; k <= intervals; ++k) {
    const double sine = std::sin(0.5 * constants::pi * k / intervals);
    nodes[k] = greatest * sine * sine;
  }
  return nodes;
}

DropCurve::DropCurve(double greatest, Eigen::ArrayXd values)
    : nodes_(curve_nodes(greatest, static_cast<int>(values.size()) - 1)), values_(std::move(values)) {}

double DropCurve::operator()(double drop) const {
  const Eigen::Index last = nodes_.size() - 1;
  const double at = std::clamp(drop, nodes_[0], nodes_[last]);
  double above = 0.0, below = 0.0;
  for (Eigen::Index k = 0; k <= last; ++k) {
    if (at == nodes_[k]) return values_[k];
    const double weight = (k % 2 == 0 ? 1.0 : -1.0) * (k == 0 || k == last ? 0.5 : 1.0) / (at - nodes_[k]);
    above += weight * values_[k];
    below += weight;
  }
  return above / below;
}

}  // namespace orbearing::study::crowning
