#include "app/case/consistency.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <set>

#include "app/case/field_table.hpp"
#include "app/case/settings.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

constexpr std::size_t most_told = 20;  // mistakes of one axis

struct ValidationError {
  std::size_t value = 0;  // of the axis
  Mistake mistake;        // as of the value set alone, with the path that does not fit
};

std::string mistake_text(const Mistake& mistake) {
  return mistake.path + ": " + mistake.message.found + "; " + mistake.message.required;
}

/// The case's own value where the axis holds it, else the axis' first.
Setting reference_value(const ResolvedCase& resolved, const SweepAxis& axis) {
  const auto own = resolved.has(axis.path)
                       ? std::find(axis.numbers.begin(), axis.numbers.end(), resolved.value(axis.path).number)
                       : axis.numbers.end();
  return axis.setting(own == axis.numbers.end() ? 0 : static_cast<std::size_t>(own - axis.numbers.begin()));
}

ResolvedCase at_reference(const ResolvedCase& resolved, const std::vector<const SweepAxis*>& axes) {
  std::vector<Setting> settings;
  for (const SweepAxis* axis : axes) settings.push_back(reference_value(resolved, *axis));
  std::vector<Mistake> ignored;  // each axis meets its own value again
  return resolved.without_sweep().with(settings, ignored);
}

std::vector<ValidationError> errors_of(const SweepAxis& axis, const ResolvedCase& reference) {
  std::vector<ValidationError> errors;
  for (std::size_t i = 0; i < axis.values.size(); ++i) {
    std::vector<Mistake> mistakes;
    reference.with({axis.setting(i)}, mistakes);
    for (Mistake& mistake : mistakes) errors.push_back({i, std::move(mistake)});
  }
  return errors;
}

Mistake at_axis(const SweepAxis& axis, const ValidationError& validation_error) {
  const std::string& path = validation_error.mistake.path;
  const ConsistencyMessage& message = validation_error.mistake.message;
  const std::string found =
      path == axis.path ? message.found
                        : fmt::format("{} contradicts {}: {}", quote(axis.values[validation_error.value]),
                                      path, message.found);
  return {axis.locations[validation_error.value], "sweep." + axis.path, {found, message.required}};
}

/// Mistakes at the path of an axis are reported at that axis; so are others that no axis was reported for
/// before.
void tell(const SweepAxis& axis, const std::vector<ValidationError>& errors, std::set<std::string>& known,
          std::vector<Mistake>& mistakes) {
  std::size_t count = 0;
  for (const ValidationError& validation_error : errors) {
    const bool fresh = known.insert(mistake_text(validation_error.mistake)).second;
    if (!fresh && validation_error.mistake.path != axis.path) continue;
    if (++count <= most_told) mistakes.push_back(at_axis(axis, validation_error));
  }
  if (count > most_told)
    mistakes.push_back({axis.locations.back(),
                        "sweep." + axis.path,
                        {fmt::format("{} more contradictions", count - most_told),
                         "values that fit the rest of the case are required"}});
}

}  // namespace

void check_sweep_consistency(const ResolvedCase& resolved, std::vector<Mistake>& mistakes) {
  if (resolved.model() == no_model) return;
  std::vector<const SweepAxis*> axes;
  for (const SweepAxis& axis : resolved.axes())
    if (takes_part_in_consistency(axis.path) && !axis.values.empty()) axes.push_back(&axis);
  if (axes.empty()) return;
  const ResolvedCase reference = at_reference(resolved, axes);
  std::vector<std::vector<ValidationError>> errors;
  std::set<std::string> known;
  for (const Mistake& mistake : mistakes) known.insert(mistake_text(mistake));
  for (const SweepAxis* axis : axes)
    for (const ValidationError& validation_error : errors.emplace_back(errors_of(*axis, reference)))
      if (validation_error.mistake.path == axis->path) known.insert(mistake_text(validation_error.mistake));
  for (std::size_t i = 0; i < axes.size(); ++i) tell(*axes[i], errors[i], known, mistakes);
}

}  // namespace orbearing::app
