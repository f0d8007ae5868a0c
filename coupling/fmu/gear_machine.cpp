// The planetary gear set behind the C interface.
#include "coupling/fmu/gear_fields.hpp"
#include "coupling/fmu/machine.hpp"
#include "coupling/system/driven_gears.hpp"

namespace orbearing::fmu {

namespace {

constexpr std::size_t kInputsPerPlanet = 3;

std::string planet_name(int planet) {
  return "planet[" + std::to_string(planet) + "].";
}

std::vector<InputFacts> gear_inputs(const GearModel& model) {
  std::vector<InputFacts> inputs;
  const auto add = [&](const std::string& name, const char* unit, const std::string& meaning) {
    const std::size_t place = inputs.size();
    const double start = place < model.start_force.size() ? model.start_force[place] : 0.0;
    inputs.push_back({name, unit, meaning, start});
  };
  for (int i = 1; i <= model.setup.set.planets; ++i) {
    const std::string planet = planet_name(i), all = "of all bearings on the planet, ";
    add(planet + "force.x", "N", "force " + all + "outward");
    add(planet + "force.y", "N", "force " + all + "in the sense of carrier rotation");
    add(planet + "moment", "N.m", "moment " + all + "about its axis");
  }
  return inputs;
}

std::vector<OutputFacts> gear_outputs(int planets) {
  std::vector<OutputFacts> outputs;
  for (int i = 1; i <= planets; ++i) {
    const std::string planet = planet_name(i);
    const std::string along = ", in the sense of carrier rotation";
    outputs.push_back(
        {planet + "displacement.x", "m", "of the planet's axis from that of its pin, outward", {}, {}});
    outputs.push_back(
        {planet + "displacement.y", "m", "of the planet's axis from that of its pin" + along, {}, {}});
    outputs.push_back({planet + "velocity.x", "m/s", "slope of displacement.x by time", {}, {}});
    outputs.push_back({planet + "velocity.y", "m/s", "slope of displacement.y by time", {}, {}});
    outputs.push_back(
        {planet + "speed", "rad/s", "of the planet about its axis, relative to the carrier", {}, {}});
    outputs.push_back({planet + "angle", "rad", "of the planet beyond its nominal rotation", {}, {}});
    outputs.push_back(
        {planet + "sun_mesh_force", "N", "force of the sun mesh along its line of action", {}, {}});
    outputs.push_back(
        {planet + "ring_mesh_force", "N", "force of the ring mesh along its line of action", {}, {}});
  }
  outputs.push_back({"carrier.speed", "rad/s", "nominal speed of the carrier", {}, {}, false});
  outputs.push_back({"carrier.acceleration", "rad/s2", "slope of carrier.speed by time", {}, {}, false});
  return outputs;
}

class GearMachine : public Machine {
 public:
  explicit GearMachine(const GearModel& model) : gears_(model.setup) {}

  void initialize(double time, const std::vector<double>&) override { gears_.initialize(time); }

  void advance(const cosim::Window& window, const std::vector<cosim::Course>& in) override {
    std::vector<cosim::PlanetForceCourse> forces;
    for (std::size_t i = 0; i + 2 < in.size(); i += kInputsPerPlanet)
      forces.push_back({.x = in[i], .y = in[i + 1], .moment = in[i + 2]});
    gears_.advance(window, forces);
  }

  std::vector<double> outputs(const std::vector<double>&) const override {
    const cosim::DrivenGearsOutput now = gears_.output();
    std::vector<double> values;
    for (const cosim::PlanetMotion& planet : now.planets)
      values.insert(values.end(), {planet.displacement.x(), planet.displacement.y(), planet.velocity.x(),
                                   planet.velocity.y(), planet.speed, planet.angle, planet.sun_mesh_force,
                                   planet.ring_mesh_force});
    values.insert(values.end(), {now.carrier_speed, now.carrier_acceleration});
    return values;
  }

  // Motion follows forces only in time.
  std::vector<double> slopes(const std::vector<double>& inputs, std::size_t) const override {
    return std::vector<double>(outputs(inputs).size(), 0.0);
  }

  void save(cosim::SavedState& state) const override { gears_.save(state); }
  void restore(const cosim::SavedState& state) override { gears_.restore(state); }

 private:
  cosim::DrivenGears gears_;
};

}  // namespace

ModelFacts gear_facts(const NumberTable& numbers) {
  const GearModel model = gears_from(numbers);
  ModelFacts facts{.model = "gearset",
                   .meaning = "A planetary gear set whose planet bearings are computed elsewhere"};
  show_fields(model, facts);
  facts.inputs = gear_inputs(model);
  facts.outputs = gear_outputs(model.setup.set.planets);
  return facts;
}

std::unique_ptr<Machine> make_gears(const NumberTable& numbers) {
  return std::make_unique<GearMachine>(gears_from(numbers));
}

}  // namespace orbearing::fmu
