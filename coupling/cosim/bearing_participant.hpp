// A planet bearing as a participant: takes the motion of its planet, gives force and moment.
#pragma once

#include "coupling/cosim/participant.hpp"
#include "coupling/system/driven_bearing.hpp"
#include "gearset/dynamics/parameters.hpp"

namespace orbearing::cosim {

/// Where the bearing sits. Carrier and planet turn at the speeds of `operation`; the port adds to them.
struct BearingPlace {
  std::string name;  // e.g. "planet_1.bearing_2"
  int planet = 0;    // counted from 0; gives the ports their names
  gearset::dynamics::Operation operation;
};

class BearingParticipant : public Participant {
 public:
  BearingParticipant(const DrivenBearingSetup& setup, BearingPlace place);

  std::string name() const override { return place_.name; }
  const std::vector<Port>& ports() const override { return ports_; }
  void initialize(double time, const std::vector<PortInput>& inputs) override;
  void set_input(const std::vector<PortInput>& inputs) override;
  void advance(const Window& window) override;
  void output(std::vector<PortOutput>& outputs) const override;
  void save(SavedState& state) const override;
  void restore(const SavedState& state) override;

  const DrivenBearing& bearing() const { return bearing_; }
  void take_snapshot(bearing::dynamics::Snapshot& into) const { bearing_.take_snapshot(motion(), into); }
  void collect_loads(bearing::dynamics::StatisticsCollector* collector) { bearing_.collect_loads(collector); }
  /// Motion of the bore at the present time.
  bearing::dynamics::BoreMotion motion() const { return course_.at(since_); }

 private:
  void set_course(const std::vector<PortInput>& inputs);

  DrivenBearing bearing_;
  BearingPlace place_;
  std::vector<Port> ports_;
  BoreCourse course_;
  double time_ = 0.0;   // [s]
  double since_ = 0.0;  // [s]  of the present time, since the course began
};

}  // namespace orbearing::cosim
