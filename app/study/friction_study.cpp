#include "app/study/friction_study.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

#include "app/case/catalogue_case.hpp"
#include "app/case/described_case.hpp"
#include "app/case/oil_case.hpp"
#include "app/case/static_case.hpp"
#include "app/errors.hpp"
#include "bearing/default_design.hpp"
#include "bearing/equilibrium/row_group.hpp"
#include "bearing/film/oil_grade.hpp"
#include "bearing/friction/thermal_reference.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::app {

namespace {

namespace friction = bearing::friction;
using bearing::equilibrium::RingState;
namespace dimension = described::dimension;
using described::Record;

double speed_of(const ResolvedCase& in) {
  return std::abs(in.quantity("operation.shaft_speed") - in.quantity("operation.outer_speed"));
}

// The mineral oil that has `viscosity` [m^2/s] at the temperature of the reference conditions, which is the
// default temperature of an oil too.
std::optional<bearing::OilGrade> oil_with(double viscosity) {
  const auto excess = [&](double log_grade) {
    return std::log(bearing::kinematic_viscosity({.viscosity_40 = std::exp(log_grade)},
                                                 friction::thermal_reference::kTemperature) /
                    viscosity);
  };
  const double thin = std::log(7e-6), thick = std::log(3200e-6);
  if (excess(thin) > 0.0 || excess(thick) < 0.0) return std::nullopt;
  std::uintmax_t steps = 100;
  const auto [below, above] = boost::math::tools::toms748_solve(
      excess, thin, thick, boost::math::tools::eps_tolerance<double>(40), steps);
  return bearing::OilGrade{.viscosity_40 = std::exp(0.5 * (below + above))};
}

// With the parts on which the drag depends.
bearing::Bearing with_rings(bearing::Bearing bearing, const friction::BearingSize& size) {
  bearing.inner.seat_diameter = size.bore;
  bearing.outer.seat_diameter = size.outside;
  bearing.width = size.width;
  constexpr double no_length = 0.0, polyamide = 1310.0;
  const bearing::CageSize cage =
      bearing::default_cage_size(bearing.pitch_diameter, bearing.element_diameter(),
                                 bearing.has_rollers() ? bearing.rollers().length : no_length, size.width);
  bearing.cage = {.inner_diameter = cage.inner_diameter,
                  .outer_diameter = cage.outer_diameter,
                  .width = cage.width,
                  .density = polyamide};
  return bearing;
}

void put_torque(Record& record, double torque, const FrictionByStandards& standards) {
  record.value("torque_N_mm", dimension::small_torque, "in all", torque).symbol = "M";
  record.value("power_W", dimension::heat, "the same times the speed", torque * standards.ours.speed);
  record.value("ours_over_it", dimension::ratio, "our torque over it", standards.ours.torque / torque);
}

template <class Standards>
void put_parted(Record& record, const friction::PartedTorque& torque, const Standards& standards) {
  record.value("load_free_N_mm", dimension::small_torque, "by viscosity and speed", torque.load_free).symbol =
      "M_0";
  record.value("load_dependent_N_mm", dimension::small_torque, "by the load", torque.load_dependent).symbol =
      "M_1";
  put_torque(record, torque.total(), standards);
}

}  // namespace

void describe(Record& record, const FrictionStudy& study) {
  const friction::RollingFriction& loss = study.loss;
  record.value("power_W", dimension::heat,
               "friction at pure rolling, in all; mean over positions of the cage", loss.total());
  record.value("least_power_W", dimension::heat, "the same at the position of the cage where it is least",
               study.least);
  record.value("most_power_W", dimension::heat, "the same at the position where it is greatest", study.most);
  record.value("torque_N_mm", dimension::small_torque, "the same over the speed", study.ours().torque);
  if (study.oil_temperature)
    record.value("oil_temperature_degC", dimension::temperature, "at which the oil leaves with that heat",
                 *study.oil_temperature);
  record.value(
      "rolling_W", dimension::heat,
      "shear of the oil at the inlets, which it warms; of rollers as far as the mixture's oil reaches",
      loss.rolling);
  record.value("flooded_rolling_W", dimension::heat, "the same with oil at any distance",
               loss.flooded_rolling);
  record.value("isothermal_rolling_W", dimension::heat, "the same if its shear did not warm it either",
               loss.isothermal_rolling);
  if (loss.regression_rolling > 0.0)
    record.value("regression_rolling_W", dimension::heat,
                 "rolling_W of rollers by the regression of [ZhouHoeprich1991]", loss.regression_rolling);
  record.value("idle_W", dimension::heat, "of it: of elements outside the load zone, on the outer race",
               loss.idle);
  record.value("differential_slip_W", dimension::heat, "because ellipses are curved (Heathcote)",
               loss.differential_slip);
  record.value("spin_W", dimension::heat, "turning about the normals of the contacts", loss.spin);
  record.value("drag_W", dimension::heat, "drag and churning of the oil-air mixture", loss.drag);
}

void describe(Record& record, const FrictionByStandards& standards) {
  record.child("palmgren", "by f_0 and f_1 of the series", standards,
               [](Record& one, const auto& of) { put_parted(one, of.palmgren, of); });
  record.child("iso_tr_14179_2", "by f_0 and f_1 of the type", standards,
               [](Record& one, const auto& of) { put_parted(one, of.gear_unit, of); });
  record.child("skf", "without drag of an oil bath", standards, [](Record& one, const auto& of) {
    one.value("rolling_N_mm", dimension::small_torque, "with both factors", of.skf.rolling).symbol = "M_rr";
    one.value("sliding_N_mm", dimension::small_torque, "of the contacts", of.skf.sliding).symbol = "M_sl";
    one.value("inlet_heating", dimension::ratio, "factor of heating at the inlet", of.skf.inlet_heating)
        .symbol = "phi_ish";
    one.value("starvation", dimension::ratio, "factor of starvation, oil jet or low bath", of.skf.starvation)
        .symbol = "phi_rs";
    put_torque(one, of.skf.total(), of);
  });
  const double heating = standards.skf.inlet_heating, both = heating * standards.skf.starvation;
  const OurFriction& ours = standards.ours;
  const auto with_factor = [&](double factor) {
    return (ours.torque - ours.rolling + factor * ours.isothermal) * ours.speed;
  };
  record.value("ours_with_inlet_heating_W", dimension::heat,
               "our power, its isothermal rolling part times phi_ish", with_factor(heating));
  record.value("ours_with_starvation_W", dimension::heat,
               "our power, its isothermal rolling part times phi_ish and phi_rs", with_factor(both));
  record
      .value("reference_heat_W", dimension::heat, "of the thermal reference speed, by the size",
             friction::thermal_reference::heat(standards.size))
      .symbol = "Phi_r";
  record.value("ours_over_reference_heat", dimension::ratio, "our power over it",
               ours.torque * ours.speed / friction::thermal_reference::heat(standards.size));
}

namespace {

// Oil as contacts have it.
struct OilInContacts {
  bearing::Lubricant lubricant;
  double viscosity_slope = 0.0;  // [1/K]  by which its viscosity falls
};

OilInContacts oil_at(const bearing::OilGrade& oil, double temperature) {
  return {bearing::lubricant_at(oil, temperature), bearing::viscosity_slope(oil, temperature)};
}

// Oil of a case that states its viscosity, by grade or directly; none where it states neither, or a viscosity
// that no mineral oil has at the default temperature.
std::optional<bearing::OilGrade> oil_of(const ResolvedCase& in) {
  if (in.has("lubricant.grade")) return graded_oil(in);
  if (!in.has("lubricant.kinematic_viscosity")) return std::nullopt;
  return oil_with(in.quantity("lubricant.kinematic_viscosity"));
}

friction::Inlets roller_inlets(const ResolvedCase& in, const std::optional<friction::BearingSize>& size,
                               const OilInContacts& oil, double speed, double viscosity) {
  using bearing::motion::Starvation;
  friction::Inlets inlets{oil.viscosity_slope, friction::InletEnd::layer};
  const Starvation starvation = from_case<bearing::motion::RaceContactParameters>(in).starvation;
  if (starvation == Starvation::replenished) inlets.end = friction::InletEnd::replenished;
  if (starvation == Starvation::skf && size)
    inlets.starvation =
        friction::starvation_factor(size->bore, size->outside, friction::type_constant(size->family),
                                    {.speed = speed, .viscosity = viscosity});
  return inlets;
}

// Equilibria with the first element at even positions over a pitch, the stated one among them: rollers enter
// and leave the load zone as the cage rotates.
class OverPitch {
 public:
  OverPitch(const ResolvedCase& in, const bearing::Bearing& bearing, const RingState& stated)
      : in_(in), bearing_(bearing), balances_{stated} {}

  /// Friction by `loss` of an equilibrium: mean over so many positions that twice as many change its sum by
  /// less than the printed digits, or over the most.
  template <class Loss>
  void put_means(const Loss& loss, FrictionStudy& study) {
    constexpr double same = 2e-4;  // [-]
    constexpr std::size_t first = 8, most = 128;
    double before = 0.0;
    do {
      before = study.loss.total();
      refine(std::max(first, 2 * balances_.size()));
      put(loss, study);
    } while (balances_.size() < most && std::abs(study.loss.total() - before) > same * before);
  }
  /// The same over the positions that are there.
  template <class Loss>
  void put(const Loss& loss, FrictionStudy& study) const {
    study.loss = {};
    study.least = std::numeric_limits<double>::infinity();
    study.most = 0.0;
    for (const RingState& balance : balances_) {
      const friction::RollingFriction one = loss(balance);
      study.loss += one;
      study.least = std::min(study.least, one.total());
      study.most = std::max(study.most, one.total());
    }
    study.loss *= 1.0 / static_cast<double>(balances_.size());
  }

 private:
  void refine(std::size_t count) {
    const std::size_t known = balances_.size(), between = count / known;
    std::vector<RingState> finer;
    const double step = constants::two_pi / bearing_.element_count() / static_cast<double>(count);
    for (std::size_t k = 0; k < count; ++k) {
      if (k % between == 0) {
        finer.push_back(std::move(balances_[k / between]));
        continue;
      }
      bearing::Bearing turned = bearing_;
      turned.first_element += static_cast<double>(k) * step;
      finer.push_back(balance_of(in_, turned));
    }
    balances_ = std::move(finer);
  }

  const ResolvedCase& in_;
  const bearing::Bearing& bearing_;
  std::vector<RingState> balances_;
};

// Friction of a roller bearing, with the oil at its stated temperature or at the one of its heat balance.
FrictionStudy roller_study(const ResolvedCase& in, const bearing::Bearing& bearing,
                           const RingState& at_stated, const OilInContacts& stated) {
  const std::optional<friction::BearingSize> size = size_of(in);
  const bearing::Bearing sized = size ? with_rings(bearing, *size) : bearing;
  const bearing::equilibrium::RingSpeeds speeds = row_motion_of(in).speeds;
  const double speed = speed_of(in);
  const friction::RollerMixture mixture{in.number("lubricant.share"), in.quantity("lubricant.flow")};
  const auto loss_in = [&](const OilInContacts& oil, double viscosity) {
    return [&in, &sized, &speeds, &mixture, oil,
            inlets = roller_inlets(in, size, oil, speed, viscosity)](const RingState& balance) {
      return friction::roller_friction(sized, balance.contact_load, speeds, oil.lubricant, inlets, mixture);
    };
  };
  OverPitch positions(in, bearing, at_stated);
  FrictionStudy found{.speed = speed, .viscosity = in.quantity("lubricant.kinematic_viscosity")};
  positions.put_means(loss_in(stated, found.viscosity), found);
  if (!in.flag("heat.enabled")) return found;
  const bearing::OilGrade oil = *oil_of(in);
  const auto at = [&](double temperature) {
    FrictionStudy study{.speed = speed, .viscosity = kinematic_viscosity(oil, temperature)};
    positions.put(loss_in(oil_at(oil, temperature), study.viscosity), study);
    return study;
  };
  try {
    const double outlet = system::balanced_outlet(
        heat_of(in), mixture.flow, [&](double temperature) { return at(temperature).loss.total(); });
    FrictionStudy study = at(outlet);
    study.oil_temperature = outlet;
    return study;
  } catch (const std::domain_error& error) {
    throw ComputationFailed(fmt::format("{}: {}", in.text("name"), error.what()));
  }
}

// Balls with a contact angle require an axial load of at least the radial load times the tangent of that
// angle. With less there is no equilibrium: the rings separate.
std::string too_little_thrust(const bearing::Bearing& bearing, const bearing::equilibrium::RingLoad& load) {
  const double angle = std::abs(bearing.contact_angle()), axial = std::abs(load.axial);
  const double least = std::abs(load.radial) * std::tan(angle);
  if (angle == 0.0 || load.tilt || load.moment != 0.0 || load.moment_across != 0.0 || !(axial < least))
    return "";
  return fmt::format(
      ". The axial load of {:.4g} N is too small: at a contact angle of {:.3g} deg a radial load of {:.4g} N "
      "requires at least {:.4g} N. Increase load.axial, or use model: duplex-pair for two bearings side by "
      "side",
      axial, angle * 180.0 / constants::pi, std::abs(load.radial), least);
}

// The unbalanced load is informative only where the search for an equilibrium failed.
std::string no_equilibrium_text(const bearing::equilibrium::BalanceReport& report, double load) {
  constexpr double found = 1e-6;  // [-]  of the load
  if (report.residual <= found * load) return report.message;
  return fmt::format("{} ({} iterations, {:.2g} N unbalanced)", report.message, report.iterations,
                     report.residual);
}

}  // namespace

RingState balance_of(const ResolvedCase& in, const bearing::Bearing& bearing) {
  const bearing::equilibrium::RingLoad load = ring_load_of(in);
  RingState state = bearing::equilibrium::balance_bearing(bearing, row_motion_of(in), load);
  if (!state.report.converged)
    throw ComputationFailed(fmt::format(
        "{}: {}{}", in.text("name"), no_equilibrium_text(state.report, std::hypot(load.radial, load.axial)),
        too_little_thrust(bearing, load)));
  return state;
}

std::optional<FrictionStudy> friction_study(const ResolvedCase& in, const bearing::Bearing& bearing,
                                            const RingState& stated) {
  const std::optional<bearing::OilGrade> grade = oil_of(in);
  const double speed = speed_of(in);
  if (!grade || speed == 0.0) return std::nullopt;
  const OilInContacts oil = in.has("lubricant.grade")
                                ? OilInContacts{graded_lubricant(in), graded_viscosity_slope(in)}
                                : oil_at(*grade, friction::thermal_reference::kTemperature);
  if (bearing.has_rollers()) return roller_study(in, bearing, stated, oil);
  const std::optional<friction::BearingSize> size = size_of(in);
  if (!size || stated.inner_rolling.size() == 0) return std::nullopt;
  FrictionStudy study{.speed = speed, .viscosity = in.quantity("lubricant.kinematic_viscosity")};
  OverPitch(in, bearing, stated)
      .put_means(
          [&, sized = with_rings(bearing, *size)](const RingState& balance) {
            return friction::ball_friction(sized, balance, ring_load_of(in), row_motion_of(in).speeds,
                                           oil.lubricant, {.viscosity_slope = oil.viscosity_slope});
          },
          study);
  return study;
}

std::optional<FrictionByStandards> friction_by_standards(const ResolvedCase& in, const OurFriction& ours,
                                                         double static_capacity) {
  std::optional<friction::BearingSize> size = size_of(in);
  if (!size || ours.speed == 0.0) return std::nullopt;
  size->static_capacity = static_capacity;
  const bearing::equilibrium::RingLoad load = ring_load_of(in);
  const friction::TorqueCondition at{
      .speed = ours.speed, .viscosity = ours.viscosity, .radial = load.radial, .axial = load.axial};
  const double mean = size->mean_diameter();
  FrictionByStandards found{.size = *size,
                            .palmgren = parted_torque(palmgren_factors(*size, at), mean, at),
                            .gear_unit = parted_torque(gear_unit_factors(*size, at), mean, at),
                            .skf = skf_torque(*size, at),
                            .ours = ours};
  if (!(ours.isothermal > 0.0)) found.ours.isothermal = ours.rolling / found.skf.inlet_heating;
  return found;
}

}  // namespace orbearing::app
