#include "app/case/catalogue_warnings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "app/case/catalogue_case.hpp"
#include "app/case/catalogue_file.hpp"
#include "app/case/catalogue_lines.hpp"
#include "app/case/input_keys.hpp"
#include "app/units.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

using namespace catalogue_lines;

namespace {

std::string inferred_warning(const std::string& path, const std::string& name,
                             const catalogue::Entry& entry) {
  const catalogue::Inside& inside = known_inside(entry);
  const char* element = catalogue::has_rollers(entry.family) ? "roller" : "ball";
  return fmt::format(
      "{}: the inside of {} is inferred from its printed ratings, not measured: {} {}s of {:.4g} mm on "
      "{:.4g} mm. C computed from them is {:.1f} % {} the printed one. Pass frequencies of the races are "
      "uncertain by about 0.5 % and those of a {} by 2 %; with one {} more or less, by {:.0f} %. State the "
      "{}s instead of the designation where they are known",
      path, maker_name(entry, name), inside.elements, element, per_milli * inside.diameter,
      per_milli * inside.pitch_diameter, 100.0 * std::abs(inside.dynamic_rating / entry.dynamic_rating - 1.0),
      inside.dynamic_rating < entry.dynamic_rating ? "below" : "above", element, element,
      100.0 / inside.elements, element);
}

// "2Z (shields on both sides)": what is read behind the designation of the line.
void add_suffixes(const ResolvedCase& in, const std::string& set, std::vector<std::string>& warnings) {
  const std::string path = set + keys().designation;
  const ReadDesignation read = read_designation(table_of_case(in, set), in.text(path));
  if (read.name.suffixes.empty()) return;
  std::vector<std::string> suffixes;
  bool clearance = false, cage = false;
  for (const catalogue::Suffix* one : read.name.suffixes) {
    suffixes.push_back(fmt::format("{} ({})", one->letters, one->meaning));
    clearance = clearance || one->clearance;
    cage = cage || (!one->cage.empty() && in.has(set + catalogue_keys::kMaterial));
  }
  warnings.push_back(
      fmt::format("{}: {} is read as {} with the suffixes {}. Sizes and ratings are those of {}; "
                  "{}{}state what else a suffix means{}",
                  path, quote(in.text(path)), read.name.base, fmt::join(suffixes, ", "),
                  name_of(*read.line, read.name.base),
                  clearance ? "the class of clearance is taken where the case states none; " : "",
                  cage ? "the material of the cage is taken where the case states none; " : "",
                  cage ? "" : ", as bearing.cage.material"));
}

// A stated cage that is not that of the designation. Suffixes that are only the maker's are no mistake:
// bearings of one designation have several cages.
void add_other_cage(const ResolvedCase& in, const std::string& set, std::vector<std::string>& warnings) {
  const std::string path = set + catalogue_keys::kMaterial;
  if (!is_stated(in, path)) return;
  const std::string& name = in.text(set + keys().designation);
  for (const catalogue::SuffixedName& reading : catalogue::suffixed_readings(name))
    for (const catalogue::Suffix* one : reading.suffixes)
      if (!one->cage.empty()) {
        if (one->cage != in.choice(path))
          warnings.push_back(
              fmt::format("{}: {} as stated contradicts the suffix {} ({}) of {}. Check which of "
                          "them is right",
                          path, in.choice(path), one->letters, one->meaning, quote(name)));
        return;
      }
}

// Ratings that a case states beside the designation of a bearing that has others.
void add_replaced_ratings(const ResolvedCase& in, const std::string& set, const catalogue::Entry& entry,
                          std::vector<std::string>& warnings) {
  const char* elements = catalogue::has_rollers(entry.family) ? "rollers" : "balls";
  for (const PrintedRating& rating : ratings_of(entry)) {
    const std::string path = set + rating.path;
    if (rating.value == 0.0 || !is_stated(in, path)) continue;
    if (newtons(in.quantity(path)) == newtons(rating.value)) {
      if (is_full_complement(in, set))
        warnings.push_back(fmt::format(
            "{}: {} as stated is that of {} with {} rollers in a cage; {} rollers without a cage have {}. "
            "Leave it out unless it is meant",
            path, in.given(path), name_of(entry, in.text(set + keys().designation)),
            known_inside(entry).elements, in.integer(set + keys().rollers),
            newtons(with_rollers_instead(rating, known_inside(entry), in.integer(set + keys().rollers)))));
      continue;
    }
    warnings.push_back(fmt::format(
        "{}: {} as stated replaces {} of {}; its {} stay as inferred for the latter", path, in.given(path),
        newtons(rating.value), name_of(entry, in.text(set + keys().designation)), elements));
  }
}

}  // namespace

std::vector<std::string> stated_beside_designation(const ResolvedCase& resolved,
                                                   const std::vector<std::string>& varied) {
  const auto is_varied = [&](const std::string& path) {
    return std::ranges::find(varied, path) != varied.end();
  };
  std::vector<std::string> messages;
  for (const std::string& path : varied) {
    const std::string set = set_of(path);
    if (path != set + keys().designation && path != set + catalogue_keys::kCatalogue) continue;
    std::vector<std::string> kept;
    for (const std::string& one :
         {keys().dynamic_capacity, keys().static_capacity, keys().fatigue_load_limit,
          keys().cage_inner_diameter, keys().cage_outer_diameter, keys().cage_width, keys().guide_land})
      if (is_stated(resolved, set + one) && !is_varied(set + one)) kept.push_back(set + one);
    if (!kept.empty())
      messages.push_back(
          fmt::format("{}: {}: found a varied bearing beside {} as stated, which would be the same "
                      "for each bearing; required: a case without {}, or values that vary too",
                      resolved.file(), path, fmt::join(kept, ", "), kept.size() > 1 ? "them" : "it"));
  }
  return messages;
}

namespace {

// A table of the case in which no line has the designation: the ratings are those of the program's own.
void add_table_without_effect(const ResolvedCase& in, const std::string& set,
                              std::vector<std::string>& warnings) {
  const std::string path = set + catalogue_keys::kCatalogue;
  const FieldValue* table = table_of_case(in, set);
  const std::string name = in.text(set + keys().designation);
  if (table == nullptr || table->texts.empty() || catalogue::find(catalogue_of(*table), name) != nullptr)
    return;
  std::vector<std::string> names;
  for (const catalogue::Entry& entry : catalogue_of(*table))
    names.insert(names.end(), entry.designations.begin(), entry.designations.end());
  constexpr std::size_t most = 5;
  const std::string others = names.size() > most ? fmt::format(" and {} more", names.size() - most) : "";
  names.resize(std::min(names.size(), most));
  warnings.push_back(
      fmt::format("{}: {} has no effect: it counts only where a line has the designation '{}'. Lines of it: "
                  "{}{}. The line of the project's own catalogue is used",
                  path, in.has(path) ? in.written(path) : "", name, fmt::join(names, ", "), others));
}

}  // namespace

std::vector<std::string> inferred_warnings(const ResolvedCase& resolved) {
  std::vector<std::string> warnings;
  for (const Input& input : resolved.inputs()) {
    if (input.field->path != keys().designation || !resolved.has(input.path)) continue;
    const std::string set = set_of(input.path);
    const catalogue::Entry* entry = line_of(resolved, set);
    if (entry == nullptr) continue;
    add_suffixes(resolved, set, warnings);
    add_other_cage(resolved, set, warnings);
    add_table_without_effect(resolved, set, warnings);
    warnings.push_back(inferred_warning(input.path, resolved.text(input.path), *entry));
    if (const std::string rings = set + keys().rings; resolved.has(rings) &&
                                                      resolved.choice(rings) != "both" &&
                                                      entry->family != catalogue::Family::needle_cage)
      warnings.push_back(
          fmt::format("{}: {}; ratings of {} are for its own rings. They hold where pin and planet have "
                      "raceways as hard and as smooth, of bearing steel",
                      rings, resolved.choice(rings), name_of(*entry, resolved.text(input.path))));
    add_replaced_ratings(resolved, set, *entry, warnings);
  }
  return warnings;
}

}  // namespace orbearing::app
