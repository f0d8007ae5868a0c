// Derivatives of a result by the numbers of a case: central differences of whole runs, two for each number.
//
// A number x is changed by factors e^t (by t of its customary unit where it is zero), a positive result y is
// taken by its logarithm, so that powers have no error of truncation:
//
//   (1)  slope = [ln y(h) - ln y(-h)]/(2 h),   h = (3 s)^(1/3)/2
//   (2)  error = max(|ln y(h) - 2 ln y(0) + ln y(-h)|, sqrt(6) s)/(2 h)
//
// with the scatter s of the result: (1) balances what it adds with terms of third order of order one. (2) is
// half of what the slopes to both sides differ by, at least by their scatter.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/study/analysis.hpp"
#include "mechanics/record.hpp"

namespace orbearing::app {

// One number of what `run` prints, of a case and of its variants.

struct ScalarResult {
  struct Value {
    double number = 0.0;  // [unit]  NaN where the run gives none
    std::string key;      // that of the quantity; of a life, that of the worst bearing
    std::string of_set;   // of several sets, the one with the worst bearing; else empty
  };

  std::string quantity;  // its key: "life_h", "displacement/radial_um"; of a life, that of one bearing
  std::string unit;      // of a life, "h" or "Mrev"; else empty: the key ends with it
  AnalysisId analysis = AnalysisId::quasi_static;
  double scatter = scatter::at_rest;
  /// Throws as the case's own analysis. May be called from several threads.
  std::function<Value(const ResolvedCase&)> compute;

  bool is_at_rest() const { return scatter < scatter::in_motion; }
};

/// The number at `key`, parts of a path joined by '/', of the run of the case at its operating point; without
/// a key the life that results go by, of the worst bearing. `fidelity`: empty where the user named none.
/// Throws BadInput where the case has none.
ScalarResult scalar_result(const ResolvedCase& resolved, const std::string& fidelity = "",
                           const std::string& key = "");

/// Result of the case itself. Throws BadInput or ComputationFailed where its run gives none.
ScalarResult::Value value_here(const ResolvedCase& resolved, const ScalarResult& result);

/// A slope by the offset of a number [result].
struct Slope {
  double value = 0.0;
  double error = 0.0;
  int side = 0;  // +1 or -1: to that side alone, where the other one is no case; 0: both
};

/// The step (1) for results of a scatter [-].
double step_for(double scatter);

/// Slope from results `here` and at the offsets -h and h, or with `side` +1 or -1 at h and 2 h to that side.
Slope slope_of(double here, const std::array<double, 2>& there, int side, double scatter);

/// Derivative by one number of the case. [result] is the unit of the result, [unit] the number's customary
/// one.
struct Derivative {
  std::string path;                  // of an element of a list with its index: "bearing.axial_places[0]"
  double value = 0.0;                // [unit]
  std::string unit;                  // "1" of a plain number
  std::string status;                // given, assumed or default
  double derivative = 0.0;           // [result/unit]
  double error = 0.0;                // [result/unit]  estimated
  std::optional<double> elasticity;  // [-]  d ln(result)/d ln(value); none where either is zero
  std::string step;                  // "1 um", "1 %": a change whose effect is stated
  double change = 0.0;               // [result]  by that step, to first order
  int side = 0;                      // as in Slope
};

/// A number or choice without a derivative, with the reason.
struct NoDerivative {
  std::string path;
  std::string given;
  std::string reason;
};

struct Derivatives {
  std::string quantity;            // "life_h", "L10r_Mrev" or the requested one
  std::string unit;                // "h", "Mrev" or empty
  double value = 0.0;              // [unit]
  std::string of_set;              // with several sets, the one with the worst bearing; else empty
  std::vector<Derivative> inputs;  // the largest elasticity first
  std::vector<NoDerivative> not_differentiable;  // used by the run
  std::vector<std::string> without_effect;       // the result does not follow them
};

struct DerivativeOptions {
  std::vector<std::string> paths{};                                   // of inputs; none: all
  int jobs = 0;                                                       // threads; 0: one for each core
  std::function<void(std::size_t done, std::size_t all)> progress{};  // one call at a time
  /// The result of the run of that name, by calling `compute` or from an earlier time; from several threads.
  std::function<double(const std::string& name, const std::function<double()>& compute)> remember =
      [](const std::string&, const std::function<double()>& compute) { return compute(); };
};

/// Derivatives of `result` at the case's operating point, where it is `here`, by two runs for each input.
Derivatives derivatives(const ResolvedCase& resolved, const ScalarResult& result,
                        const ScalarResult::Value& here, const DerivativeOptions& options = {});

void describe(described::Record& row, const Derivative& derivative);
void describe(described::Record& row, const NoDerivative& none);
void describe(described::Record& record, const Derivatives& derivatives);

/// One row for each input that the run uses; those without a derivative with their reason.
std::string derivatives_csv(const Derivatives& derivatives);

}  // namespace orbearing::app
