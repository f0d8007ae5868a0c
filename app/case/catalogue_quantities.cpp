#include "app/case/catalogue_quantities.hpp"

#include <algorithm>
#include <stdexcept>

#include "app/case/catalogue_case.hpp"
#include "app/case/catalogue_file.hpp"
#include "app/case/catalogue_lines.hpp"
#include "app/case/input_keys.hpp"
#include "app/units.hpp"

namespace orbearing::app {

using namespace catalogue_lines;

namespace {

std::vector<Derived> quantities_of_one(const ResolvedCase& in) {
  std::vector<Derived> rows;
  if (const catalogue::Entry* line = line_of(in)) {
    const catalogue::Entry& entry = *line;
    const catalogue::Inside& inside = known_inside(entry);
    const std::string whose = " of " + name_of(entry, in.text(keys().designation));
    rows.push_back({"bearing.catalogue.dynamic_rating", entry.dynamic_rating, "N", "C" + whose});
    rows.push_back({"bearing.catalogue.dynamic_rating_inferred", inside.dynamic_rating, "N",
                    "C of ISO 281 by the inferred geometry"});
    rows.push_back({"bearing.catalogue.static_rating", entry.static_rating, "N", "C_0" + whose});
    rows.push_back({"bearing.catalogue.static_rating_inferred", inside.static_rating, "N",
                    "C_0 of ISO 76 by the inferred geometry"});
    if (entry.fatigue_load_limit > 0.0)
      rows.push_back({"bearing.catalogue.fatigue_load_limit", entry.fatigue_load_limit, "N", "C_u" + whose});
  }
  if (in.has(keys().clearance_class)) {
    const catalogue::ClearanceRange range =
        catalogue::clearance_range(family_of(in), class_of(in.choice(keys().clearance_class)), *bore_of(in));
    rows.push_back(
        {"bearing.clearance_class.least", per_micro * range.least, "um", "of bearings of this class"});
    rows.push_back(
        {"bearing.clearance_class.most", per_micro * range.most, "um", "of bearings of this class"});
  }
  for (const Seat& seat : seats()) {
    if (!has_all(in, {seat.tolerance, seat.diameter})) continue;
    const catalogue::Deviations range = seat.range(in.choice(seat.tolerance), in.quantity(seat.diameter));
    const std::string interference = seat.interference;
    rows.push_back(
        {interference + ".least", per_micro * range.least, "um", "of seats of this class; negative: loose"});
    rows.push_back({interference + ".most", per_micro * range.most, "um", "of seats of this class"});
  }
  return rows;
}

}  // namespace

catalogue::ClearanceRange clearance_range_of(const ResolvedCase& in, const std::string& which) {
  const std::optional<double> bore = bore_of(in);
  if (!bore) throw std::invalid_argument(kBoreRequired);
  return catalogue::clearance_range(family_of(in), class_of(which), *bore);
}

namespace {

using bearing::friction::BearingSize;
using bearing::friction::TorqueFamily;

TorqueFamily family_of(const ResolvedCase& in, const catalogue::Entry* entry) {
  if (in.model() & with_rollers)
    return is_full_complement(in) ? TorqueFamily::full_complement : TorqueFamily::cylindrical;
  const double angle = entry != nullptr ? entry->contact_angle : in.quantity(keys().contact_angle);
  return angle == 0.0 ? TorqueFamily::deep_groove : TorqueFamily::angular_contact;
}

// Series: the digits before the bore code, 2 or 22 of cylindrical rollers, 62 of balls, whose first digit is
// the type.
void put_series(const std::string& designation, BearingSize& size) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto begin = std::ranges::find_if(designation, is_digit);
  const auto end = std::find_if_not(begin, designation.end(), is_digit);
  const std::string digits(begin, end);
  constexpr std::size_t bore_code = 2;
  if (digits.size() < bore_code + 1) return;
  const std::string series = digits.substr(0, digits.size() - bore_code);
  size.diameter_series = series.back() - '0';
  const bool rollers = size.family == TorqueFamily::cylindrical;
  size.wide = rollers && series.size() > 1 && series.front() >= '2';
}

}  // namespace

std::optional<BearingSize> size_of(const ResolvedCase& in) {
  const catalogue::Entry* entry = line_of(in);
  BearingSize size{.family = family_of(in, entry)};
  if (entry != nullptr && entry->family != catalogue::Family::needle_cage) {
    size.bore = entry->bore;
    size.outside = entry->outside;
    size.width = entry->width;
    put_series(in.text(keys().designation), size);
  } else if (has_all(in, {keys().bore, keys().outside_diameter, keys().width})) {
    size.bore = in.quantity(keys().bore);
    size.outside = in.quantity(keys().outside_diameter);
    size.width = in.quantity(keys().width);
  } else {
    return std::nullopt;
  }
  return size;
}

std::optional<std::string> table_in_use(const ResolvedCase& resolved, const std::string& path) {
  const std::string set = set_of(path);
  const catalogue::Entry* entry = line_of(resolved, set);
  if (entry == nullptr ||
      entry != catalogue::find(catalogue_of(resolved.value(path)), resolved.text(set + keys().designation)))
    return std::nullopt;
  return table_of(*entry);
}

std::vector<Derived> catalogue_quantities(const ResolvedCase& resolved) {
  if (!resolved.shape().several) return quantities_of_one(resolved);
  std::vector<Derived> rows;
  for (const std::string& set : resolved.shape().sets)
    for (Derived& row : quantities_of_one(resolved.of_set(set))) {
      row.path = set_prefix(set) + row.path;
      rows.push_back(std::move(row));
    }
  return rows;
}

}  // namespace orbearing::app
