#include "bearing/contact/lamina_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "bearing/contact/lamina_kernel.hpp"
#include "mechanics/checks.hpp"

namespace orbearing::bearing::laminae {

namespace {

constexpr std::size_t kMostLaminae = 1000;
constexpr std::size_t kMostPadded = 1008;
static_assert(kMostPadded % vectorised::kLaminaPadding == 0);

const vectorised::LaminaKernel& kernel_of([[maybe_unused]] mechanics::InstructionSet set) {
#ifdef ORBEARING_HAS_AVX512
  if (set == mechanics::InstructionSet::avx512) return vectorised::avx512_laminae();
#endif
#ifdef ORBEARING_HAS_AVX2
  if (set == mechanics::InstructionSet::avx2) return vectorised::avx2_laminae();
#endif
  return vectorised::baseline_laminae();
}

void require_sound(std::span<const double> drops) {
  mechanics::require(!drops.empty() && drops.size() <= kMostLaminae, "laminae", drops.size(),
                     "1 to " + std::to_string(kMostLaminae));
  if (!std::all_of(drops.begin(), drops.end(), [](double drop) { return std::isfinite(drop); }))
    throw std::invalid_argument("laminae: found a drop that is no finite number; required: a sound profile");
}

int padded(std::size_t laminae) {
  constexpr int pad = vectorised::kLaminaPadding;
  return (static_cast<int>(laminae) + pad - 1) / pad * pad;
}

}  // namespace

std::vector<double> lamina_positions(int n) {
  std::vector<double> positions(static_cast<std::size_t>(std::max(n, 0)));
  for (int k = 0; k < n; ++k) positions[static_cast<std::size_t>(k)] = (2.0 * k + 1.0) / n - 1.0;
  return positions;
}

std::vector<double> lamina_drops(const profile::Profile& roller, const profile::Profile& race, double length,
                                 int n) {
  std::vector<double> drops = lamina_positions(n);
  for (double& drop : drops) {
    const double x = 0.5 * length * drop;
    drop = profile::drop(roller, x) + profile::drop(race, x);
  }
  return drops;
}

LaminaContact::LaminaContact(const LineContact& whole, double length, std::span<const double> drops,
                             mechanics::InstructionSet set)
    : whole_(whole),
      scale_(whole.constant() / static_cast<double>(drops.size())),
      half_length_(0.5 * length),
      laminae_(static_cast<int>(drops.size())),
      padded_(padded(drops.size())),
      position_(lamina_positions(laminae_)),
      drop_(drops.begin(), drops.end()),
      kernel_(&kernel_of(set)) {
  require_sound(drops);
  least_drop_ = *std::min_element(drops.begin(), drops.end());
  greatest_drop_ = *std::max_element(drops.begin(), drops.end());
  position_.resize(static_cast<std::size_t>(padded_), 0.0);
  drop_.resize(static_cast<std::size_t>(padded_), vectorised::kNoLamina);
}

LaminaForce LaminaContact::evaluate(double approach, double end_displacement) const {
  if (approach + std::abs(end_displacement) <= least_drop_) return {};
  const vectorised::LaminaSums sums =
      kernel_->sums(position_.data(), drop_.data(), padded_, approach, end_displacement);
  const double slope = LineLaw::slope(scale_);
  return {scale_ * sums.load, scale_ * sums.end_load, slope * sums.by_approach, slope * sums.mixed,
          slope * sums.by_end_displacement};
}

void LaminaContact::put_loads(double approach, double end_displacement, double* load) const {
  std::array<double, kMostPadded> padded_load;
  if (approach + std::abs(end_displacement) <= least_drop_) {
    std::fill_n(load, laminae_, 0.0);
    return;
  }
  kernel_->loads(position_.data(), drop_.data(), padded_, approach, end_displacement, padded_load.data());
  for (int k = 0; k < laminae_; ++k) load[k] = scale_ * padded_load[static_cast<std::size_t>(k)];
}

Eigen::ArrayXd LaminaContact::loads(double approach, double end_displacement) const {
  Eigen::ArrayXd load(laminae_);
  put_loads(approach, end_displacement, load.data());
  return load;
}

double LaminaContact::energy(double approach, double end_displacement) const {
  const Eigen::Map<const Eigen::ArrayXd> drop(drop_.data(), laminae_);
  return LineLaw::energy(loads(approach, end_displacement), approach + end_displacement * positions() - drop)
      .sum();
}

// The load rises with its slope: from above, Newton's method falls to the root without passing it.
double approach_under(const LaminaContact& contact, double load) {
  if (!(load > 0.0)) return contact.least_drop();
  constexpr int most_steps = 60;
  constexpr double round_off = 1e-14;
  double approach = contact.greatest_drop() + contact.whole().approach(load);
  for (int step = 0; step < most_steps; ++step) {
    const LaminaForce now = contact.evaluate(approach, 0.0);
    const double less = (now.load - load) / now.by_approach;
    approach -= less;
    if (std::abs(less) <= round_off * approach) break;
  }
  return approach;
}

}  // namespace orbearing::bearing::laminae
