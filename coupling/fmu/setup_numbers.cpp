#include "coupling/fmu/setup_numbers.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace orbearing::fmu {

namespace {

using namespace bearing::profile;

// Members in the order in which they are written; one list serves both ways.
std::vector<double*> members_of(Straight&) {
  return {};
}
std::vector<double*> members_of(Chamfer& p) {
  return {&p.length, &p.chamfer_length, &p.depth};
}
std::vector<double*> members_of(CircularCrown& p) {
  return {&p.length, &p.end_drop};
}
std::vector<double*> members_of(StraightCircular& p) {
  return {&p.length, &p.straight_length, &p.end_drop};
}
std::vector<double*> members_of(Lundberg& p) {
  return {&p.length, &p.amplitude, &p.width_ratio};
}
std::vector<double*> members_of(JohnsGohar& p) {
  return {&p.length, &p.amplitude, &p.width_ratio};
}
std::vector<double*> members_of(Iso16281& p) {
  return {&p.length, &p.diameter, &p.scale};
}
std::vector<double*> members_of(FujiwaraKawase& p) {
  return {&p.length, &p.end_drop, &p.steepness, &p.crowned_fraction};
}
std::vector<double*> members_of(Table& p) {
  std::vector<double*> members{&p.scale};
  for (double& x : p.x) members.push_back(&x);
  for (double& drop : p.drop) members.push_back(&drop);
  return members;
}

[[noreturn]] void refuse(std::size_t found) {
  throw std::invalid_argument("profile in the model: found " + std::to_string(found) +
                              " numbers; required: those of a known kind");
}

// The variant's alternative at an index known at run time, empty but for the length of a table.
template <std::size_t I = 0>
Profile empty_profile(std::size_t position, std::size_t numbers) {
  if constexpr (I < std::variant_size_v<Profile>) {
    if (position != I) return empty_profile<I + 1>(position, numbers);
    std::variant_alternative_t<I, Profile> profile{};
    if constexpr (std::is_same_v<decltype(profile), Table>) {
      profile.x.resize(numbers < 2 ? 0 : (numbers - 2) / 2);
      profile.drop.resize(profile.x.size());
    }
    return profile;
  } else {
    refuse(numbers);
  }
}

}  // namespace

std::vector<double> to_numbers(const Profile& profile) {
  std::vector<double> numbers{static_cast<double>(profile.index())};
  Profile copy = profile;
  std::visit(
      [&](auto& p) {
        for (const double* member : members_of(p)) numbers.push_back(*member);
      },
      copy);
  return numbers;
}

void from_numbers(const std::vector<double>& numbers, Profile& profile) {
  if (numbers.empty() || !(numbers[0] >= 0.0 && numbers[0] < 100.0)) refuse(numbers.size());
  profile = empty_profile(static_cast<std::size_t>(numbers[0]), numbers.size());
  std::visit(
      [&](auto& p) {
        const std::vector<double*> members = members_of(p);
        if (members.size() + 1 != numbers.size()) refuse(numbers.size());
        for (std::size_t i = 0; i < members.size(); ++i) *members[i] = numbers[i + 1];
      },
      profile);
}

namespace {

constexpr double kConversion = 1e-12;  // [-]  by which a unit's factor may be off

// Whether `value` lies beyond `bound`, in a direction of +1 or -1.
bool beyond(double value, double bound, bool bound_allowed, double direction) {
  if (std::isinf(bound)) return false;
  const double excess = direction * (value - bound);
  return bound_allowed ? excess > kConversion * std::abs(bound) : excess >= 0.0;
}

std::string with_unit(double value, const FieldFacts& facts) {
  std::ostringstream text;
  text << value;
  if (facts.unit != "1") text << ' ' << facts.unit;
  return text.str();
}

std::string required(const FieldFacts& facts) {
  const described::Range& range = facts.range;
  std::string text;
  if (!std::isinf(range.least))
    text = (range.least_allowed ? "at least " : "greater than ") + with_unit(range.least, facts);
  if (!std::isinf(range.most))
    text += (text.empty() ? "" : " and ") + std::string(range.most_allowed ? "at most " : "less than ") +
            with_unit(range.most, facts);
  return text;
}

}  // namespace

FieldFacts field_facts(const described::Facts& facts, double none) {
  const described::Dimension& dimension = facts.details.dimension;
  described::Range range = facts.details.range;
  range.least *= dimension.factor;
  range.most *= dimension.factor;
  std::string unit = dimension.si.empty() ? "1" : std::string(dimension.si);
  if (unit == "Pa-1") unit = "1/Pa";
  return {facts.path, std::move(unit), facts.meaning, range, none};
}

void require_allowed(const FieldFacts& facts, double value) {
  const auto refuse = [&](const std::string& what) {
    throw std::invalid_argument(facts.name + ": found " + with_unit(value, facts) + "; required: " + what);
  };
  if (!std::isfinite(value)) refuse("a finite number");
  if (value == facts.none) return;
  if (beyond(value, facts.range.least, facts.range.least_allowed, -1.0) ||
      beyond(value, facts.range.most, facts.range.most_allowed, 1.0))
    refuse(required(facts));
}

double NumberReader::single(const described::Facts& facts, const std::vector<double>& values, double none,
                            bool shown) {
  if (shown) require_allowed(field_facts(facts, none), values.empty() ? 0.0 : values[0]);
  if (values.size() != 1)
    throw std::invalid_argument(facts.path + ": found " + std::to_string(values.size()) +
                                " numbers; required: 1");
  return values[0];
}

std::vector<double> to_numbers(const std::vector<double>& list) {
  return list;
}
void from_numbers(const std::vector<double>& numbers, std::vector<double>& list) {
  list = numbers;
}

std::vector<double> to_numbers(const std::vector<bearing::RaceHarmonic>& form) {
  std::vector<double> numbers;
  for (const bearing::RaceHarmonic& wave : form)
    numbers.insert(numbers.end(), {static_cast<double>(wave.order), wave.amplitude, wave.phase,
                                   static_cast<double>(wave.rotating)});
  return numbers;
}
void from_numbers(const std::vector<double>& numbers, std::vector<bearing::RaceHarmonic>& form) {
  form.clear();
  for (std::size_t i = 0; i + 3 < numbers.size(); i += 4)
    form.push_back({static_cast<int>(numbers[i]), numbers[i + 1], numbers[i + 2], numbers[i + 3] != 0.0});
}

std::vector<double> to_numbers(const gearset::PeriodicCurve& curve) {
  return curve.numbers();
}
void from_numbers(const std::vector<double>& numbers, gearset::PeriodicCurve& curve) {
  curve = gearset::PeriodicCurve::from_numbers(numbers);
}

// Window and shared compliance, number of slices, slices, length of the first curve, both curves.
std::vector<double> to_numbers(const std::shared_ptr<const gearset::LoadedTeeth>& teeth) {
  if (!teeth) return {};
  std::vector<double> numbers{teeth->begin(), teeth->end(), teeth->shared(),
                              static_cast<double>(teeth->slices().size())};
  for (const gearset::FaceSlice& slice : teeth->slices())
    numbers.insert(numbers.end(), {slice.ahead, slice.gap});
  const std::vector<double> stiffness = teeth->stiffness().numbers(), gap = teeth->gap().numbers();
  numbers.push_back(static_cast<double>(stiffness.size()));
  numbers.insert(numbers.end(), stiffness.begin(), stiffness.end());
  numbers.insert(numbers.end(), gap.begin(), gap.end());
  return numbers;
}
void from_numbers(const std::vector<double>& numbers, std::shared_ptr<const gearset::LoadedTeeth>& teeth) {
  teeth = nullptr;
  if (numbers.empty()) return;
  constexpr std::size_t head = 4;
  const auto count = [&](std::size_t at) {
    const double value = at < numbers.size() ? numbers[at] : -1.0;
    if (!(value >= 0.0 && value <= static_cast<double>(numbers.size())))
      throw std::invalid_argument("numbers of loaded teeth: found " + std::to_string(numbers.size()) +
                                  "; required: those of slices and of two curves");
    return static_cast<std::size_t>(value);
  };
  const std::size_t slices = count(head - 1), length_at = head + 2 * slices, stiffness = count(length_at);
  if (length_at + 1 + stiffness > numbers.size()) count(numbers.size());  // complains
  std::vector<gearset::FaceSlice> face;
  for (std::size_t i = head; i < length_at; i += 2) face.push_back({numbers[i], numbers[i + 1]});
  const auto from = numbers.begin() + static_cast<std::ptrdiff_t>(length_at + 1);
  const auto middle = from + static_cast<std::ptrdiff_t>(stiffness);
  teeth = std::make_shared<const gearset::LoadedTeeth>(
      gearset::PeriodicCurve::from_numbers({from, middle}),
      gearset::PeriodicCurve::from_numbers({middle, numbers.end()}), numbers[0], numbers[1], numbers[2],
      std::move(face));
}

std::vector<double> to_numbers(const Eigen::Matrix2Xd& matrix) {
  return {matrix.data(), matrix.data() + matrix.size()};
}
void from_numbers(const std::vector<double>& numbers, Eigen::Matrix2Xd& matrix) {
  matrix =
      Eigen::Map<const Eigen::Matrix2Xd>(numbers.data(), 2, static_cast<Eigen::Index>(numbers.size() / 2));
}

}  // namespace orbearing::fmu
