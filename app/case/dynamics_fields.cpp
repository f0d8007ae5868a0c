// Fields of the roller dynamics: friction, damping, cage, oil around the rollers, support, and the run in
// time.
#include "app/case/field_table.hpp"

namespace orbearing::app::table {

namespace {

constexpr unsigned drivetrain = planetary_drivetrain;
constexpr unsigned without_motion = use::rollers_at_rest | use::bearings_as_springs | use::mesh;

const Use& of_motion() {
  static const Use use(use::rollers_in_motion, without_motion);
  return use;
}

Use of_land() {
  return of_motion().when(where_given({"bearing.cage.guide_land_diameter"}));
}

const Use& of_run() {
  static const Use use(use::in_time, without_motion | use::fmu_bearing);
  return use;
}

const Use& of_exchange() {
  static const Use use(use::co_simulated, without_motion | use::dynamic | use::dynamic_of_sets |
                                              use::monolithic | use::fmu_bearing);
  return use;
}

// All are values that sources rarely print, so each has a default with its reason, or one that follows from
// its parts (derived_defaults).
struct Defaulted {
  std::string path;
  std::string meaning;
  Use use;
  Range range;
  std::string text;
  std::string reason;
};

Field ratio(Defaulted row) {
  return {.path = std::move(row.path),
          .kind = Kind::number,
          .meaning = std::move(row.meaning),
          .use = std::move(row.use),
          .models = drivetrain,
          .range = row.range,
          .default_text = std::move(row.text),
          .default_reason = std::move(row.reason)};
}

Field integer(Defaulted row) {
  Field field = ratio(std::move(row));
  field.kind = Kind::integer;
  return field;
}

Field quantity(const Dimension& dimension, Defaulted row) {
  Field field = ratio(std::move(row));
  field.kind = Kind::quantity;
  field.dimension = dimension;
  return field;
}

Field flag(std::string path, std::string meaning, Use use, std::string text, std::string reason) {
  Field field =
      ratio({std::move(path), std::move(meaning), std::move(use), {}, std::move(text), std::move(reason)});
  field.kind = Kind::flag;
  return field;
}

constexpr Range positive(double most) {
  return {.least = 0.0, .most = most, .least_allowed = false};
}

void add_friction(std::vector<Field>& fields) {
  fields.push_back(
      {.path = "traction.law",
       .kind = Kind::choice,
       .meaning = "friction in the race contacts over sliding speed",
       .use = of_motion(),
       .models = drivetrain,
       .choices = {"regularised-coulomb", "limiting-shear"},
       .default_text = "regularised-coulomb",
       .default_reason = "the law of [Gai2025]; the sheared film of [BairWiner1979] is the other choice"});
  fields.push_back(ratio({"traction.friction",
                          "largest friction coefficient of the regularised Coulomb law",
                          of_motion().when(where("traction.law", {"regularised-coulomb"})),
                          {0.0, 1.0},
                          "0.05",
                          "mineral oil at moderate pressure"}));
  fields.push_back(
      quantity(dimension::speed, {"traction.sliding_scale", "sliding speed over which friction builds up",
                                  of_motion().when(where("traction.law", {"regularised-coulomb"})),
                                  positive(100.0), "0.1 m/s", "creep of oiled contacts"}));
  fields.push_back(ratio({"traction.limiting_friction",
                          "limiting shear stress of the oil over pressure",
                          of_motion().when(where("traction.law", {"limiting-shear"})),
                          {0.0, 1.0},
                          "0.06",
                          "mineral oil"}));
  fields.push_back(flag("traction.rolling_resistance", "shear of the oil at the inlet resists rolling",
                        of_motion(), "true", "nothing left out"));
  fields.push_back(
      quantity(dimension::inverse_speed, {"contact.damping",
                                          "share by which a race load grows per speed of approach",
                                          of_motion(),
                                          {0.0, 100.0},
                                          "0.1 s/m",
                                          "a tenth of critical on a small roller at 1 kN"}));
}

void add_cage(std::vector<Field>& fields) {
  fields.push_back(quantity(dimension::stiffness, {"bearing.cage.pocket_stiffness", "stiffness of a cage bar",
                                                   of_motion(), positive(1e12), "", ""}));
  fields.push_back(
      quantity(dimension::inverse_speed, {"bearing.cage.pocket_damping",
                                          "share by which a pocket load grows per speed of approach",
                                          of_motion(),
                                          {0.0, 100.0},
                                          "1 s/m",
                                          "polymer"}));
  fields.push_back(ratio({"bearing.cage.pocket_friction",
                          "friction coefficient of roller and bar",
                          of_motion(),
                          {0.0, 1.0},
                          "0.05",
                          "oiled polymer"}));
  fields.push_back(ratio({"bearing.cage.largest_eccentricity",
                          "share of the land's clearance where roughness carries",
                          of_land(),
                          {.least = 0.1, .most = 1.0, .most_allowed = false},
                          "0.98",
                          "finish of the land"}));
  fields.push_back(quantity(
      dimension::stiffness,
      {"bearing.cage.touch_down_stiffness", "stiffness of cage on land", of_land(), positive(1e12), "", ""}));
}

void add_guidance_film(std::vector<Field>& fields) {
  fields.push_back(
      {.path = "bearing.cage.guidance_film",
       .kind = Kind::choice,
       .meaning = "oil force between cage and land: with squeeze and whirl, or as [Gai2025] prints it",
       .use = of_land(),
       .models = drivetrain,
       .choices = {"short-bearing", "as-printed"},
       .default_text = "short-bearing",
       .default_reason = "the printed force depends on the frame and lacks squeeze"});
}

void add_surroundings(std::vector<Field>& fields) {
  fields.push_back(flag("drag.enabled", "drag and churning in the oil-air mixture", of_motion(), "true",
                        "nothing left out"));
  fields.push_back(quantity(dimension::density, {"lubricant.density", "density of the oil",
                                                 of_motion().when(where("drag.enabled", {"true"})),
                                                 positive(20000.0), "850 kg/m3", "mineral oil"}));
  fields.push_back(ratio({"lubricant.share",
                          "oil in the free volume of the bearing",
                          of_motion().when(where("drag.enabled", {"true"})),
                          {0.0, 1.0},
                          "0.05",
                          "oil mist with jets"}));
  fields.push_back(
      quantity(dimension::stiffness,
               {"support.stiffness", "radial stiffness of the pin in the carrier, for each bearing on it",
                Use(use::rollers_in_motion | use::bearings_as_springs, use::rollers_at_rest | use::mesh)
                    .felt_too(use::quasi_static, where_pins_are_displaced()),
                positive(1e13), "", ""}));
  fields.push_back(ratio({"support.damping_ratio",
                          "damping of planet and pin on the support",
                          of_motion(),
                          {0.0, 10.0},
                          "0.05",
                          "bolted steel structure"}));
  fields.push_back(
      flag("gearset.mesh_variation",
           "the stiffness of a mesh varies as teeth pass, and shakes gears and planet bearings; false: it "
           "keeps its "
           "mean",
           Use(use::gears_in_motion, use::rollers_at_rest | use::natural | use::mesh | use::fmu_bearing),
           "true", "nothing left out; several sets give mean forces whatever is said here"));
}

void add_run(std::vector<Field>& fields) {
  fields.push_back({.path = "simulation.integrator",
                    .kind = Kind::choice,
                    .meaning =
                        "how the roller dynamics is integrated: linearly implicit steps on the vectorised "
                        "equations, or the readable equations by explicit steps of order 5",
                    .use = Use(use::dynamic | use::dynamic_of_sets, without_motion,
                               use::co_simulated | use::monolithic | use::fmu_bearing),
                    .models = drivetrain,
                    .choices = {"linearly-implicit", "dopri5"},
                    .default_text = "linearly-implicit",
                    .default_reason = "the same means in a fraction of the time"});
  fields.push_back(integer({"simulation.observed_revolutions",
                            "cage revolutions that are averaged once steady",
                            of_run(),
                            {1, 100000},
                            "10",
                            "enough for maxima"}));
  fields.push_back(integer({"simulation.most_revolutions",
                            "cage revolutions allowed to become steady",
                            of_run(),
                            {2, 100000},
                            "20",
                            "bearings settle in a few"}));
  fields.push_back(
      ratio({"simulation.load_drift", "steady: rms loads of two revolutions in turn differ by less", of_run(),
             positive(1.0), "0.002", "below what a life can tell"}));
  fields.push_back(
      ratio({"simulation.cage_drift", "steady: cage speeds of two revolutions in turn differ by less",
             of_run(), positive(1.0), "0.001", "below what a slip can tell"}));
  fields.push_back(
      quantity(dimension::length,
               {"simulation.length_error", "error of a position allowed in one step", of_motion(),
                positive(0.1), "2e-7 mm", "coarser steps ring at contacts that close and then take longer"}));
}

// How gears and bearings hear of each other in a co-simulation.
void add_exchange(std::vector<Field>& fields) {
  fields.push_back({.path = "simulation.exchange.order",
                    .kind = Kind::choice,
                    .meaning =
                        "who waits for whom in a window of the co-simulation: the bearings for the gears, or "
                        "nobody",
                    .use = of_exchange(),
                    .models = drivetrain,
                    .choices = {"gauss-seidel", "jacobi"},
                    .default_text = "gauss-seidel",
                    .default_reason = "stable in longer windows"});
  fields.push_back(quantity(
      dimension::time,
      {"simulation.exchange.window", "longest time between two exchanges", of_exchange(), positive(1e-3),
       "5 us", "a fraction of the stability limit: means as of one system within half a per cent"}));
  fields.push_back(integer({"simulation.exchange.extrapolation",
                            "degree of the polynomial by which forces and velocities go on in a window",
                            of_exchange(),
                            {0, 2},
                            "1",
                            "order 2 without overshoot at impacts"}));
  fields.push_back(integer({"simulation.exchange.passes",
                            "passes over a window until both sides agree, at most; 1: none is repeated",
                            of_exchange(),
                            {1, 100},
                            "1",
                            "short windows cost less than repeated ones"}));
}

}  // namespace

void add_dynamics_fields(std::vector<Field>& fields) {
  add_friction(fields);
  add_cage(fields);
  add_guidance_film(fields);
  add_surroundings(fields);
  add_run(fields);
  add_exchange(fields);
}

}  // namespace orbearing::app::table
