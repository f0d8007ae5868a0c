#include "coupling/cosim/coupled_integration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "coupling/integration/gear_steps.hpp"
#include "coupling/integration/in_place.hpp"
#include "coupling/integration/integrate_bearing.hpp"
#include "coupling/integration/window.hpp"

namespace orbearing::cosim {

namespace {

using bearing::dynamics::BoreMotion;

constexpr double kFirstStep = 1e-6;  // [s]
constexpr double kSavedSystemKind = 30002.0;
constexpr std::ptrdiff_t kSavedSystemHead = 4;
// Errors that linearly implicit steps may make in the gears, over those of dopri5.
constexpr double kGearErrorFactor = 100.0;
constexpr double kLongestPiece = 1.0;  // [s]  where nothing jumps

CoupledModel checked_model(const CoupledSetup& setup) {
  CoupledModel model = coupled_model(setup);
  if (!bearing::fast::supports(model.bearing))
    throw std::invalid_argument(
        "monolithic solution: found oil in the pockets; required: pockets without film, as the vectorised "
        "bearing knows them");
  return model;
}

CoupledStepOptions step_options(const CoupledSetup& setup, const CoupledModel& model,
                                const CoupledSystem& system) {
  const Eigen::VectorXd gears =
      kGearErrorFactor * integration::gear_allowed_errors(model.gears, setup.gears.allowed_share);
  return {.gears = {gears.begin(), gears.end()},
          .bearing = integration::linearly_implicit_errors(
              system.bearing(0),
              integration::bearing_allowed_errors(model.bearing.layout, setup.bearing.allowed_length_error,
                                                  model.bearing.geometry.pitch_radius,
                                                  integration::roller_frequency(model.bearing))),
          .longest_step = integration::longest_step(model.bearing),
          .most_refined = setup.most_refined,
          .most_steps = setup.bearing.most_steps};
}

// State between two steps, as in integrate_bearing(): `count` positions from `position`, their velocities
// from `velocity`; all are in a straight line already.
struct Bend {
  double share, length;  // [-] of the step, [s]
  const std::vector<double>&from, &to;
  std::vector<double>& x;

  void operator()(std::ptrdiff_t position, std::ptrdiff_t velocity, std::ptrdiff_t count) const {
    const double rise = share * (1.0 - share);
    for (std::ptrdiff_t i = 0; i < count; ++i) {
      const auto p = static_cast<std::size_t>(position + i), v = static_cast<std::size_t>(velocity + i);
      const double mean = to[p] - from[p];
      x[p] += rise * ((1.0 - share) * (length * from[v] - mean) - share * (length * to[v] - mean));
    }
  }
};

}  // namespace

CoupledIntegration::CoupledIntegration(const CoupledSetup& setup)
    : setup_(setup),
      model_(checked_model(setup)),
      system_(model_, setup.bearing.places),
      stepper_(system_, step_options(setup, model_, system_)),
      x_(system_.size(), 0.0),
      before_(x_),
      shown_(x_),
      turned_(static_cast<std::size_t>(system_.bearings()), 0.0),
      angle_(turned_) {}

void CoupledIntegration::start(double time, const CoupledStart& start) {
  time_ = reached_ = reached_before_ = time;
  step_ = kFirstStep;
  following_ = false;
  std::fill(x_.begin(), x_.end(), 0.0);
  std::copy(start.gears.begin(), start.gears.end(), x_.begin());
  for (int b = 0; b < system_.bearings(); ++b) {
    const auto padded = system_.bearing(b).padded(start.bearings[static_cast<std::size_t>(b)]);
    std::copy(padded.begin(), padded.end(), system_.of_bearing(x_.data(), b));
  }
  system_.settle(0.0, x_);
  show_all();
  forget();
}

void CoupledIntegration::forget() {
  for (int b = 0; b < system_.bearings(); ++b) {
    const auto place = static_cast<std::size_t>(b);
    turned_[place] = 0.0;
    angle_[place] = motion(b).angle;
    system_.loads[place].step_before = 0.0;
    system_.sums[place] = system_.no_damage(setup_.bearing.places);
  }
}

CoupledIntegration::Piece CoupledIntegration::piece_from(double begin) const {
  const double close = 4e-16 * std::abs(begin) + 1e-15;  // [s]  round-off of the times
  const integration::Jumps jumps = integration::jumps_of(model_.gears, begin);
  if (!jumps.time) return {begin, begin + kLongestPiece};
  long jump = 0;
  while (jumps.time(jump) <= begin + close) ++jump;
  return {begin, jumps.time(jump)};
}

void CoupledIntegration::enter(const Piece& piece) {
  piece_ = piece;
  const double margin =
      std::min(integration::jumps_of(model_.gears).margin, 0.25 * (piece.end - piece.begin));
  system_.set_piece(piece.begin, piece.begin + margin, piece.end - margin);
}

void CoupledIntegration::one_step() {
  const double length = piece_.end - piece_.begin;
  long attempts = 0;
  integration::step_within_window(stepper_, system_, x_, piece_.done, length,
                                  {.most_steps = setup_.bearing.most_steps}, step_, attempts);
  reached_ = piece_.done >= length ? piece_.end : piece_.begin + piece_.done;
}

void CoupledIntegration::advance(const Window& window) {
  if (following_)
    throw std::runtime_error("monolithic solution: found a window after follow(); required: one of both");
  const double close = 4e-16 * std::abs(window.end) + 1e-15;  // [s]
  const long most = system_.steps + setup_.bearing.most_steps;
  reached_ = window.begin;
  while (reached_ < window.end) {
    Piece piece = piece_from(reached_);
    if (piece.end >= window.end - close) piece.end = window.end;
    enter(piece);
    while (reached_ < piece.end) {
      if (system_.steps >= most)
        throw std::runtime_error("monolithic solution: the largest number of steps was taken");
      one_step();
    }
  }
  show_all();
  count_turns();
  require_in_place();
}

void CoupledIntegration::follow(double time) {
  if (!following_) {
    following_ = true;
    enter(piece_from(reached_));
  }
  while (reached_ < time) {
    if (reached_ >= piece_.end) enter(piece_from(piece_.end));
    before_ = x_;
    reached_before_ = reached_;
    one_step();
  }
  show(time);
  count_turns();
  require_in_place();
}

void CoupledIntegration::show_all() {
  shown_ = x_;
  time_ = reached_;
}

void CoupledIntegration::show(double time) {
  const double length = reached_ - reached_before_;
  if (!(length > 0.0)) return show_all();
  const double share = (time - reached_before_) / length;
  for (std::size_t i = 0; i < x_.size(); ++i) shown_[i] = before_[i] + share * (x_[i] - before_[i]);
  const Bend bend{share, length, before_, x_, shown_};
  bend(0, freedoms(), freedoms());
  const bearing::fast::PaddedLayout& layout = system_.bearing(0).layout();
  for (int b = 0; b < system_.bearings(); ++b) {
    const std::ptrdiff_t first = system_.offset(b);
    bend(first, first + 2 * layout.lanes(), 2 * layout.lanes());
    bend(first + layout.cage(), first + layout.cage() + 3, 3);
    bend(first + layout.pin(), first + layout.pin() + 2, 2);
  }
  system_.settle(0.0, shown_);
  time_ = time;
}

void CoupledIntegration::count_turns() {
  for (int b = 0; b < system_.bearings(); ++b) {
    const auto place = static_cast<std::size_t>(b);
    const double now = motion(b).angle;
    turned_[place] += std::abs(now - angle_[place]);
    angle_[place] = now;
  }
}

void CoupledIntegration::require_in_place() const {
  for (int b = 0; b < system_.bearings(); ++b) {
    const std::string reason = integration::out_of_place(model_.bearing, bearing_state(b));
    if (reason.empty()) continue;
    std::ostringstream text;
    text << "bearing " << b + 1 << " at t = " << time_ << " s: " << reason;
    throw std::runtime_error(text.str());
  }
}

Eigen::VectorXd CoupledIntegration::gear_state() const {
  return Eigen::Map<const Eigen::VectorXd>(shown_.data(), 2 * freedoms());
}

Eigen::VectorXd CoupledIntegration::bearing_state(int b) const {
  Eigen::VectorXd flat(model_.bearing.layout.size());
  system_.bearing(b).flatten(system_.of_bearing(shown_.data(), b), flat);
  return flat;
}

BoreMotion CoupledIntegration::motion(int b) const {
  return bore_motion(model_, model_.port_of(b), time_, system_.part(shown_.data(), 0),
                     system_.part(shown_.data(), freedoms()));
}

// Every number of the state in turn, for `visit(double* first, size)`.
template <class Visit>
void CoupledIntegration::each(Visit visit) {
  visit(&reached_, 1);
  visit(&step_, 1);
  for (std::vector<double>* all : {&x_, &turned_, &angle_})
    visit(all->data(), static_cast<long>(all->size()));
  for (std::size_t b = 0; b < turned_.size(); ++b) {
    visit(&system_.loads[b].step_before, 1);
    system_.sums[b].each(visit);
  }
}

SavedState CoupledIntegration::saved() {
  if (following_)
    throw std::runtime_error("monolithic solution: found follow() before save; required: windows alone");
  SavedState all{kSavedSystemKind, static_cast<double>(model_.bearing.layout.rollers),
                 static_cast<double>(system_.bearings()), static_cast<double>(freedoms())};
  each([&](const double* first, long size) { all.insert(all.end(), first, first + size); });
  return all;
}

bool CoupledIntegration::put(const SavedState& state) {
  const SavedState own = saved();
  if (state.size() != own.size() || !std::equal(own.begin(), own.begin() + kSavedSystemHead, state.begin()))
    return false;
  auto from = state.begin() + kSavedSystemHead;
  each([&](double* first, long size) {
    std::copy_n(from, size, first);
    from += size;
  });
  show_all();
  return true;
}

}  // namespace orbearing::cosim
