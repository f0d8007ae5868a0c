#include "app/case/consistency.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <set>

#include "app/case/field_table.hpp"
#include "app/case/settings.hpp"

namespace orbearing::app {

namespace {

constexpr std::size_t most_told = 20;  // mistakes of one axis

struct Objection {
  std::size_t value = 0;  // of the axis
  Mistake mistake;        // as of the value set alone, with the path that does not fit
};

/// Objections to the values of one axis.
struct AxisObjections {
  const SweepAxis* axis = nullptr;
  std::vector<Objection> objections;
};

std::string mistake_text(const Mistake& mistake) {
  return mistake.path + ": " + mistake.complaint.found + "; " + mistake.complaint.required;
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

AxisObjections objections_to(const SweepAxis& axis, const ResolvedCase& reference) {
  AxisObjections found{&axis, {}};
  for (std::size_t i = 0; i < axis.values.size(); ++i) {
    std::vector<Mistake> mistakes;
    reference.with({axis.setting(i)}, mistakes);
    for (Mistake& mistake : mistakes) found.objections.push_back({i, std::move(mistake)});
  }
  return found;
}

Mistake at_axis(const SweepAxis& axis, const Objection& objection) {
  const std::string& path = objection.mistake.path;
  const Complaint& complaint = objection.mistake.complaint;
  const std::string found =
      path == axis.path
          ? complaint.found
          : fmt::format("{} contradicts {}: {}", quote(axis.values[objection.value]), path, complaint.found);
  return {axis.places[objection.value], "sweep." + axis.path, {found, complaint.required}};
}

/// An axis is to blame for what is said of its own path; of the rest, for what nobody was blamed for before.
void tell(const AxisObjections& found, std::set<std::string>& known, std::vector<Mistake>& mistakes) {
  std::size_t count = 0;
  for (const Objection& objection : found.objections) {
    const bool fresh = known.insert(mistake_text(objection.mistake)).second;
    if (!fresh && objection.mistake.path != found.axis->path) continue;
    if (++count <= most_told) mistakes.push_back(at_axis(*found.axis, objection));
  }
  if (count > most_told)
    mistakes.push_back({found.axis->places.back(),
                        "sweep." + found.axis->path,
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
  std::vector<AxisObjections> all;
  std::set<std::string> known;
  for (const Mistake& mistake : mistakes) known.insert(mistake_text(mistake));
  for (const SweepAxis* axis : axes) {
    all.push_back(objections_to(*axis, reference));
    for (const Objection& objection : all.back().objections)
      if (objection.mistake.path == axis->path) known.insert(mistake_text(objection.mistake));
  }
  for (const AxisObjections& found : all) tell(found, known, mistakes);
}

}  // namespace orbearing::app
