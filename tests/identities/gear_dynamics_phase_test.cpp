// Which harmonics of the mesh excite which kind of motion: k = l z_s mod N [ParkerLin2004].
#include <gtest/gtest.h>

#include <complex>

#include "coupling/analysis/gear_dynamics.hpp"
#include "gearset/dynamics/mode_kind.hpp"
#include "tests/gear_sets.hpp"

namespace orbearing::gearset::dynamics::gear_dynamics_phase_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXd;

constexpr int kSamples = 128;
constexpr int kHarmonics = 8;

// The dynamics of the reducer with phases as if its sun had `sun_teeth` and its ring `ring_teeth`.
SetModel with_phases(int sun_teeth, int ring_teeth) {
  SetParameters set = test::reducer_dynamics();
  for (int n = 0; n < set.planets; ++n) {
    set.sun_phase[static_cast<std::size_t>(n)] = static_cast<double>(sun_teeth * n) / set.planets;
    set.ring_phase[static_cast<std::size_t>(n)] = 0.3 - static_cast<double>(ring_teeth * n) / set.planets;
  }
  return set_model(set, test::reducer_operation(628.0));
}

// Complex amplitudes of sqrt(mass) x position over one period of the settled motion: (freedoms, harmonics).
MatrixXcd harmonics(const SetModel& model) {
  analysis::GearRunOptions options;
  options.window_periods = 600;
  options.most_windows = 1;
  options.observed_periods = 1;
  options.allowed_share = 1e-7;
  const analysis::GearRunResult settled = run_gears(model, options);
  const double period = 1.0 / model.operation.mesh_frequency;
  const PlanetarySetEquations equations(model);
  const auto derivative = [&](double time, const Eigen::Ref<const VectorXd>& x, Eigen::Ref<VectorXd> dx) {
    equations.derivative(time, x, dx);
  };
  integration::IntegrationOptions stepping;
  stepping.allowed_error = integration::gear_allowed_errors(model, options.allowed_share);
  stepping.step = 1e-7;
  VectorXd x = settled.final_state;
  MatrixXcd amplitude = MatrixXcd::Zero(model.layout.freedoms(), kHarmonics);
  const auto observe = [&](double time, const Eigen::Ref<const VectorXd>& at) {
    const VectorXd weighted = model.mass.cwiseSqrt().cwiseProduct(at.head(model.layout.freedoms()));
    for (int l = 1; l <= kHarmonics; ++l)
      amplitude.col(l - 1) += weighted * std::polar(2.0 / kSamples, -2.0 * M_PI * l * time / period);
  };
  integrate_pieces(derivative, x, {settled.report.reached, period / kSamples, kSamples},
                   integration::jumps_of(model), stepping, observe);
  return amplitude;
}

struct Set {
  const char* name;
  int sun_teeth;
  int ring_teeth;
};

class PhaseRule : public testing::TestWithParam<Set> {};

TEST_P(PhaseRule, TellsTheKindOfEachHarmonic) {
  const SetModel model = with_phases(GetParam().sun_teeth, GetParam().ring_teeth);
  const MatrixXcd amplitude = harmonics(model);
  // Remaining transient after 600 periods, the allowed error of the steps, and rotation as a rigid body.
  constexpr double leak = 1e-4;  // [-]  share of energy
  for (int l = 1; l <= kHarmonics; ++l) {
    const KindShares shares = kind_shares(model, amplitude.col(l - 1));
    const int k = (l * GetParam().sun_teeth) % 4;
    const double own = k == 0 ? shares.rotational : k == 2 ? shares.planet : shares.translational;
    EXPECT_GT(own, 1.0 - leak) << "harmonic " << l << ": rotational " << shares.rotational
                               << ", translational " << shares.translational << ", planet " << shares.planet;
  }
}

INSTANTIATE_TEST_SUITE_P(Sets, PhaseRule,
                         testing::Values(Set{"in_phase", 36, 80}, Set{"out_of_phase", 37, 79},
                                         Set{"counter_phased", 38, 78}),
                         [](const testing::TestParamInfo<Set>& set) { return set.param.name; });

}  // namespace
}  // namespace orbearing::gearset::dynamics::gear_dynamics_phase_test
