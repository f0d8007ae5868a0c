// A bearing in time, and the gears without their bearings: what an FMU of them holds, in this process.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "orbearing/case.hpp"

namespace orbearing {

/// An input or an output.
struct Port {
  std::string name;
  std::string unit;
  std::string meaning;
};

/// Moved by its caller, who sets inputs, advances it and reads outputs. Axes x (outward) and y (in the sense
/// of carrier rotation) turn with the carrier; SI throughout. An unknown name throws BadInput.
class Participant {
 public:
  /// One bearing of one planet; BadInput for a case that has none, of several sets, or with what a driven
  /// bearing does not include, as stated by the command fmu.
  static Participant bearing(const Case& stated);
  /// The gear set with its planet bearings left out; BadInput likewise.
  static Participant gearset(const Case& stated);

  std::vector<Port> inputs() const;
  std::vector<Port> outputs() const;
  double time() const;  // [s]

  /// A given time derivative replaces the rate that otherwise belongs to the input.
  void set_input(const std::string& name, double value, std::optional<double> slope = std::nullopt);
  double input(const std::string& name) const;

  /// Takes the inputs as they are; inputs that are not set fit the rest: the displacement is that under the
  /// start load. The first advance() does it where it was not called before.
  void initialize(double time);  // [s]
  void advance(double length);   // [s]
  double output(const std::string& name);
  std::vector<double> values();  // of all outputs
  /// [unit of output / unit of input], the inner state held.
  double slope(const std::string& output, const std::string& input);

  /// Everything the future depends on: time, inputs, their slopes, the inner state.
  std::vector<double> save();
  /// A state of a participant of the same case.
  void restore(const std::vector<double>& state);

  ~Participant();
  Participant(Participant&&) noexcept;
  Participant& operator=(Participant&&) noexcept;

 private:
  class Content;
  explicit Participant(std::unique_ptr<Content> content);

  std::unique_ptr<Content> content_;
};

}  // namespace orbearing
