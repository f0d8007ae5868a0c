#include "app/case/sweep_axes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "app/case/field_table.hpp"
#include "app/case/resolved_writer.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

// Part of a step by which rounding may put the last point beside `to`.
constexpr double end_tolerance = 1e-9;

constexpr std::array<std::string_view, 3> range_keys{"from", "to", "step"};

struct Steps {
  double from = 0.0;  // [unit]
  double to = 0.0;    // [unit]
  double step = 0.0;  // [unit]
  std::string unit;   // unit of `from`; empty for plain numbers

  double count() const { return (to - from) / step; }
  std::string text(double value) const {
    return unit.empty() ? fmt::format("{}", value) : fmt::format("{} {}", value, unit);
  }
};

class AxisReader {
 public:
  AxisReader(const Field& field, const Member& member, std::vector<Mistake>& mistakes)
      : field_(field),
        key_(member.key),
        path_("sweep." + member.key),
        entry_(member.value),
        mistakes_(mistakes) {}

  SweepAxis read() {
    SweepAxis axis{key_, {}, {}, {}, entry_.location};
    if (entry_.shape == Entry::Shape::list) {
      read_values(axis);
    } else if (entry_.shape == Entry::Shape::block) {
      read_range(axis);
    } else {
      add_error(entry_.location, path_, describe(entry_) + " found", required_shape);
    }
    return axis;
  }

 private:
  static constexpr const char* required_shape =
      "a list of values or {from: ..., to: ..., step: ...} is required";

  void add_error(Location location, const std::string& path, std::string found, std::string required) {
    mistakes_.push_back({location, path, {std::move(found), std::move(required)}});
  }

  void read_values(SweepAxis& axis) {
    std::set<double> seen;
    std::vector<std::string> written;
    if (entry_.items.empty()) add_error(entry_.location, path_, "an empty list", required_shape);
    for (const Entry& item : entry_.items) {
      const FieldReading reading = read_field(field_, item);
      if (!reading.good) {
        mistakes_.push_back({item.location, path_, reading.message});
      } else if (!seen.insert(reading.value.number).second) {
        add_error(item.location, path_, describe(item) + " is listed twice", "each value once is required");
      } else {
        axis.values.push_back(reading.value.given);
        axis.numbers.push_back(reading.value.number);
        axis.locations.push_back(item.location);
        written.push_back(write_scalar(reading.value.given));
      }
    }
    axis.written = fmt::format("[{}]", fmt::join(written, ", "));
  }

  void read_range(SweepAxis& axis) {
    if (!has_range_keys()) return;
    const std::optional<Steps> steps = read_steps();
    if (!steps || !check_steps(*steps)) return;
    const auto last = static_cast<int>(std::lround(steps->count()));
    for (int i = 0; i <= last; ++i) {
      const double value = steps->from + i * steps->step;
      axis.values.push_back(steps->text(value));
      axis.numbers.push_back(steps->unit.empty() ? value
                                                 : *convert(value, steps->unit, field_.dimension.si).value);
    }
    axis.locations.assign(axis.values.size(), entry_.location);
    axis.written = fmt::format("{{from: {}, to: {}, step: {}}}", write_scalar(part("from").text),
                               write_scalar(part("to").text), write_scalar(part("step").text));
  }

  const Entry& part(std::string_view key) const { return find_member(entry_, key)->value; }

  bool has_range_keys() {
    const std::size_t before = mistakes_.size();
    read_each_once(entry_, path_, mistakes_, [&](const Member& member) {
      if (std::ranges::find(range_keys, member.key) == range_keys.end())
        add_error(member.location, path_ + "." + member.key, "unknown key",
                  "only from, to and step are required");
    });
    for (const std::string_view key : range_keys)
      if (find_member(entry_, key) == nullptr)
        add_error(entry_.location, fmt::format("{}.{}", path_, key), "missing", required_shape);
    return mistakes_.size() == before;
  }

  // `from` and `to` must be values of the field; then so is all between them.
  std::optional<Steps> read_steps() {
    Field unlimited = field_;
    unlimited.range = {.least = 0.0, .least_allowed = false};
    const bool good_from = check_part("from", field_);
    const bool good_to = check_part("to", field_);
    if (!check_part("step", unlimited) || !good_from || !good_to) return std::nullopt;
    const WrittenQuantity from = *split_quantity(part("from").text).value;
    return Steps{from.value, in_unit("to", from.unit), in_unit("step", from.unit), from.unit};
  }

  bool check_part(const char* key, const Field& field) {
    const FieldReading reading = read_field(field, part(key));
    if (!reading.good) mistakes_.push_back({part(key).location, path_ + "." + key, reading.message});
    return reading.good;
  }

  double in_unit(const char* key, const std::string& unit) const {
    const WrittenQuantity written = *split_quantity(part(key).text).value;
    if (written.unit == unit) return written.value;
    // Both are units of the field: converted through SI, which includes those of data sheets.
    const std::string_view si = field_.dimension.si;
    return *convert(written.value, written.unit, si).value / *convert(1.0, unit, si).value;
  }

  bool check_steps(const Steps& steps) {
    const std::size_t before = mistakes_.size();
    if (steps.to < steps.from)
      add_error(part("to").location, path_ + ".to", describe(part("to")) + " is less than 'from'",
                "a value of at least " + quote(part("from").text) + " is required");
    else if (!(steps.count() < most_points))
      add_error(part("step").location, path_ + ".step", describe(part("step")) + " makes too many points",
                fmt::format("at most {} points are required", most_points));
    else if (std::abs(steps.count() - std::round(steps.count())) > end_tolerance)
      add_error(part("step").location, path_ + ".step",
                describe(part("step")) + " leads past 'to', " + quote(part("to").text), required_step(steps));
    return mistakes_.size() == before;
  }

  // Names the end that this step does reach, and the step nearest to this one that reaches `to`.
  std::string required_step(const Steps& steps) const {
    const std::string end = steps.text(steps.from + std::floor(steps.count()) * steps.step);
    const double parts = std::max(1.0, std::round(steps.count()));
    const std::string step =
        field_.kind == Kind::integer ? "" : " such as '" + steps.text((steps.to - steps.from) / parts) + "'";
    return fmt::format("a step that divides the range{}, or 'to: {}', is required", step, end);
  }

  const Field& field_;
  std::string key_;
  std::string path_;
  const Entry& entry_;
  std::vector<Mistake>& mistakes_;
};

std::string path_hint(const FieldsByPath& fields, const std::string& key, unsigned model,
                      const CaseShape& shape) {
  std::vector<std::string> known;
  for (const auto& [path, field] : inputs_of(model, shape)) {
    if (!fields.takes(*field)) continue;
    if (path.starts_with(key + ".")) return fmt::format("the whole path, as in '{}', is required", path);
    known.push_back(path);
  }
  const std::string near = nearest_word(key, known);
  return near.empty() ? fmt::format("the path of {}{} is required", fields.kind, fields.example)
                      : fmt::format("the path of {} is required; did you mean '{}'?", fields.kind, near);
}

constexpr FieldsByPath swept_fields{.block = "sweep",
                                    .takes = can_be_swept,
                                    .kind = "a numeric field",
                                    .example = ", as in 'input.speed',",
                                    .wrong_kind = "a field that is no number"};

}  // namespace

void read_each_once(const Entry& block, const std::string& path, std::vector<Mistake>& mistakes,
                    const std::function<void(const Member&)>& read) {
  std::set<std::string> seen;
  for (const Member& member : block.members)
    if (seen.insert(member.key).second)
      read(member);
    else
      mistakes.push_back(
          {member.location, path + "." + member.key, {"duplicate key", "each key once is required"}});
}

const Field* field_by_path(const FieldsByPath& fields, const Member& member, unsigned model,
                           const CaseShape& shape, std::vector<Mistake>& mistakes) {
  const Field* field = find_field(member.key);
  const bool known = field != nullptr && (field->models & model) != 0 && belongs(shape, member.key);
  if (known && fields.takes(*field)) return field;
  const std::string found = !known             ? "unknown path"
                            : is_limit(*field) ? "a limit, which judges results and changes none"
                                               : std::string(fields.wrong_kind);
  mistakes.push_back({member.location,
                      fmt::format("{}.{}", fields.block, member.key),
                      {found, path_hint(fields, member.key, model, shape)}});
  return nullptr;
}

std::vector<SweepAxis> read_axes(const Entry& sweep, unsigned model, const CaseShape& shape,
                                 std::vector<Mistake>& mistakes) {
  std::vector<SweepAxis> axes;
  double points = 1.0;
  read_each_once(sweep, "sweep", mistakes, [&](const Member& member) {
    const Field* field = field_by_path(swept_fields, member, model, shape, mistakes);
    if (field == nullptr) return;
    axes.push_back(AxisReader(*field, member, mistakes).read());
    points *= static_cast<double>(axes.back().values.size());
  });
  if (points > most_points)
    mistakes.push_back({sweep.location,
                        "sweep",
                        {fmt::format("{} operating points", points),
                         fmt::format("at most {} points are required", most_points)}});
  return axes;
}

}  // namespace orbearing::app
