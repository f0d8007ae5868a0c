#include "app/study/friction_study.hpp"

#include <fmt/format.h>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "app/case/catalogue_case.hpp"
#include "app/case/described_case.hpp"
#include "app/case/oil_case.hpp"
#include "app/case/static_case.hpp"
#include "app/errors.hpp"
#include "bearing/default_design.hpp"
#include "bearing/film/oil_grade.hpp"
#include "bearing/friction/thermal_reference.hpp"

namespace orbearing::app {

namespace {

namespace friction = bearing::friction;
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
  record.value("power_W", dimension::heat, "friction at pure rolling, in all", loss.total());
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

// Of a case that states its viscosity, by grade or directly; none where it states neither, or a viscosity
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

// Of rollers, in oil at its stated temperature or at that at which it takes the heat along.
FrictionStudy roller_study(const ResolvedCase& in, const bearing::Bearing& bearing,
                           const bearing::equilibrium::RingState& balance, const OilInContacts& stated) {
  const std::optional<friction::BearingSize> size = size_of(in);
  const bearing::Bearing sized = size ? with_rings(bearing, *size) : bearing;
  const bearing::equilibrium::RingSpeeds speeds = row_motion_of(in).speeds;
  const double speed = speed_of(in);
  const friction::RollerMixture mixture{in.number("lubricant.share"), in.quantity("lubricant.flow")};
  const auto in_oil = [&](const OilInContacts& oil, double viscosity) {
    return FrictionStudy{friction::roller_friction(sized, balance.contact_load, speeds, oil.lubricant,
                                                   roller_inlets(in, size, oil, speed, viscosity), mixture),
                         speed, viscosity};
  };
  if (!in.flag("heat.enabled")) return in_oil(stated, in.quantity("lubricant.kinematic_viscosity"));
  const bearing::OilGrade oil = *oil_of(in);
  const auto at = [&](double temperature) {
    return in_oil(oil_at(oil, temperature), kinematic_viscosity(oil, temperature));
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

}  // namespace

std::optional<FrictionStudy> friction_study(const ResolvedCase& in, const bearing::Bearing& bearing,
                                            const bearing::equilibrium::RingState& balance) {
  const std::optional<bearing::OilGrade> stated = oil_of(in);
  const double speed = speed_of(in);
  if (!stated || speed == 0.0) return std::nullopt;
  const OilInContacts oil = in.has("lubricant.grade")
                                ? OilInContacts{graded_lubricant(in), graded_viscosity_slope(in)}
                                : oil_at(*stated, friction::thermal_reference::kTemperature);
  if (bearing.has_rollers()) return roller_study(in, bearing, balance, oil);
  const std::optional<friction::BearingSize> size = size_of(in);
  if (!size || balance.inner_rolling.size() == 0) return std::nullopt;
  return FrictionStudy{
      friction::ball_friction(with_rings(bearing, *size), balance, ring_load_of(in), row_motion_of(in).speeds,
                              oil.lubricant, {.viscosity_slope = oil.viscosity_slope}),
      speed, in.quantity("lubricant.kinematic_viscosity")};
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
