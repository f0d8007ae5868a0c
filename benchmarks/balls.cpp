#include "benchmarks/balls.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

#include "bearing/motion/balls/published_form.hpp"
#include "benchmarks/clocks.hpp"
#include "benchmarks/speed.hpp"
#include "coupling/analysis/ball_run.hpp"
#include "coupling/integration/integrate.hpp"
#include "coupling/system/balls_in_time.hpp"
#include "orbearing/machines.hpp"

namespace orbearing::bench {

namespace {

using bearing::balls::BallBearing;
using Json = nlohmann::ordered_json;

constexpr double kSettling = 0.1;                 // [s]
constexpr double kDuration = 0.09;                // [s]  two revolutions of the cage
constexpr long kSamples = 450;                    // steps between them are as long as without them
constexpr double kBallReferenceStep = 1e-7;       // [s]
constexpr double kPublishedReferenceStep = 5e-7;  // [s]
constexpr double kOtherStep = 0.75e-7;            // [s]  another path: what chance does
constexpr int kPairs = 5;

enum class BallMethod { ours, dopri5, rk4, published };

struct BallFigures {
  double rms = 0.0;         // [N]  of one ball on the inner race
  double largest = 0.0;     // [N]
  double cage_speed = 0.0;  // [rad/s]
  double loss = 0.0;        // [W]
  double seconds = 0.0;     // [s]  of this thread
  std::vector<double> state;
};

struct BallErrors {
  double rms = 0.0, largest = 0.0, cage_speed = 0.0, loss = 0.0;  // [-]
};

// Accuracy that every method must reach, compared with a finer run of the same equations; the motion is
// subject to chance.
constexpr BallErrors kEqual{.rms = 2e-3, .largest = 1e-2, .cage_speed = 2e-3, .loss = 3e-2};

BallErrors errors(const BallFigures& found, const BallFigures& reference) {
  const auto share = [](double a, double b) { return std::abs(a / b - 1.0); };
  return {share(found.rms, reference.rms), share(found.largest, reference.largest),
          share(found.cage_speed, reference.cage_speed), share(found.loss, reference.loss)};
}

bool equal(const BallErrors& e) {
  return e.rms <= kEqual.rms && e.largest <= kEqual.largest && e.cage_speed <= kEqual.cage_speed &&
         e.loss <= kEqual.loss;
}

Json to_json(const BallErrors& e) {
  return {{"rms_relative", e.rms},
          {"max_relative", e.largest},
          {"cage_speed_relative", e.cage_speed},
          {"loss_relative", e.loss}};
}

class BallContest {
 public:
  explicit BallContest(const MovingBallBearing& in)
      : bearing_(analysis::rotating_bearing(in.loaded)),
        options_(in.simulation.options),
        model_(bearing::balls::ball_numbers(bearing_, in.simulation.motion), analysis::ball_duty(in)) {
    start_ = bearing::balls::start_state(bearing_, model_, 0.0);
    start_ = run(BallMethod::ours, options_.length_error, false, kSettling).state;
  }

  int balls() const { return model_.numbers().balls; }
  double length_error() const { return options_.length_error; }

  BallFigures run(BallMethod method, double tolerance, bool watched, double duration = kDuration) {
    BallFigures figures;
    std::vector<double> x = start_, rate(x.size());
    const long samples = watched ? kSamples : 1;
    const auto cage_turn = static_cast<std::size_t>(model_.layout().cage() + 5);
    double squares = 0.0;
    const auto look = [&](double time) {
      if (!watched) return;
      const bearing::balls::BallSnapshot s = model_.snapshot(time, x.data());
      for (const auto& contact : s.inner) {
        squares += contact.load * contact.load;
        figures.largest = std::max(figures.largest, contact.load);
      }
      figures.loss += s.loss.total() / static_cast<double>(samples);
    };
    const Stopwatch watch;
    if (method == BallMethod::ours) {
      system::BallsInTime balls(start_, system::ball_stepper(model_.numbers(), tolerance));
      system::BallEquations system(model_);
      integration::IntegrationReport report;
      const integration::IntegrationOptions limits;
      integration::Run budget(limits, report);
      for (long i = 1; i <= samples; ++i) {
        const double end = duration * static_cast<double>(i) / static_cast<double>(samples);
        balls.advance(system, end, budget, report);
        x = balls.state();
        look(end);
      }
    } else {
      by_odeint(method, tolerance, duration, samples, x, look);
    }
    figures.seconds = watch.cpu();
    figures.rms = std::sqrt(squares / static_cast<double>(samples * balls()));
    figures.cage_speed = (x[cage_turn] - start_[cage_turn]) / duration;
    figures.state = std::move(x);
    return figures;
  }

 private:
  template <class Look>
  void by_odeint(BallMethod method, double tolerance, double duration, long samples, std::vector<double>& x,
                 const Look& look) {
    std::optional<bearing::balls::PublishedForm> form;
    Eigen::VectorXd state = Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
    if (method == BallMethod::published) {
      form.emplace(model_);
      const std::vector<double> y = form->reduced(x);
      state = Eigen::Map<const Eigen::VectorXd>(y.data(), static_cast<Eigen::Index>(y.size()));
    }
    const integration::RightHandSide rate = [&](double time, const Eigen::Ref<const Eigen::VectorXd>& at,
                                                Eigen::Ref<Eigen::VectorXd> dx) {
      if (form)
        form->derivative(time, at.data(), dx.data());
      else
        model_.derivative(time, at.data(), dx.data());
    };
    integration::IntegrationOptions options;
    options.method = method == BallMethod::dopri5 ? integration::Method::dopri5 : integration::Method::rk4;
    options.step = method == BallMethod::dopri5 ? 1e-7 : tolerance;
    if (method == BallMethod::dopri5) {
      const std::vector<double> allowed = system::ball_allowed_errors(model_.numbers(), tolerance);
      options.allowed_error =
          Eigen::Map<const Eigen::VectorXd>(allowed.data(), static_cast<Eigen::Index>(allowed.size()));
      // A variable that does not move has no error.
      options.allowed_error = (options.allowed_error.array() > 0.0).select(options.allowed_error, 1.0);
    }
    const auto seen = [&](double time, const Eigen::Ref<const Eigen::VectorXd>& at) {
      if (form)
        x = form->complete(time, at.data());
      else
        x.assign(at.data(), at.data() + at.size());
      look(time);
    };
    const auto report = integration::integrate(
        rate, state, {0.0, duration / static_cast<double>(samples), samples}, options, seen);
    if (!report.completed) throw std::runtime_error(report.message);
  }

  bearing::Bearing bearing_;
  system::BallRunOptions options_;
  BallBearing model_;
  std::vector<double> start_;
};

// The loosest of the tolerances, which fall, at which the means are right; none: none is.
std::optional<double> loosest(BallContest& contest, BallMethod method, const BallFigures& reference,
                              const std::vector<double>& tolerances, BallErrors& found) {
  for (const double tolerance : tolerances) {
    try {
      found = errors(contest.run(method, tolerance, true), reference);
    } catch (const std::runtime_error&) {
      continue;  // it blows up
    }
    if (equal(found)) return tolerance;
  }
  return std::nullopt;
}

}  // namespace

void put_balls(double roller_real_time, int rollers, Json& out) {
  const Case motor =
      Case::read(ORBEARING_SOURCE_DIR "/cases/deep_groove_motor/case.yaml",
                 {"operation.shaft_speed=4000 rpm", "load.radial=500 N", "simulation.start=rolling"});
  BallContest contest(std::get<MovingBallBearing>(machine_of(motor)));
  const BallFigures reference = contest.run(BallMethod::rk4, kBallReferenceStep, true);
  out["ball_errors"] =
      to_json(errors(contest.run(BallMethod::ours, contest.length_error(), true), reference));
  out["ball_reference_spread"] = to_json(errors(contest.run(BallMethod::rk4, kOtherStep, true), reference));
  // Ours is given the same freedom as the others: its loosest tolerance whose means are right.
  BallErrors loose;
  const double own = loosest(contest, BallMethod::ours, reference, {4e-9, 2e-9, 1e-9, 8e-10, 4e-10}, loose)
                         .value_or(contest.length_error());
  out["ball_own_tolerance"] = own;
  out["ball_own_errors"] = to_json(loose);
  const auto ratio = [&](const char* name, BallMethod method, const BallFigures& aim,
                         const std::vector<double>& tolerances) {
    BallErrors found;
    const std::optional<double> tolerance = loosest(contest, method, aim, tolerances, found);
    out[std::string("ball_") + name + "_tolerance"] = tolerance ? Json(*tolerance) : Json();
    out[std::string("ball_") + name + "_errors"] = to_json(found);
    if (!tolerance) {
      out[std::string("ball_speedup_over_") + name] = nullptr;
      return;
    }
    std::vector<double> ratios, as_shipped;
    for (int pair = 0; pair < kPairs; ++pair) {
      const double theirs = contest.run(method, *tolerance, false).seconds;
      ratios.push_back(theirs / contest.run(BallMethod::ours, own, false).seconds);
      as_shipped.push_back(theirs / contest.run(BallMethod::ours, contest.length_error(), false).seconds);
    }
    out[std::string("ball_speedup_over_") + name] = median(ratios);
    out[std::string("ball_speedup_over_") + name + "_as_shipped"] = median(as_shipped);
  };
  ratio("dopri5", BallMethod::dopri5, reference, {1e-6, 3e-7, 1e-7, 3e-8, 1e-8, 3e-9, 1e-9, 3e-10, 1e-10});
  // The printed form is another model: its steps are judged by finer ones of its own.
  const BallFigures published = contest.run(BallMethod::published, kPublishedReferenceStep, true);
  out["ball_printed_form_differs"] = to_json(errors(published, reference));
  ratio("rk4", BallMethod::published, published,
        {1e-4, 6e-5, 4e-5, 3e-5, 2e-5, 1.4e-5, 1e-5, 7e-6, 5e-6, 3.5e-6, 2.5e-6, 1.7e-6, 1.2e-6, 8e-7});
  std::vector<double> seconds;
  for (int i = 0; i < kPairs; ++i)
    seconds.push_back(contest.run(BallMethod::ours, contest.length_error(), false).seconds);
  const double factor = kDuration / median(seconds);
  out["ball_real_time_factor"] = factor;
  out["ball_real_time_per_element_over_rollers"] = factor * contest.balls() / (roller_real_time * rollers);
}

}  // namespace orbearing::bench
