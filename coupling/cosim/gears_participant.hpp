// The gear set as a participant: gives the motion of its planets, takes forces and moments of their bearings.
#pragma once

#include "coupling/cosim/participant.hpp"
#include "coupling/system/driven_gears.hpp"

namespace orbearing::cosim {

/// Ports of planet n, counted from 1: "planet_n.x", "planet_n.y", "planet_n.rotation". The last is relative
/// to the carrier and beyond the nominal rotation.
class GearsParticipant : public Participant {
 public:
  explicit GearsParticipant(const DrivenGearsSetup& setup, std::string name = "gears");

  std::string name() const override { return name_; }
  const std::vector<Port>& ports() const override { return ports_; }
  void initialize(double time, const std::vector<PortInput>& inputs) override;
  void set_input(const std::vector<PortInput>& inputs) override;
  void advance(const Window& window) override;
  void output(std::vector<PortOutput>& outputs) const override;
  void save(SavedState& state) const override { gears_.save(state); }
  void restore(const SavedState& state) override { gears_.restore(state); }

  const DrivenGears& gears() const { return gears_; }

 private:
  DrivenGears gears_;
  bool on_springs_;
  std::string name_;
  std::vector<Port> ports_;
  std::vector<PlanetForceCourse> forces_;  // (planets)
  bool begun_ = false;
};

/// The three ports of a planet, counted from 0.
std::vector<Port> planet_ports(int planet, Gives gives);

}  // namespace orbearing::cosim
