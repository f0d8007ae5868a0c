#include "app/study/life_derivatives.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <exception>

#include "app/case/unused_inputs.hpp"
#include "app/errors.hpp"
#include "app/study/differentiated_life.hpp"
#include "mechanics/explicit_slope.hpp"

namespace orbearing::app {

namespace {

// One number of the case: that of an input, or an element of its list.
struct CaseNumber {
  const Input& input;
  std::optional<std::size_t> item;

  std::string path() const { return item ? fmt::format("{}[{}]", input.path, *item) : input.path; }
  double value(const ResolvedCase& in) const {  // [SI]
    return item ? in.value(input.path).list.at(*item) : in.value(input.path).number;
  }
  // As it would be written in a case with another value of this number.
  std::string text(const ResolvedCase& in, double value) const {
    const auto written = [&](double one) {
      const std::string_view si = input.field->dimension.si;
      return si.empty() ? fmt::format("{:.17g}", one) : fmt::format("{:.17g} {}", one, si);
    };
    if (!item) return written(value);
    std::vector<std::string> all;
    const std::vector<double>& list = in.value(input.path).list;
    for (std::size_t i = 0; i < list.size(); ++i) all.push_back(written(i == *item ? value : list[i]));
    return fmt::format("[{}]", fmt::join(all, ", "));
  }
};

std::string_view customary(const Field& field) {
  return field.dimension.customary.empty() ? "1" : field.dimension.customary;
}

// [SI/customary]
double per_customary(const Field& field) {
  return field.dimension.si.empty()
             ? 1.0
             : convert(1.0, field.dimension.customary, field.dimension.si).value.value_or(1.0);
}

// What the case says at another value. Throws BadInput where that is no case.
class NumbersAt {
 public:
  NumbersAt(const ResolvedCase& in, const DifferentiatedLife& life, const CaseNumber& number)
      : in_(in), life_(life), number_(number), value_(number.value(in)) {}

  Eigen::VectorXd operator()(double offset) const {
    const double wanted = value_ + offset;
    const ResolvedCase changed = in_.with(number_.input.path, number_.text(in_, wanted));
    constexpr double round_off = 1e-12;
    if (std::abs(number_.value(changed) - wanted) > round_off * std::abs(wanted)) throw Follows();
    return life_.numbers(changed);
  }
  double value() const { return value_; }

  struct Follows {};  // another input decides the number

 private:
  const ResolvedCase& in_;
  const DifferentiatedLife& life_;
  const CaseNumber& number_;
  double value_;
};

std::string one_line(const std::exception& error) {
  const std::string text = error.what();
  return text.substr(0, text.find('\n'));
}

// Slopes below this change nothing of the life but its last digits.
constexpr double kRoundOff = 1e-10;  // [-]  of ln of the life

class SlopeSearch {
 public:
  using Found = std::variant<NumberSlope, std::string>;

  SlopeSearch(const NumbersOf& numbers, const SlopeBy& of_life, const Eigen::VectorXd& here, double scale)
      : numbers_(numbers), of_life_(of_life), here_(here), scale_(scale) {}

  Found operator()() const {
    constexpr double kFirstStep = 1e-3;
    const double step = kFirstStep * scale_;
    std::string why;
    for (const int side : {0, 1, -1}) {
      try {
        return with_steps_from(step, side);
      } catch (const std::exception& error) {  // no case there
        if (why.empty()) why = one_line(error);
      }
    }
    return "the case allows no other value nearby: " + why;
  }

 private:
  Found with_steps_from(double step, int side) const {
    constexpr double kShorter = 0.1, kGood = 1e-9, kFair = 1e-7;
    constexpr int kTrials = 4;
    std::optional<OneStep> best;
    const auto within = [&](double share) {
      return best->slope.error <= share * std::max(1.0, std::abs(best->slope.value));
    };
    NumberSlope first, before;
    for (int i = 0; i < kTrials && !(best && within(kGood)); ++i, step *= kShorter) {
      OneStep one = slope(step, side);
      if (i == 0)
        first = one.slope;
      else
        one.slope.error = doubt(one.slope, first, before);
      before = one.slope;
      if (!best || one.slope.error < best->slope.error) best = one;
    }
    if (best->kink) return "the life has a kink here: its slopes to both sides differ";
    if (!within(kFair))
      return fmt::format("no smooth map leads from it to the balance: its slope is known to {:.1g} only",
                         best->slope.error);
    return best->slope;
  }

  // What follows a step that was no good must agree with its neighbour, and with the first within what that
  // one is worth: a map in stairs is flat, without an error of its own, under steps that are short enough.
  static double doubt(const NumberSlope& one, const NumberSlope& first, const NumberSlope& before) {
    constexpr double kApart = 10.0;
    const double from_first = std::abs(one.value - first.value),
                 from_before = std::abs(one.value - before.value);
    const bool apart = from_first > kApart * (first.error + one.error);
    return std::max({one.error, from_before, apart ? from_first : 0.0});
  }

  struct OneStep {
    NumberSlope slope;
    bool kink = false;
  };

  OneStep slope(double step, int side) const {
    const mechanics::ExplicitSlope map = side == 0 ? mechanics::central_slope(numbers_, here_, step)
                                                   : mechanics::one_sided_slope(numbers_, here_, side * step);
    if (side == 0 && map.slope.isZero(0.0) && map.bend.isZero(0.0)) return {};
    const auto of_life = [&](const Eigen::VectorXd& change) { return scale_ * of_life_(change); };
    OneStep result{{of_life(map.slope), std::abs(of_life(map.last_change)), side}};
    if (side == 0) {
      constexpr double kNothing = 1e-6;
      const double far = std::abs(of_life(map.bend)), near = std::abs(of_life(map.bend_near));
      result.kink = near > kNothing && near > 0.7 * far;
    }
    return result;
  }

  const NumbersOf& numbers_;
  const SlopeBy& of_life_;
  const Eigen::VectorXd& here_;
  double scale_;
};

std::string standing_text(const ResolvedCase& in, const std::string& path) {
  if (in.origin(path) == "default") return "default";
  return in.assumed().contains(path) ? "assumed" : "given";
}

// The effect is stated of one micrometre for lengths of micrometres, of one unit for what is zero, else of a
// hundredth.
LifeDerivative derivative_of(const ResolvedCase& in, const DifferentiatedLife& life, const CaseNumber& number,
                             const NumberSlope& slope, double scale) {
  const Field& field = *number.input.field;
  const double unit = per_customary(field), value = number.value(in);
  LifeDerivative result{.path = number.path(),
                        .value = value / unit,
                        .unit = std::string(customary(field)),
                        .standing = standing_text(in, number.input.path),
                        .derivative = life.value * slope.value / scale * unit,
                        .side = slope.side};
  if (value != 0.0) result.elasticity = slope.value * value / scale;
  const bool by_unit = value == 0.0 || field.dimension.customary == dimension::small_length.customary;
  result.step = by_unit ? fmt::format("1 {}", result.unit) : "1 %";
  result.change = result.derivative * (by_unit ? 1.0 : 0.01 * result.value);
  return result;
}

// Why an input of that kind has no derivative; none where its numbers have.
std::optional<std::string> reason_of_kind(const Field& field) {
  switch (field.kind) {
    case Kind::integer:
      return "a whole number";
    case Kind::flag:
      return "on or off";
    case Kind::choice:
      return "a choice";
    case Kind::list:
      if (!field.columns.empty()) return "a table of rows, which are not one number each";
      if (field.element == Kind::quantity || field.element == Kind::number) return std::nullopt;
      return field.element == Kind::integer ? "whole numbers" : "a list of what is no number";
    default:
      return std::nullopt;
  }
}

class Collector {
 public:
  explicit Collector(const ResolvedCase& in)
      : in_(in), life_(differentiated_life(in)), here_(life_.numbers(in)) {
    result_.quantity = life_.quantity;
    result_.unit = life_.unit;
    result_.life = life_.value;
    result_.of_set = life_.of_set;
  }

  void add(const Input& input) {
    const Field& field = *input.field;
    if (field.kind == Kind::text || input.path == "model") return;
    if (field.kind == Kind::list && field.element == Kind::text) return;  // names
    if (standing_in_row(in_, input, life_.analysis) != Standing::used) {
      result_.without_effect.push_back(input.path);
      return;
    }
    if (const auto reason = reason_of_kind(*input.field)) {
      result_.not_differentiable.push_back({input.path, in_.given(input.path), *reason});
      return;
    }
    if (input.field->kind != Kind::list) return add({input, std::nullopt});
    for (std::size_t i = 0; i < in_.value(input.path).list.size(); ++i) add({input, i});
  }

  LifeDerivatives result() && {
    const auto weight = [&](const LifeDerivative& one) {
      constexpr double hundred = 100.0;
      return std::abs(one.elasticity.value_or(hundred * one.change / life_.value));
    };
    std::stable_sort(result_.inputs.begin(), result_.inputs.end(),
                     [&](const LifeDerivative& a, const LifeDerivative& b) { return weight(a) > weight(b); });
    return std::move(result_);
  }

 private:
  void add(const CaseNumber& number) {
    const NumbersAt numbers(in_, life_, number);
    const double unit = per_customary(*number.input.field);
    const double scale = numbers.value() != 0.0 ? std::abs(numbers.value()) : unit;
    try {
      const auto slope = slope_by_number(std::cref(numbers), life_.slope, here_, scale);
      if (const auto* reason = std::get_if<std::string>(&slope))
        result_.not_differentiable.push_back({number.path(), in_.given(number.input.path), *reason});
      else if (std::abs(std::get<NumberSlope>(slope).value) < kRoundOff)
        result_.without_effect.push_back(number.path());
      else
        result_.inputs.push_back(derivative_of(in_, life_, number, std::get<NumberSlope>(slope), scale));
    } catch (const NumbersAt::Follows&) {
      result_.not_differentiable.push_back(
          {number.path(), in_.given(number.input.path), "another input decides it"});
    } catch (const std::exception& error) {
      result_.not_differentiable.push_back({number.path(), in_.given(number.input.path), one_line(error)});
    }
  }

  const ResolvedCase& in_;
  DifferentiatedLife life_;
  Eigen::VectorXd here_;
  LifeDerivatives result_;
};

}  // namespace

std::variant<NumberSlope, std::string> slope_by_number(const NumbersOf& numbers, const SlopeBy& of_life,
                                                       const Eigen::VectorXd& here, double scale) {
  return SlopeSearch(numbers, of_life, here, scale)();
}

LifeDerivatives life_derivatives(const ResolvedCase& resolved, const std::vector<std::string>& paths) {
  const ResolvedCase in = resolved.without_sweep();
  Collector collector(in);
  for (const Input& input : in.inputs())
    if (in.has(input.path) &&
        (paths.empty() || std::find(paths.begin(), paths.end(), input.path) != paths.end()))
      collector.add(input);
  return std::move(collector).result();
}

}  // namespace orbearing::app
