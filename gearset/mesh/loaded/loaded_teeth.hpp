// Force of a mesh whose teeth come into contact as its deflection closes their gaps, as a function of the
// deflection and of the position in the mesh period.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "gearset/mesh/periodic_curve.hpp"

namespace orbearing::gearset {

/// Force, stiffness and energy of a mesh at one deflection and one position in its period. Eqs. (6) to (9) of
/// gearset/mesh/loaded/README.md.
struct ToothForce {
  double force = 0.0;            // [N]    slope of the energy by the approach
  double stiffness = 0.0;        // [N/m]  slope of the force by the approach
  double energy = 0.0;           // [J]
  double energy_by_phase = 0.0;  // [J per mesh period]  slope of the energy at a fixed approach
};

/// A strip across the face.
struct FaceSlice {
  double ahead = 0.0;  // [mesh period]  of the middle of the face: helical teeth
  double gap = 0.0;    // [m]            that lead crown and slope leave
};

/// Pairs of teeth of one mesh in contact. The progress of a pair is counted in mesh periods from where it
/// touches without load; before 0 and after the contact ratio deflection must close a gap first.
class LoadedTeeth {
 public:
  static constexpr std::size_t most_contacts = 256;  // pairs times slices

  /// @param stiffness [N/m] of one pair over the whole face, bodies that all pairs share left out; over the
  ///        share of the way from `begin` to `end`
  /// @param gap [m] of one pair, over the same
  /// @param begin, end [mesh period] progress between which a pair is included
  /// @param shared [m/N] compliance of the bodies to the sum of the forces of all pairs
  /// @throws std::invalid_argument where there would be more than `most_contacts`
  LoadedTeeth(PeriodicCurve stiffness, PeriodicCurve gap, double begin, double end, double shared,
              std::vector<FaceSlice> slices)
      : stiffness_(std::move(stiffness)),
        gap_(std::move(gap)),
        begin_(begin),
        end_(end),
        shared_(shared),
        slices_(std::move(slices)) {
    const double pairs = std::floor(end - begin) + 1.0;
    if (!(end > begin) || slices_.empty() ||
        pairs * static_cast<double>(slices_.size()) > static_cast<double>(most_contacts))
      throw std::invalid_argument("loaded teeth: found " + std::to_string(pairs) + " pairs of " +
                                  std::to_string(slices_.size()) + " slices; required: some, at most " +
                                  std::to_string(most_contacts) + " in all");
  }

  /// @param position in the mesh period, any real number
  /// @param approach [m] of both gears along the line of action
  ToothForce at(double position, double approach) const {
    if (approach <= 0.0) return {};
    Contacts contacts;
    gather(position, contacts);
    // Own deflection of the teeth, beyond that of the shared bodies: a convex equation, from its steep side.
    double own = approach;
    for (int step = 0; step < most_steps; ++step) {
      const Sum sum = contacts.sum(own);
      const double excess = own + shared_ * sum.force - approach;
      const double next = own - excess / (1.0 + shared_ * sum.stiffness);
      if (excess <= round_off * approach || !(next < own)) break;
      own = next;
    }
    return whole(contacts, own);
  }

  /// The approach [m] at which the mesh has the force [N]. Without a force: where it just touches.
  double approach_under(double position, double force) const {
    Contacts contacts;
    gather(position, contacts);
    double own = contacts.bound(force);
    for (int step = 0; step < most_steps; ++step) {
      const Sum sum = contacts.sum(own);
      const double excess = sum.force - force;
      const double next = own - excess / sum.stiffness;
      if (excess <= round_off * force || !(next < own)) break;
      own = next;
    }
    return own + shared_ * force;
  }

  /// The same teeth, all `factor` times as stiff.
  LoadedTeeth times(double factor) const {
    return {stiffness_.times(factor), gap_, begin_, end_, shared_ / factor, slices_};
  }

  const PeriodicCurve& stiffness() const { return stiffness_; }
  const PeriodicCurve& gap() const { return gap_; }
  double begin() const { return begin_; }    // [mesh period]
  double end() const { return end_; }        // [mesh period]
  double shared() const { return shared_; }  // [m/N]
  const std::vector<FaceSlice>& slices() const { return slices_; }

 private:
  static constexpr int most_steps = 200;
  static constexpr double round_off = 4.0 * std::numeric_limits<double>::epsilon();

  // One slice of one pair.
  struct Contact {
    double stiffness, stiffness_by_phase, gap, gap_by_phase;
  };
  struct Sum {
    double force = 0.0, stiffness = 0.0;
  };
  struct Contacts {
    std::array<Contact, most_contacts> list;  // the first `count`
    std::size_t count = 0;

    Sum sum(double own) const {
      Sum total;
      for (std::size_t i = 0; i < count; ++i) {
        const double closed = own - list[i].gap;
        if (closed <= 0.0) continue;
        total.force += list[i].stiffness * closed;
        total.stiffness += list[i].stiffness;
      }
      return total;
    }
    // A deflection at which the force is not less than `force`: that of the slice which needs least.
    double bound(double force) const {
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < count; ++i)
        least = std::fmin(least, list[i].gap + force / list[i].stiffness);
      return least;
    }
  };

  void gather(double position, Contacts& contacts) const {
    const double width = end_ - begin_;
    const double share = 1.0 / static_cast<double>(slices_.size());
    const std::size_t all = slices_.size();
    std::size_t from = 0;  // contacts of the slice before
    for (std::size_t s = 0; s < all; ++s) {
      const std::size_t first = contacts.count;
      if (s > 0 && slices_[s].ahead == slices_[s - 1].ahead) {
        const double more = slices_[s].gap - slices_[s - 1].gap;
        for (std::size_t i = from; i < first; ++i) {
          contacts.list[contacts.count] = contacts.list[i];
          contacts.list[contacts.count++].gap += more;
        }
      } else {
        const double now = position + slices_[s].ahead;
        double progress = now + std::ceil(begin_ - now);
        for (; progress < end_ && contacts.count < most_contacts; progress += 1.0) {
          const double on_curve = std::fmin((progress - begin_) / width, below_one);
          const CurvePoint k = stiffness_.at(on_curve), g = gap_.at(on_curve);
          contacts.list[contacts.count++] = {share * k.value, share * k.slope / width,
                                             g.value + slices_[s].gap, g.slope / width};
        }
      }
      from = first;
    }
  }

  ToothForce whole(const Contacts& contacts, double own) const {
    ToothForce out;
    double stiffness = 0.0;
    for (std::size_t i = 0; i < contacts.count; ++i) {
      const Contact& c = contacts.list[i];
      const double closed = own - c.gap;
      if (closed <= 0.0) continue;
      const double force = c.stiffness * closed;
      stiffness += c.stiffness;
      out.force += force;
      out.energy += 0.5 * force * closed;
      out.energy_by_phase += 0.5 * c.stiffness_by_phase * closed * closed - force * c.gap_by_phase;
    }
    out.stiffness = stiffness / (1.0 + shared_ * stiffness);
    out.energy += 0.5 * shared_ * out.force * out.force;
    return out;
  }

  static constexpr double below_one = 1.0 - 1e-15;  // the curves are of period 1, the way is not

  PeriodicCurve stiffness_;
  PeriodicCurve gap_;
  double begin_ = 0.0;
  double end_ = 1.0;
  double shared_ = 0.0;
  std::vector<FaceSlice> slices_;
};

}  // namespace orbearing::gearset
