#include "coupling/study/ablation.hpp"

#include <exception>
#include <iterator>
#include <utility>

#include "coupling/study/parallel.hpp"

namespace orbearing::study {

std::vector<Ablation> ablations() {
  using Drivetrain = PlanetaryDrivetrain;
  const std::string inertia = "inertia";
  const std::string fit = "clearance";
  return {
      {"all effects", inertia, [](Drivetrain&) {}},
      {"no carrier centrifugal", inertia, [](Drivetrain& d) { d.inertia.carrier_centrifugal = false; }},
      {"no Coriolis", inertia, [](Drivetrain& d) { d.inertia.coriolis = false; }},
      {"no own orbit", inertia, [](Drivetrain& d) { d.inertia.own_orbit = false; }},
      {"cage without mass", inertia, [](Drivetrain& d) { d.bearing.cage.density = 0.0; }},
      {"clearance 0 um", fit, [](Drivetrain& d) { d.bearing.radial_clearance = 0.0; }},
      {"clearance 10 um", fit, [](Drivetrain& d) { d.bearing.radial_clearance = 10e-6; }},
      {"clearance 37 um", fit, [](Drivetrain& d) { d.bearing.radial_clearance = 37e-6; }},
      {"film in the approach", fit, [](Drivetrain& d) { d.film_in_approach = true; }},
  };
}

namespace {

using Drivetrain = PlanetaryDrivetrain;
using bearing::FilmApproach;
using bearing::Race;
using bearing::motion::DampingLaw;
using bearing::motion::GuidanceFilm;
using bearing::motion::Lubrication;
using bearing::motion::PocketFilm;
using bearing::motion::ReferenceSpeed;
using bearing::motion::TractionLaw;

// An effect that the drivetrain has is switched off, one that it lacks is switched on.
Ablation toggled(const std::string& effect, const std::string& group, const Drivetrain& base,
                 const std::function<bool&(Drivetrain&)>& of) {
  Drivetrain copy = base;
  const bool on = of(copy);
  return {(on ? "no " : "") + effect, group, [of, on](Drivetrain& d) { of(d) = !on; }};
}

std::vector<Ablation> inertia_in_motion(const Drivetrain& base) {
  const std::string group = "inertia";
  return {toggled("Coriolis", group, base, [](Drivetrain& d) -> bool& { return d.inertia.coriolis; }),
          toggled("carrier centrifugal", group, base,
                  [](Drivetrain& d) -> bool& { return d.inertia.carrier_centrifugal; }),
          toggled("own orbit", group, base, [](Drivetrain& d) -> bool& { return d.inertia.own_orbit; })};
}

void exchange_traction(Drivetrain& d) {
  const bool coulomb = d.dynamics.race.traction == TractionLaw::regularised_coulomb;
  d.dynamics.race.traction = coulomb ? TractionLaw::limiting_shear : TractionLaw::regularised_coulomb;
}

void exchange_lubrication(Drivetrain& d) {
  const bool full = d.dynamics.race.lubrication == Lubrication::full;
  d.dynamics.race.lubrication = full ? Lubrication::mixed : Lubrication::full;
}

void exchange_pocket_film(Drivetrain& d) {
  const bool none = d.dynamics.cage.pocket_film == PocketFilm::none;
  d.dynamics.cage.pocket_film = none ? PocketFilm::hydrodynamic : PocketFilm::none;
}

std::vector<Ablation> film_and_traction(const Drivetrain& base) {
  const bool coulomb = base.dynamics.race.traction == TractionLaw::regularised_coulomb;
  return {
      toggled("film in the approach", "oil", base, [](Drivetrain& d) -> bool& { return d.film_in_approach; }),
      {coulomb ? "limiting-shear traction" : "Coulomb traction", "oil", exchange_traction}};
}

std::vector<Ablation> oil_in_motion(const Drivetrain& base) {
  const std::string group = "oil";
  const bool mixed = base.dynamics.race.lubrication == Lubrication::mixed;
  const bool pocket_film = base.dynamics.cage.pocket_film == PocketFilm::hydrodynamic;
  return {toggled("rolling resistance", group, base,
                  [](Drivetrain& d) -> bool& { return d.dynamics.race.rolling_resistance; }),
          toggled("oil drag", group, base, [](Drivetrain& d) -> bool& { return d.dynamics.drag.on; }),
          {mixed ? "no mixed lubrication" : "mixed lubrication", group, exchange_lubrication},
          {pocket_film ? "no film in the pockets" : "film in the pockets", group, exchange_pocket_film}};
}

// The cage on the land of the other ring, with the clearance it has.
void exchange_guidance(Drivetrain& d) {
  bearing::Cage& cage = d.bearing.cage;
  double& land = d.dynamics.cage.guide_diameter;
  const bool outer = cage.guidance == Race::outer;
  const double clearance = outer ? land - cage.outer_diameter : cage.inner_diameter - land;
  cage.guidance = outer ? Race::inner : Race::outer;
  land = outer ? cage.inner_diameter - clearance : cage.outer_diameter + clearance;
}

std::vector<Ablation> forms_in_motion() {
  const std::string group = "form";
  return {{"oval bore, 5 um", group,
           [](Drivetrain& d) {
             d.bearing.outer.form.push_back({2, 5e-6, 0.0, false});
           }},
          {"oval pin, 5 um", group,
           [](Drivetrain& d) {
             d.bearing.inner.form.push_back({2, 5e-6, 0.0, false});
           }},
          {"11 waves on the bore, 0.5 um", group,
           [](Drivetrain& d) {
             d.bearing.outer.form.push_back({11, 0.5e-6, 0.0, true});
           }},
          {"one roller 2 um larger", group, [](Drivetrain& d) {
             std::vector<double>& deviation = d.bearing.rollers().diameter_deviation;
             if (deviation.empty()) deviation.resize(1);
             deviation.front() += 2e-6;
           }}};
}

// What the source prints and the default replaces, where the drivetrain does not have it already.
std::vector<Ablation> printed_variants(const Drivetrain& base) {
  const std::string group = "as printed";
  const auto& race = base.dynamics.race;
  const auto& cage = base.dynamics.cage;
  std::vector<Ablation> list;
  if (!base.film_in_approach || base.film_approach == FilmApproach::added)
    list.push_back({"film subtracted, as printed", group, [](Drivetrain& d) {
                      d.film_in_approach = true;
                      d.film_approach = FilmApproach::as_printed;
                    }});
  if (race.damping_law != DampingLaw::as_printed)
    list.push_back({"damping as printed", group,
                    [](Drivetrain& d) { d.dynamics.race.damping_law = DampingLaw::as_printed; }});
  if (cage.guidance_film != GuidanceFilm::as_printed)
    list.push_back({"guidance film as printed", group,
                    [](Drivetrain& d) { d.dynamics.cage.guidance_film = GuidanceFilm::as_printed; }});
  if (cage.reference_speed != ReferenceSpeed::as_printed)
    list.push_back({"cage speed as printed", group,
                    [](Drivetrain& d) { d.dynamics.cage.reference_speed = ReferenceSpeed::as_printed; }});
  return list;
}

void append(std::vector<Ablation>&& more, std::vector<Ablation>& list) {
  std::move(more.begin(), more.end(), std::back_inserter(list));
}

}  // namespace

std::vector<Ablation> chief_dynamic_ablations(const PlanetaryDrivetrain& base) {
  std::vector<Ablation> list{{"all effects", "reference", [](Drivetrain&) {}}};
  append(inertia_in_motion(base), list);
  if (base.gear_set && base.mesh_variation)
    list.push_back({"constant mesh stiffness", "gears", [](Drivetrain& d) { d.mesh_variation = false; }});
  append(film_and_traction(base), list);
  return list;
}

std::vector<Ablation> dynamic_ablations(const PlanetaryDrivetrain& base) {
  std::vector<Ablation> list = chief_dynamic_ablations(base);
  append(oil_in_motion(base), list);
  if (base.dynamics.cage.guide_diameter > 0.0) {
    const bool outer = base.bearing.cage.guidance == Race::outer;
    list.push_back({outer ? "cage on the inner ring" : "cage on the outer ring", "cage", exchange_guidance});
  }
  append(forms_in_motion(), list);
  append(printed_variants(base), list);
  return list;
}

std::vector<PointResult> evaluate_all(const PlanetaryDrivetrain& drivetrain,
                                      const std::vector<Ablation>& ablations,
                                      const std::vector<double>& speeds, Fidelity fidelity) {
  std::vector<PointResult> points(ablations.size() * speeds.size());
  in_parallel(points.size(), 0, [&](std::size_t i) {
    PlanetaryDrivetrain changed = drivetrain;
    ablations[i / speeds.size()].change(changed);
    changed.drive.speed = speeds[i % speeds.size()];
    try {
      points[i] = evaluate(changed, derive(changed), fidelity);
    } catch (const std::exception& error) {
      points[i].status = error.what();
    }
  });
  return points;
}

std::vector<double> life_over_speed(const PlanetaryDrivetrain& drivetrain, const Ablation& ablation,
                                    const std::vector<double>& speeds) {
  PlanetaryDrivetrain changed = drivetrain;
  ablation.change(changed);
  const DrivetrainGeometry geometry = derive(changed);
  std::vector<double> lives;
  for (const double speed : speeds) {
    changed.drive.speed = speed;
    lives.push_back(evaluate(changed, geometry).life_hours);
  }
  return lives;
}

}  // namespace orbearing::study
