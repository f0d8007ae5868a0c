// Line contact of a roller with one race, cut into laminae that do not affect each other, after [ISO16281]:
// q_k = c/n (a + tilt x_k - P_k)^(10/9) where that is positive, else 0.
//
//      race  ____________________________            x: along the axis from the middle
//            \\\\\\ |   |   |   |   | ///             a: approach of the bodies at x = 0
//      roller  '-.._|___|___|___|__.-'                end displacement: what x = l/2 approaches more
//                          |--> x                     P: drop of both profiles
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "bearing/contact/lamina_kernel.hpp"
#include "bearing/contact/line_contact.hpp"
#include "bearing/profile/profile.hpp"
#include "mechanics/packs/instruction_set.hpp"

namespace orbearing::bearing::laminae {

/// Middles of `n` equal laminae as fractions of half the length, -1 to 1, [ISO16281]: (2k - 1)/n - 1.
std::vector<double> lamina_positions(int n);

/// Drop [m] of both bodies at the middles of `n` laminae of a contact of `length` [m].
std::vector<double> lamina_drops(const profile::Profile& roller, const profile::Profile& race, double length,
                                 int n);

/// Load of a contact and how it follows the approach. Moments are divided by half the length, tilts
/// multiplied.
struct LaminaForce {
  double load = 0.0;                 // [N]
  double end_load = 0.0;             // [N]    moment about the middle over l/2
  double by_approach = 0.0;          // [N/m]  d(load)/d(approach)
  double mixed = 0.0;                // [N/m]  d(load)/d(end displacement) = d(end load)/d(approach)
  double by_end_displacement = 0.0;  // [N/m]  d(end load)/d(end displacement)
};

class LaminaContact {
 public:
  /// `whole`: the same contact uncut, straight. `drops` [m], one for each lamina, are those of both bodies.
  /// Throws std::invalid_argument where there are none, more than 1000, or one is not finite.
  LaminaContact(const LineContact& whole, double length, std::span<const double> drops,
                mechanics::InstructionSet set = mechanics::best_instruction_set());

  /// At `approach` [m] in the middle and `end_displacement` [m] more at x = l/2.
  LaminaForce evaluate(double approach, double end_displacement) const;
  /// Elastic energy [J]; its slopes by approach and end displacement are load and end load.
  double energy(double approach, double end_displacement) const;
  /// Loads [N] of the laminae.
  Eigen::ArrayXd loads(double approach, double end_displacement) const;
  /// The same into an array of that many.
  void put_loads(double approach, double end_displacement, double* load) const;

  int laminae() const { return laminae_; }
  /// The same contact uncut, straight.
  const LineContact& whole() const { return whole_; }
  double half_length() const { return half_length_; }  // [m]
  /// Smallest drop [m]: below this approach and with no end displacement nothing touches.
  double least_drop() const { return least_drop_; }
  double greatest_drop() const { return greatest_drop_; }  // [m]
  /// Fractions of half the length.
  Eigen::Map<const Eigen::ArrayXd> positions() const { return {position_.data(), laminae_}; }
  Eigen::Map<const Eigen::ArrayXd> drops() const { return {drop_.data(), laminae_}; }  // [m]

 private:
  LineContact whole_;
  double scale_;  // [N/m^(10/9)]  c/n
  double half_length_;
  double least_drop_;
  double greatest_drop_;
  int laminae_;
  int padded_;
  std::vector<double> position_;  // [-]  (padded)
  std::vector<double> drop_;      // [m]  (padded)
  const vectorised::LaminaKernel* kernel_;
};

/// Approach [m] in the middle of an aligned contact under `load` [N].
double approach_under(const LaminaContact& contact, double load);

}  // namespace orbearing::bearing::laminae
