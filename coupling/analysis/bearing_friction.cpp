#include "coupling/analysis/bearing_friction.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

#include "bearing/default_design.hpp"
#include "bearing/film/oil_grade.hpp"
#include "bearing/friction/thermal_reference.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::analysis {

namespace {

namespace friction = bearing::friction;
using bearing::equilibrium::RingState;
namespace dimension = described::dimension;
using described::Record;

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
void put_torque_parts(Record& record, const friction::TorqueParts& torque, const Standards& standards) {
  record.value("load_free_N_mm", dimension::small_torque, "by viscosity and speed", torque.load_free).symbol =
      "M_0";
  record.value("load_dependent_N_mm", dimension::small_torque, "by the load", torque.load_dependent).symbol =
      "M_1";
  put_torque(record, torque.total(), standards);
}

}  // namespace

void describe(Record& record, const BearingFriction& friction) {
  const bearing::friction::RollingFriction& loss = friction.loss;
  record.value("power_W", dimension::heat,
               "friction at pure rolling, in all; mean over positions of the cage", loss.total());
  record.value("least_power_W", dimension::heat, "the same at the position of the cage where it is least",
               friction.least);
  record.value("most_power_W", dimension::heat, "the same at the position where it is greatest",
               friction.most);
  record.value("torque_N_mm", dimension::small_torque, "the same over the speed", friction.ours().torque);
  if (friction.oil_temperature)
    record.value("oil_temperature_degC", dimension::temperature, "at which the oil leaves with that heat",
                 *friction.oil_temperature);
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
               [](Record& one, const auto& of) { put_torque_parts(one, of.palmgren, of); });
  record.child("iso_tr_14179_2", "by f_0 and f_1 of the type", standards,
               [](Record& one, const auto& of) { put_torque_parts(one, of.gear_unit, of); });
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

// Oil that is stated by grade, or by a viscosity that a mineral oil has at the default temperature; none:
// neither.
std::optional<bearing::OilGrade> stated_grade(const BearingOil& oil) {
  if (oil.stated.grade) return oil_of(oil.stated);
  return oil.kinematic_viscosity ? oil_with(*oil.kinematic_viscosity) : std::nullopt;
}

// At the temperature at which the bearing runs.
OilInContacts oil_in_contacts(const BearingOil& oil, const bearing::OilGrade& grade) {
  return oil.stated.grade
             ? OilInContacts{oil.lubricant, bearing::viscosity_slope(grade, oil.stated.temperature)}
             : oil_at(grade, friction::thermal_reference::kTemperature);
}

friction::Inlets roller_inlets(const RollersUnderLoad& in, const OilInContacts& oil, double speed,
                               double viscosity) {
  using bearing::motion::Starvation;
  const std::optional<friction::BearingSize>& size = in.loaded.size;
  friction::Inlets inlets{oil.viscosity_slope, friction::InletEnd::layer};
  if (in.oil.starvation == Starvation::replenished) inlets.end = friction::InletEnd::replenished;
  if (in.oil.starvation == Starvation::skf && size)
    inlets.starvation =
        friction::starvation_factor(size->bore, size->outside, friction::type_constant(size->family),
                                    {.speed = speed, .viscosity = viscosity});
  return inlets;
}

// Equilibria with the first element at even positions over a pitch, the stated one among them: rollers enter
// and leave the load zone as the cage rotates.
class OverPitch {
 public:
  OverPitch(const bearing::Bearing& bearing, const bearing::equilibrium::RowMotion& motion,
            const bearing::equilibrium::RingLoad& load, const RingState& stated)
      : bearing_(bearing), motion_(motion), load_(load), balances_{stated} {}

  /// Friction by `loss` of an equilibrium: mean over so many positions that twice as many change its sum by
  /// less than the printed digits, or over the most.
  template <class Loss>
  void put_means(const Loss& loss, BearingFriction& found) {
    constexpr double same = 2e-4;  // [-]
    constexpr std::size_t first = 8, most = 128;
    double before = 0.0;
    do {
      before = found.loss.total();
      refine(std::max(first, 2 * balances_.size()));
      put(loss, found);
    } while (balances_.size() < most && std::abs(found.loss.total() - before) > same * before);
  }
  /// The same over the positions that are there.
  template <class Loss>
  void put(const Loss& loss, BearingFriction& found) const {
    found.loss = {};
    found.least = std::numeric_limits<double>::infinity();
    found.most = 0.0;
    for (const RingState& balance : balances_) {
      const friction::RollingFriction one = loss(balance);
      found.loss += one;
      found.least = std::min(found.least, one.total());
      found.most = std::max(found.most, one.total());
    }
    found.loss *= 1.0 / static_cast<double>(balances_.size());
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
      finer.push_back(balanced(turned, motion_, load_));
    }
    balances_ = std::move(finer);
  }

  const bearing::Bearing& bearing_;
  const bearing::equilibrium::RowMotion& motion_;
  const bearing::equilibrium::RingLoad& load_;
  std::vector<RingState> balances_;
};

}  // namespace

// With the oil at its stated temperature or at the one of its heat balance.
std::optional<BearingFriction> rolling_friction(const RollersUnderLoad& in, const RingState& stated) {
  const std::optional<bearing::OilGrade> grade = stated_grade(in.loaded.oil);
  const double speed = std::abs(in.loaded.rotation.relative());
  if (!grade || speed == 0.0) return std::nullopt;
  const bearing::Bearing bearing = rotating_bearing(in.loaded);
  const bearing::Bearing sized = in.loaded.size ? with_rings(bearing, *in.loaded.size) : bearing;
  const bearing::equilibrium::RowMotion motion{.speeds = in.loaded.rotation.speeds()};
  const friction::RollerMixture mixture{in.oil.share, in.oil.flow};
  const auto loss_in = [&](const OilInContacts& oil, double viscosity) {
    return [&sized, &motion, &mixture, oil,
            inlets = roller_inlets(in, oil, speed, viscosity)](const RingState& balance) {
      return friction::roller_friction(sized, balance.contact_load, motion.speeds, oil.lubricant, inlets,
                                       mixture);
    };
  };
  OverPitch positions(bearing, motion, in.loaded.load, stated);
  BearingFriction found{.speed = speed, .viscosity = in.loaded.oil.kinematic_viscosity.value()};
  positions.put_means(loss_in(oil_in_contacts(in.loaded.oil, *grade), found.viscosity), found);
  if (!in.oil.heated) return found;
  const auto at = [&](double temperature) {
    BearingFriction warm{.speed = speed, .viscosity = kinematic_viscosity(*grade, temperature)};
    positions.put(loss_in(oil_at(*grade, temperature), warm.viscosity), warm);
    return warm;
  };
  try {
    const double outlet =
        system::balanced_outlet({.on = true, .model = in.oil.model, .inlet = in.oil.inlet}, mixture.flow,
                                [&](double temperature) { return at(temperature).loss.total(); });
    BearingFriction warm = at(outlet);
    warm.oil_temperature = outlet;
    return warm;
  } catch (const std::domain_error& error) {
    throw NoResult(error.what());
  }
}

std::optional<BearingFriction> rolling_friction(const BallsUnderLoad& in, const RingState& stated) {
  const std::optional<bearing::OilGrade> grade = stated_grade(in.loaded.oil);
  const double speed = std::abs(in.loaded.rotation.relative());
  if (!grade || speed == 0.0 || !in.loaded.size || stated.inner_rolling.size() == 0) return std::nullopt;
  const OilInContacts oil = oil_in_contacts(in.loaded.oil, *grade);
  const bearing::Bearing bearing = rotating_bearing(in.loaded);
  const bearing::equilibrium::RowMotion motion =
      row_motion(in.loaded.rotation, in.balls, in.loaded.oil.lubricant);
  BearingFriction found{.speed = speed, .viscosity = in.loaded.oil.kinematic_viscosity.value()};
  OverPitch(bearing, motion, in.loaded.load, stated)
      .put_means(
          [&, sized = with_rings(bearing, *in.loaded.size)](const RingState& balance) {
            return friction::ball_friction(sized, balance, in.loaded.load, motion.speeds, oil.lubricant,
                                           {.viscosity_slope = oil.viscosity_slope});
          },
          found);
  return found;
}

std::optional<FrictionByStandards> friction_by_standards(const LoadedBearing& in, const OurFriction& ours,
                                                         double static_capacity) {
  std::optional<friction::BearingSize> size = in.size;
  if (!size || ours.speed == 0.0) return std::nullopt;
  size->static_capacity = static_capacity;
  const friction::TorqueCondition at{
      .speed = ours.speed, .viscosity = ours.viscosity, .radial = in.load.radial, .axial = in.load.axial};
  const double mean = size->mean_diameter();
  FrictionByStandards found{.size = *size,
                            .palmgren = torque_parts(palmgren_factors(*size, at), mean, at),
                            .gear_unit = torque_parts(gear_unit_factors(*size, at), mean, at),
                            .skf = skf_torque(*size, at),
                            .ours = ours};
  if (!(ours.isothermal > 0.0)) found.ours.isothermal = ours.rolling / found.skf.inlet_heating;
  return found;
}

}  // namespace orbearing::analysis
