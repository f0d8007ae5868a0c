#include "coupling/study/coupled_motion.hpp"

#include <cmath>
#include <stdexcept>

#include "coupling/cosim/monolithic.hpp"
#include "coupling/cosim/planetary_coupling.hpp"
#include "coupling/study/driven_setups.hpp"

namespace orbearing::study {

namespace {

using bearing::dynamics::Snapshot;
using bearing::dynamics::StatisticsCollector;
using cosim::CoupledReport;

// The drivetrain's exchange with a whole number of windows in `interval`.
cosim::CoupledOptions options_of(const PlanetaryDrivetrain& drivetrain, double interval) {
  cosim::CoupledOptions options = drivetrain.exchange;
  options.window.longest = interval / std::ceil(interval / options.window.longest);
  return options;
}

class CoSimulatedMotion final : public cosim::CoupledMotion {
 public:
  CoSimulatedMotion(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                    double interval)
      : parts_(cosim::planetary_coupling(coupled_setup(drivetrain, geometry))),
        planets_(drivetrain.set.planets),
        options_(options_of(drivetrain, interval)),
        run_(parts_.participants(), cosim::connect_by_name(parts_.participants()), options_) {
    run_.initialize(0.0);
  }

  int planets() const override { return planets_; }
  int bearings_per_planet() const override { return static_cast<int>(parts_.bearings.size()) / planets_; }

  void advance(double time) override {
    const long until = std::lround(time / options_.window.longest);
    const auto observe = [this](const cosim::WindowRecord& record) { count_energy(record); };
    const CoupledReport part = run_.advance(until - done_, observe);
    done_ = until;
    report_.windows += part.windows;
    report_.iterations += part.passes;
    report_.rejected += part.rejected;
    report_.energy_residual += part.absolute_residual;
    if (!part.completed) throw std::runtime_error(part.message);
  }

  void take_snapshot(int b, Snapshot& into) const override { bearing(b).take_snapshot(into); }
  void collect_loads(const std::vector<StatisticsCollector*>& collectors) override {
    for (std::size_t b = 0; b < collectors.size(); ++b) parts_.bearings[b]->collect_loads(collectors[b]);
  }
  cosim::CouplingReport report() const override { return report_; }

 private:
  const cosim::BearingParticipant& bearing(int b) const {
    return *parts_.bearings[static_cast<std::size_t>(b)];
  }

  // By the values at the end of each window.
  void count_energy(const cosim::WindowRecord& record) {
    double power = 0.0;
    for (const cosim::JointValue& joint : record.end->joints) power += std::abs(joint.force * joint.velocity);
    report_.energy_passed += power * record.window.length();
  }

  cosim::PlanetaryCoupling parts_;
  int planets_;
  cosim::CoupledOptions options_;
  cosim::CoupledRun run_;
  cosim::CouplingReport report_;
  long done_ = 0;  // windows
};

class MonolithicMotion final : public cosim::CoupledMotion {
 public:
  explicit MonolithicMotion(const cosim::CoupledSetup& setup) : system_(setup) { system_.initialize(0.0); }

  int planets() const override { return system_.planets(); }
  int bearings_per_planet() const override { return system_.bearings() / system_.planets(); }
  void advance(double time) override { system_.follow(time); }
  void take_snapshot(int b, Snapshot& into) const override { system_.take_snapshot(b, into); }
  void collect_loads(const std::vector<StatisticsCollector*>& collectors) override {
    for (std::size_t b = 0; b < collectors.size(); ++b)
      system_.collect_loads(static_cast<int>(b), collectors[b]);
  }
  cosim::CouplingReport report() const override {
    return {.windows = system_.steps(), .rejected = system_.rejected()};
  }

 private:
  cosim::Monolithic system_;
};

}  // namespace

std::unique_ptr<cosim::CoupledMotion> coupled_motion(const PlanetaryDrivetrain& drivetrain,
                                                     const DrivetrainGeometry& geometry, Fidelity fidelity,
                                                     double interval) {
  if (fidelity == Fidelity::monolithic)
    return std::make_unique<MonolithicMotion>(coupled_setup(drivetrain, geometry));
  return std::make_unique<CoSimulatedMotion>(drivetrain, geometry, interval);
}

}  // namespace orbearing::study
