#include "coupling/diagnosis/resonance.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "gearset/dynamics/mode_kind.hpp"
#include "gearset/planet_angles.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::diagnosis {

namespace {

using gearset::dynamics::Mode;
using gearset::dynamics::ModeKind;

constexpr int kMetHarmonics = 4;     // with four planets each kind of mode has a harmonic among these
constexpr double kStillMode = 1e-3;  // of the largest frequency: a mode below is a free rotation
constexpr double kNear = 1.5;        // a resonance at a speed further off by this factor is not near
// Ratio of neighbouring speeds at which modes are computed: natural frequencies change little with speed, and
// smoothly. The speeds are powers of it [rpm], the same in every sweep, so that a point has one resonance.
constexpr double kSpeedRatio = 1.2;
constexpr double kRadiansPerSecond = constants::pi / 30.0;  // of 1 rpm
// Speed step beside a meeting, over its speed [-]: a bearing's stiffness falls within less if a roller loses
// its load, and the frequency of the mode with it.
constexpr double kBeside = 1e-4;

// Modes of one kind at one frequency of the set at rest. At speed a group of several splits.
int group_size(ModeKind kind, int planets) {
  if (kind == ModeKind::rotational) return 1;
  return kind == ModeKind::translational ? 2 : std::max(1, planets - 3);
}

const char* letter_of_kind(ModeKind kind) {
  if (kind == ModeKind::rotational) return "R";
  return kind == ModeKind::translational ? "T" : "P";
}

const NamedFrequency* same_mode(const NamedFrequency& mode, const ModesAtSpeed& point) {
  const auto found = std::find_if(point.modes.begin(), point.modes.end(), [&](const NamedFrequency& other) {
    return other.kind == mode.kind && other.rank == mode.rank;
  });
  return found == point.modes.end() ? nullptr : &*found;
}

std::vector<ModesAtSpeed> modes_between(double lowest, double highest, const ModesAt& modes_at) {
  std::vector<ModesAtSpeed> points;
  const double first = std::floor(std::log(lowest / kRadiansPerSecond / kNear) / std::log(kSpeedRatio));
  const double last = std::ceil(std::log(highest / kRadiansPerSecond * kNear) / std::log(kSpeedRatio));
  for (double power = first; power <= last; power += 1.0) try {
      points.push_back(modes_at(kRadiansPerSecond * std::pow(kSpeedRatio, power)));
    } catch (const std::runtime_error&) {
      continue;  // no equilibrium of the bearing there; its point of the sweep, if any, reports it
    }
  return points;
}

}  // namespace

std::string mode_name(ModeKind kind, int rank, int planets) {
  return letter_of_kind(kind) + std::to_string(rank / group_size(kind, planets) + 1);
}

std::vector<NamedFrequency> named_frequencies(const std::vector<Mode>& modes, int planets) {
  std::vector<NamedFrequency> list;
  std::map<ModeKind, int> rank;
  for (const Mode& mode : modes) {
    if (mode.frequency <= kStillMode * modes.back().frequency) continue;
    for (int i = 0; i < mode.multiplicity; ++i) {
      const int position = rank[mode.kind]++;
      list.push_back({mode_name(mode.kind, position, planets), mode.kind, position, mode.frequency});
    }
  }
  return list;
}

ModesAtSpeed named_modes_at(double speed, const gearset::dynamics::SetModel& model) {
  return {speed, model.operation.mesh_frequency,
          named_frequencies(modes_at_speed(model), model.parameters.planets)};
}

namespace {

/// A harmonic of the mesh frequency and a mode that lies above it at one speed and below at a higher one.
struct Crossing {
  int order = 0;
  NamedFrequency mode;                          // at the lower speed
  double lower = 0.0, upper = 0.0;              // [rad/s]
  double above_lower = 0.0, above_upper = 0.0;  // [Hz]  harmonic less mode
};

// By a root of the difference, in modes at the speed itself: those of neighbours would miss by up to a part
// in 500.
std::optional<Meeting> meeting_at(const Crossing& crossing, const ModesAt& modes_at) try {
  constexpr double same_speed = 1e-10;  // relative
  constexpr std::uintmax_t most = 60;
  const auto in = [&](const ModesAtSpeed& found) {
    const NamedFrequency* mode = same_mode(crossing.mode, found);
    if (!mode) throw std::runtime_error(crossing.mode.name);
    return mode->frequency;
  };
  const auto frequency_at = [&](double speed) { return in(modes_at(speed)); };
  const auto difference = [&](double speed) {
    const ModesAtSpeed found = modes_at(speed);
    return crossing.order * found.mesh_frequency - in(found);
  };
  const auto near = [&](double one, double other) { return std::abs(other - one) <= same_speed * other; };
  std::uintmax_t tries = most;
  const auto [low, high] = boost::math::tools::toms748_solve(
      difference, crossing.lower, crossing.upper, crossing.above_lower, crossing.above_upper, near, tries);
  Meeting meeting{crossing.order, crossing.mode, std::midpoint(low, high)};
  meeting.mode.frequency = crossing.order * modes_at(meeting.speed).mesh_frequency;
  meeting.change =
      frequency_at((1.0 + kBeside) * meeting.speed) - frequency_at((1.0 - kBeside) * meeting.speed);
  return meeting;
} catch (const std::runtime_error&) {
  return std::nullopt;  // no equilibrium of the bearing there
}

}  // namespace

std::vector<Meeting> meetings(const std::vector<ModesAtSpeed>& points, const gearset::PlanetarySet& set,
                              const ModesAt& modes_at) {
  std::vector<Meeting> list;
  const std::vector<double> positions = angles_of_planets(set);
  for (int order = 1; order <= kMetHarmonics; ++order)
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      for (const NamedFrequency& mode : points[i].modes) {
        const NamedFrequency* next = same_mode(mode, points[i + 1]);
        if (!next) continue;
        const double before = order * points[i].mesh_frequency - mode.frequency;
        const double after = order * points[i + 1].mesh_frequency - next->frequency;
        if (before > 0.0 || after <= 0.0) continue;
        std::optional<Meeting> meeting =
            meeting_at({order, mode, points[i].speed, points[i + 1].speed, before, after}, modes_at);
        if (!meeting) continue;
        meeting->excited = excites(positions, order * set.sun_teeth, mode.kind);
        list.push_back(std::move(*meeting));
      }
  return list;
}

std::vector<Meeting> resonances(double lowest, double highest, const gearset::PlanetarySet& set,
                                const ModesAt& modes_at) {
  std::vector<Meeting> list = meetings(modes_between(lowest, highest, modes_at), set, modes_at);
  std::erase_if(list, [](const Meeting& meeting) { return !meeting.excited; });
  std::sort(list.begin(), list.end(),
            [](const Meeting& one, const Meeting& other) { return one.speed < other.speed; });
  return list;
}

bool is_near(double one, double other) {
  return one <= kNear * other && kNear * one >= other;
}

}  // namespace orbearing::diagnosis
