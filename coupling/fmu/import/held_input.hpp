// Quantities of ports to variables of an FMU and back.
#pragma once

#include <vector>

#include "coupling/cosim/port.hpp"
#include "coupling/fmu/import/foreign_setup.hpp"

namespace orbearing::fmu {

/// Inputs over one communication step: begin value and derivatives, or one value that is held.
class HeldInputs {
 public:
  HeldInputs() = default;
  /// `slopes`: highest order of derivatives that the FMU takes; 0: it holds its inputs.
  HeldInputs(const std::vector<cosim::Port>& ports, const std::vector<ForeignPortChannels>& channels,
             int slopes);

  /// Throws ForeignFmuError where their number is not that of the ports, or a value is not finite.
  void take(const std::vector<cosim::PortInput>& inputs);
  /// For the step from `begin` to `end` [s], counted from the beginning of the window.
  void set(ForeignInstance& instance, double begin, double end) const;

 private:
  enum class Half { displacement, velocity, force };
  struct Entry {
    std::size_t port;
    Half half;
    ForeignChannel channel;
  };
  const cosim::Course& course(const Entry& entry) const;
  void set_slopes(ForeignInstance& instance, int order, double begin) const;

  std::size_t port_number_ = 0;
  int slopes_ = 0;
  std::vector<Entry> entries_;
  References references_;
  std::vector<cosim::PortInput> inputs_;
};

class ForeignOutputs {
 public:
  ForeignOutputs() = default;
  ForeignOutputs(const std::vector<cosim::Port>& ports, const std::vector<ForeignPortChannels>& channels);
  /// Throws ForeignFmuError where the FMU gives a value that is not finite.
  void get(ForeignInstance& instance, std::vector<cosim::PortOutput>& outputs) const;

 private:
  struct Entry {
    std::size_t port;
    double cosim::PortOutput::*value;
    ForeignChannel channel;
  };
  std::vector<std::string> names_;
  std::vector<Entry> entries_;
  References references_;
};

/// Mean of a course from `begin` to `end` [s].
double mean(const cosim::Course& course, double begin, double end);

}  // namespace orbearing::fmu
