// A case with every value checked, converted and accounted for. Immutable; `with` makes changed copies.
#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <typeindex>
#include <utility>
#include <vector>

#include "app/case/case_shape.hpp"
#include "app/case/field.hpp"
#include "app/case/field_use.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/settings.hpp"

namespace orbearing::app {

inline const std::string kTorquePath = "input.torque";             // instead of the power
inline const std::string kTorqueCurvePath = "input.torque_curve";  // instead of the power

/// The speed of the input by its number in the unit of tables.
Setting input_speed(double rpm);

/// One axis of a sweep.
struct SweepAxis {
  std::string path;                 // swept field
  std::vector<std::string> values;  // as they would be written in a case: "1000 rpm"
  std::vector<double> numbers;      // [SI] the same, or plain
  std::string written;              // the axis as the resolved case repeats it (YAML flow style)
  Location location;
  std::vector<Location> locations{};  // of each value

  Setting setting(std::size_t value) const { return {path, values[value], numbers[value]}; }

  bool operator==(const SweepAxis& other) const {
    return path == other.path && values == other.values && written == other.written;
  }
};

/// A number that is not known for sure, as the case states it; an entry for each key of the block.
struct StatedUncertain {
  std::string path;
  std::string kind;  // normal, uniform, triangular or class
  std::map<std::string, double>
      numbers;  // [SI] those that are given: mean, standard_deviation, from, peak, to
  std::string clearance_class;
  std::string written;  // as the resolved case repeats it (YAML flow style)
  std::string reason;
  Location location;

  bool operator==(const StatedUncertain& other) const {
    return path == other.path && written == other.written;
  }
};

struct StatedCorrelations {
  std::vector<std::string> of;
  std::vector<std::vector<double>> matrix;  // [-]
  std::string written;                      // empty: none
  Location location;

  bool operator==(const StatedCorrelations& other) const { return written == other.written; }
};

struct StatedUncertainty {
  std::vector<StatedUncertain> inputs;
  StatedCorrelations correlations;

  bool operator==(const StatedUncertainty&) const = default;
};

/// A checked value with its place; the table's default where `from_default`.
struct StoredValue {
  FieldValue value;
  Location location;
  bool from_default = false;
  std::vector<Location> item_locations{};  // list: of its elements, where these have their own
  std::string replaced{};                  // as written, where another input replaces it
};

/// An order of paths that seldom has to read them.
struct ByLengthAndText {
  using is_transparent = void;
  bool operator()(std::string_view a, std::string_view b) const {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  }
};

/// Contents of a resolved case.
struct CaseData {
  std::string file;
  CaseShape shape;
  std::map<std::string, StoredValue, ByLengthAndText> values;
  std::map<std::string, std::string, std::less<>> assumed;  // reasons by path
  /// Shared, since every operating point is a copy of the case and an axis may hold a hundred thousand
  /// values.
  std::shared_ptr<const std::vector<SweepAxis>> axes = std::make_shared<const std::vector<SweepAxis>>();
  std::shared_ptr<const StatedUncertainty> uncertain = std::make_shared<const StatedUncertainty>();
  std::vector<FormerKey> former;  // keys that the case gives by their former names
};

/// What was made of a case, by type: each has one function that makes it, which is called when it is first
/// asked for. Threads that ask at once may each call it; the first result is kept.
class MadeOfCase {
 public:
  template <class Made, class Make>
  const Made& get(const Make& make) {
    if (const Made* found = find<Made>()) return *found;
    auto made = std::make_shared<const Made>(make());  // unlocked: it may ask for another one
    const std::scoped_lock lock(keeping_);
    return *static_cast<const Made*>(kept_.try_emplace(typeid(Made), std::move(made)).first->second.get());
  }

 private:
  template <class Made>
  const Made* find() {
    const std::scoped_lock lock(keeping_);
    const auto found = kept_.find(typeid(Made));
    return found == kept_.end() ? nullptr : static_cast<const Made*>(found->second.get());
  }

  std::mutex keeping_;
  std::map<std::type_index, std::shared_ptr<const void>> kept_;
};

class ResolvedCase {
 public:
  explicit ResolvedCase(CaseData data) : data_(std::make_shared<const CaseData>(std::move(data))) {}

  /// Values by path. Asking for a field that has no value is an error of the program (std::logic_error).
  double quantity(std::string_view path) const;  // [SI]
  double number(std::string_view path) const;
  int integer(std::string_view path) const;
  bool flag(std::string_view path) const;
  const std::string& choice(std::string_view path) const;
  const std::string& text(std::string_view path) const;
  const std::vector<double>& list(std::string_view path) const;  // [SI]
  const std::vector<std::string>& texts(std::string_view path) const;
  bool has(std::string_view path) const;

  /// The value, whatever its kind.
  const FieldValue& value(std::string_view path) const { return stored(path).value; }
  /// The value as written: "150 kW".
  const std::string& given(std::string_view path) const;
  /// The same, also where another input replaces it.
  const std::string& written(std::string_view path) const;
  /// "FILE:LINE:COLUMN", "--set" or "default".
  std::string origin(std::string_view path) const;
  Location location(std::string_view path) const;
  /// Location of an element of a list.
  Location item_location(std::string_view path, std::size_t item) const;

  Model model() const;
  const CaseShape& shape() const { return data_->shape; }
  /// All inputs that this case may have, in the order in which it is written.
  std::vector<Input> inputs() const { return inputs_of(model(), data_->shape); }
  const std::string& file() const { return data_->file; }
  const std::vector<SweepAxis>& axes() const { return *data_->axes; }
  const StatedUncertainty& uncertain() const { return *data_->uncertain; }
  /// Whether another input replaces this one.
  bool is_replaced(std::string_view path) const { return !stored(path).replaced.empty(); }
  /// Reasons by path; defaults in use are among them.
  const std::map<std::string, std::string, std::less<>>& assumed() const { return data_->assumed; }

  const std::vector<FormerKey>& former() const { return data_->former; }
  const CaseData& data() const { return *data_; }

  /// What `make` gives, made once for the case and all copies that share its values; valid as long as one of
  /// them lives.
  template <class Made, class Make>
  const Made& once(const Make& make) const& {
    return made_->get<Made>(make);
  }
  template <class Made, class Make>
  const Made& once(const Make& make) const&& = delete;

  /// Copy with independent values replaced, checked singly and together. Throws BadInput.
  ResolvedCase with(const std::vector<Setting>& settings) const;
  ResolvedCase with(const std::string& path, const std::string& text) const;
  ResolvedCase with(const std::string& path, double number) const;  // [SI]
  /// As with(), with what is wrong added to `mistakes` instead; what could not be set keeps its value.
  ResolvedCase with(const std::vector<Setting>& settings, std::vector<Mistake>& mistakes) const;

  /// Copy in which the value at `path` is assumed, with the reason.
  ResolvedCase assuming(const std::string& path, const std::string& reason) const;

  /// One of several sets as a case of its own, without sweep: its fields at the top, with what all share.
  ResolvedCase of_set(std::string_view set) const;

  /// Copy whose sweep takes the input at `path` through these numbers [SI]. Throws BadInput.
  ResolvedCase sweeping(const std::string& path, const std::vector<double>& numbers) const;

  /// Copy without its sweep: the one operating point that the values state.
  ResolvedCase without_sweep() const;

  /// Equal values, reasons and axes; locations are not compared.
  bool operator==(const ResolvedCase& other) const;

 private:
  const StoredValue& stored(std::string_view path) const;
  const StoredValue& stored(std::string_view path, Kind kind) const;

  std::shared_ptr<const CaseData> data_;  // copies share it: a case does not change
  std::shared_ptr<MadeOfCase> made_ = std::make_shared<MadeOfCase>();
};

/// Whether the case has a value at `path` that is no default.
bool is_stated(const ResolvedCase& resolved, std::string_view path);

/// Speeds of the input [rad/s] in the order of their axis; the case's own where none are swept.
std::vector<double> swept_speeds(const ResolvedCase& resolved);

/// Number of operating points: the product of the axes, 1 without a sweep.
std::size_t sweep_size(const ResolvedCase& resolved);

/// Settings of point `index`; the first axis changes slowest.
std::vector<Setting> sweep_point(const ResolvedCase& resolved, std::size_t index);

/// A quantity that follows from the inputs of a case, as `check` lists it.
struct Derived {
  std::string path;    // "gearset.centre_distance"
  double value = 0.0;  // [unit]
  std::string unit;    // "mm"; "1" for a ratio
  std::string meaning;
};

/// Conditions under which the input at `path` follows from another one and may be left out; empty: it never
/// does.
std::vector<Condition> given_by(std::string_view path);

// Words of the checks across fields. What the case leaves out meets no condition.

bool has_all(const ResolvedCase& in, std::initializer_list<std::string_view> paths);
bool is_nonzero(const ResolvedCase& in, std::string_view path);  // of a quantity
bool is_on(const ResolvedCase& in, std::string_view path);       // of a switch
bool is_chosen(const ResolvedCase& in, std::string_view path, std::string_view choice);

/// A case that is being checked, and what is wrong with it.
class CheckedCase : public ResolvedCase {
 public:
  CheckedCase(const ResolvedCase& resolved, std::vector<Mistake>& found)
      : ResolvedCase(resolved), mistakes(found) {}

  bool is(std::string_view path, std::string_view choice) const { return is_chosen(*this, path, choice); }

  /// Adds a mistake at the place of `path`; of a value that the case leaves out, or of a block, at that of
  /// the first value in it, or beside it, or of the model.
  void add_error_at(const std::string& path, std::string found, std::string required);
  /// The same of a text "found; required", in which inputs are as mechanics::as_written() has them.
  void add_error(const std::string& path, const std::string& text);

  std::vector<Mistake>& mistakes;
};

}  // namespace orbearing::app
