#include "app/case/catalogue_case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>

#include "app/case/catalogue_fields.hpp"
#include "app/case/catalogue_file.hpp"
#include "app/case/field_table.hpp"
#include "app/case/mistake.hpp"
#include "app/case/oil_case.hpp"
#include "app/units.hpp"
#include "bearing/catalogue/classes.hpp"
#include "bearing/catalogue/entries.hpp"
#include "bearing/catalogue/suffixes.hpp"
#include "bearing/default_design.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::app {

namespace {

namespace catalogue = bearing::catalogue;
using constants::pi;

// Fullest rings of rollers keep this much of their diameter between neighbours, so that the last one goes in.
constexpr double kLeastGap = 1e-3;  // [-]

std::string millimetres(double length) {
  return fmt::format("{:.9g} mm", per_milli * length);
}

int most_rollers(double pitch_diameter, double roller_diameter) {
  return static_cast<int>(std::floor(pi / std::asin((1.0 + kLeastGap) * roller_diameter / pitch_diameter)));
}

catalogue::ClearanceClass class_of(const std::string& name) {
  if (const auto known = value_named<catalogue::ClearanceClass>(name)) return *known;
  throw std::logic_error("no clearance class '" + name + "'");
}

// Seat of a bearing by a tolerance class instead of an interference.
struct Seat {
  const char *tolerance, *diameter, *interference;
  catalogue::Deviations (*range)(std::string_view tolerance, double diameter);
};
constexpr std::array<Seat, 2> kSeats{
    {{catalogue_keys::kPinClass, "bearing.bore", catalogue_keys::kInnerFit, catalogue::inner_interference},
     {catalogue_keys::kPlanetClass, "bearing.outside_diameter", catalogue_keys::kOuterFit,
      catalogue::outer_interference}}};

// By its line, if any, or as a case states it.
catalogue::Family family_of(const catalogue::Entry* entry, unsigned model, bool has_contact_angle) {
  if (entry != nullptr) return entry->family;
  if ((model & with_rollers) != 0) return catalogue::Family::cylindrical;
  return has_contact_angle ? catalogue::Family::angular_contact : catalogue::Family::deep_groove;
}

// Cached, since each point of a sweep is a copy of its case and repeats the request. Throws
// std::invalid_argument where no interior fits.
const catalogue::Inside& known_inside(const catalogue::Entry& entry) {
  static std::map<const catalogue::Entry*, catalogue::Inside> known;
  static std::mutex one_at_a_time;
  const std::scoped_lock lock(one_at_a_time);
  const auto found = known.find(&entry);
  return found != known.end() ? found->second
                              : known.emplace(&entry, catalogue::inside_of(entry)).first->second;
}

// A user's own lines go before those of the program. `table` may be null.
const catalogue::Entry* line_as_written(const FieldValue* table, const std::string& designation) {
  if (table != nullptr && !table->texts.empty())
    if (const catalogue::Entry* own = catalogue::find(catalogue_of(*table), designation)) return own;
  return catalogue::find(built_in_catalogue(), designation);
}

/// A line, and suffixes of the designation that the line does not have.
struct ReadDesignation {
  const catalogue::Entry* line = nullptr;
  catalogue::SuffixedName name{};
};

// A suffix that is listed is a part of the designation; others are read behind a listed one.
ReadDesignation read_designation(const FieldValue* table, const std::string& designation) {
  if (const catalogue::Entry* line = line_as_written(table, designation)) return {line, {designation, {}}};
  for (const catalogue::SuffixedName& reading : catalogue::suffixed_readings(designation))
    if (const catalogue::Entry* line = line_as_written(table, reading.base)) return {line, reading};
  return {};
}

const catalogue::Entry* line_of(const FieldValue* table, const std::string& designation) {
  return read_designation(table, designation).line;
}

const FieldValue* table_of_case(const ResolvedCase& in, const std::string& set = "") {
  const std::string path = set + catalogue_keys::kCatalogue;
  return in.has(path) ? &in.value(path) : nullptr;
}

// Null where the case has no designation, or one that no line has.
const catalogue::Entry* line_of(const ResolvedCase& in, const std::string& set = "") {
  const std::string path = set + catalogue_keys::kDesignation;
  return in.has(path) ? line_of(table_of_case(in, set), in.text(path)) : nullptr;
}

// A bearing as its maker calls it: without suffixes that were read behind a listed designation.
std::string maker_name(const catalogue::Entry& entry, const std::string& designation) {
  const std::vector<catalogue::Entry> line{entry};
  if (catalogue::find(line, designation) == nullptr)
    for (const catalogue::SuffixedName& reading : catalogue::suffixed_readings(designation))
      if (catalogue::find(line, reading.base) != nullptr) return catalogue::full_name(entry, reading.base);
  return catalogue::full_name(entry, designation);
}

std::string name_of(const catalogue::Entry& entry, const std::string& designation) {
  return fmt::format("{} ({})", maker_name(entry, designation), entry.source);
}

// Designations of rollers, or of balls: a user's own first.
std::vector<std::string> designations_of(const FieldValue* table, bool rollers) {
  std::vector<std::string> names;
  const auto add = [&](const std::vector<catalogue::Entry>& entries) {
    for (const catalogue::Entry& entry : entries)
      if (catalogue::has_rollers(entry.family) == rollers)
        for (const std::string& name : entry.designations)
          if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  if (table != nullptr && !table->texts.empty()) add(catalogue_of(*table));
  add(built_in_catalogue());
  return names;
}

// Ratings of a bearing that a line prints, by the inputs that may state others; 0: not printed.
struct PrintedRating {
  const char* path;
  double value;  // [N]
};

std::array<PrintedRating, 3> ratings_of(const catalogue::Entry& entry) {
  return {{{catalogue_keys::kDynamic, entry.dynamic_rating},
           {catalogue_keys::kStatic, entry.static_rating},
           {catalogue_keys::kLimit, entry.fatigue_load_limit}}};
}

/// Cage by a designation or by the catalogue line that it selects: material and reason.
struct NamedCage {
  std::string_view material;
  std::string reason;  // "the suffix P (cage of polyamide) of NJ 2206 ECP"
};

// Suffixes of the designation come before what the line has, and the maker's suffix comes last.
std::optional<NamedCage> cage_of(const FieldValue* table, const std::string& designation) {
  const catalogue::Entry* line = line_of(table, designation);
  if (line == nullptr) return std::nullopt;
  const auto by_suffix = [](const catalogue::Suffix& one, const std::string& name) {
    return NamedCage{one.cage, fmt::format("the suffix {} ({}) of {}", one.letters, one.meaning, name)};
  };
  for (const catalogue::SuffixedName& reading : catalogue::suffixed_readings(designation))
    for (const catalogue::Suffix* one : reading.suffixes)
      if (!one->cage.empty()) return by_suffix(*one, quote(designation));
  if (!line->cage.empty())
    return NamedCage{line->cage, fmt::format("a cage of {} in {}", line->cage, name_of(*line, designation))};
  const catalogue::Suffix* own = catalogue::suffix_named(line->suffix);
  if (own != nullptr && !own->cage.empty()) return by_suffix(*own, name_of(*line, designation));
  return std::nullopt;
}

std::string newtons(double force) {
  return fmt::format("{:g} N", force);
}

// Exponent of a rating of rollers over their number, all else equal: C of [ISO281], C_0 of [ISO76], and C_u,
// which is proportional to C_0.
double exponent_of_number(std::string_view rating) {
  return rating == catalogue_keys::kDynamic ? 0.75 : 1.0;
}

// A printed rating with `rollers` instead of those of the line.
double with_rollers_instead(const PrintedRating& rating, const catalogue::Inside& inside, int rollers) {
  return rating.value *
         std::pow(static_cast<double>(rollers) / inside.elements, exponent_of_number(rating.path));
}

bool is_full(const FieldValue* complement) {
  return complement != nullptr && complement->given == "full";
}

// Inputs that a case or one of its sets states, and the values that replace them.
class CatalogueCase {
 public:
  CatalogueCase(CaseData& data, std::string prefix, Model model)
      : data_(data), prefix_(std::move(prefix)), model_(model) {}

  void fill() {
    fill_designation();
    fill_default_class();
    fill_class();
    fill_seats();
    fill_material();
    fill_complement();
    fill_ratings();
    fill_rings();
    fill_cage_of_stated_inside();
  }

 private:
  const FieldValue* find(const std::string& path) const {
    const auto found = data_.values.find(prefix_ + path);
    return found == data_.values.end() ? nullptr : &found->second.value;
  }
  bool takes(const std::string& path) const {
    const Field* field = find_field(path);
    return field != nullptr && (field->models & model_) != 0;
  }
  void put(const std::string& path, const std::string& text, const std::string& reason) {
    if (takes(path)) substitute(data_, prefix_ + path, text, reason);
  }
  void put_default(const std::string& path, const std::string& text, const std::string& reason) {
    if (takes(path)) put_where_absent(data_, prefix_ + path, text, reason);
  }

  void fill_designation() {
    const FieldValue* name = find(catalogue_keys::kDesignation);
    entry_ = name == nullptr ? nullptr : line_of(find(catalogue_keys::kCatalogue), name->given);
    if (entry_ == nullptr) return;
    const bool rollers = catalogue::has_rollers(entry_->family);
    if (rollers != ((model_ & with_rollers) != 0)) return;  // reported by check_catalogue_bearing()
    try {
      fill_inside(known_inside(*entry_), name->given);
    } catch (const std::invalid_argument&) {  // reported by check_catalogue_bearing()
    }
  }

  void fill_inside(const catalogue::Inside& inside, const std::string& name) {
    const bool rollers = catalogue::has_rollers(entry_->family);
    const std::string published = "default: " + name_of(*entry_, name);
    const std::string inferred = fmt::format(
        "default: inferred from the ratings of {} (docs/bearings.md); one {} more would leave a {} of "
        "{:.2g} % less",
        name, rollers ? "roller" : "ball", rollers ? "length" : "diameter", -100.0 * inside.per_element);
    put(rollers ? catalogue_keys::kRollers : "bearing.balls", fmt::format("{}", inside.elements), inferred);
    put(rollers ? "bearing.roller_diameter" : "bearing.ball_diameter", millimetres(inside.diameter),
        inferred);
    if (rollers)
      put("bearing.roller_length", millimetres(inside.length), inferred);
    else
      put("bearing.contact_angle", fmt::format("{:g} deg", kDegree * entry_->contact_angle), published);
    if (entry_->family == catalogue::Family::angular_contact)
      put_default(catalogue_keys::kClearance, "0 um",
                  "default: without load the balls touch at the nominal contact angle");
    put("bearing.pitch_diameter", millimetres(inside.pitch_diameter), inferred);
    if (entry_->family != catalogue::Family::needle_cage) {
      put("bearing.bore", millimetres(entry_->bore), published);
      put("bearing.outside_diameter", millimetres(entry_->outside), published);
    } else {
      put_default(catalogue_keys::kRings, "none", published + ", which has no rings");
    }
    put("bearing.width", millimetres(entry_->width), published);
    inside_ = &inside;
    if (rollers) put_default("bearing.type", "cylindrical-roller", published);
    fill_default_cage(inside);
  }

  // Stated ratings remain. Without a cage there are more rollers than the line's ratings apply to.
  void fill_ratings() {
    if (inside_ == nullptr) return;
    const std::string published = "default: " + name_of(*entry_, find(catalogue_keys::kDesignation)->given);
    const FieldValue* rollers = find(catalogue_keys::kRollers);
    const bool full = is_full(find(catalogue_keys::kComplement)) && rollers != nullptr;
    for (const PrintedRating& rating : ratings_of(*entry_)) {
      if (rating.value == 0.0) continue;
      if (full) {
        const int count = static_cast<int>(rollers->number);
        put_default(rating.path, newtons(with_rollers_instead(rating, *inside_, count)),
                    fmt::format("{}: {} of {} rollers in a cage, times ({}/{})^{:g}", published,
                                newtons(rating.value), inside_->elements, count, inside_->elements,
                                exponent_of_number(rating.path)));
        continue;
      }
      const FieldValue* stated = find(rating.path);
      if (stated != nullptr && newtons(stated->number) == newtons(rating.value))
        put(rating.path, newtons(rating.value), published);
      else
        put_default(rating.path, newtons(rating.value), published);
    }
  }

  void fill_default_cage(const catalogue::Inside& inside) {
    const bool needles = entry_->family == catalogue::Family::needle_cage;
    put_cage(needles ? bearing::default_cage_size(inside.pitch_diameter, inside.diameter, inside.length,
                                                  entry_->width, 1.0)
                     : bearing::default_cage_size(inside.pitch_diameter, inside.diameter, inside.length,
                                                  entry_->width));
  }

  // Cage of a bearing outside the catalogue, from its rollers or balls as stated.
  void fill_cage_of_stated_inside() {
    const FieldValue *pitch = find("bearing.pitch_diameter"), *width = find("bearing.width"),
                     *roller = find("bearing.roller_diameter"), *ball = find("bearing.ball_diameter"),
                     *length = find("bearing.roller_length");
    const FieldValue* diameter = roller != nullptr ? roller : ball;
    if (inside_ != nullptr || is_full(find(catalogue_keys::kComplement)) || pitch == nullptr ||
        width == nullptr || diameter == nullptr || (roller != nullptr && length == nullptr))
      return;
    put_cage(bearing::default_cage_size(pitch->number, diameter->number,
                                        roller != nullptr ? length->number : diameter->number,
                                        width->number));
  }

  void put_cage(const bearing::CageSize& cage) {
    if ((model_ & described::in_motion) == 0) return;  // others need none
    const std::string reason =
        "default: a typical cage of a bearing of this section, guided at the outer ring";
    put_default("bearing.cage.inner_diameter", millimetres(cage.inner_diameter), reason);
    put_default("bearing.cage.outer_diameter", millimetres(cage.outer_diameter), reason);
    put_default("bearing.cage.width", millimetres(cage.width), reason);
  }

  // Whether the bearing has both rings, and so a clearance before mounting.
  bool has_clearance_before_mounting() const {
    const FieldValue* rings = find(catalogue_keys::kRings);
    return entry_ != nullptr && entry_->family != catalogue::Family::needle_cage &&
           (rings == nullptr || rings->given == "both");
  }

  // A clearance that takes the place of a default class is before mounting as well. Planets with two gears,
  // or in pairs, take that of the running bearing alone.
  void fill_state_of_stated_clearance() {
    if (entry_ == nullptr) return;
    const bool before_mounting = has_clearance_before_mounting() &&
                                 find("gearset.stepped_planet.teeth") == nullptr &&
                                 find("gearset.second_planet.teeth") == nullptr;
    const Field& running = *find_field(catalogue_keys::kState);
    put_default(catalogue_keys::kState, before_mounting ? "unmounted" : running.default_text,
                "default: " + (before_mounting ? "clearance before mounting, as that of a designation's class"
                                               : running.default_reason));
  }

  // Clearance class of the designation's suffix, else normal: the class of bearings ordered without another
  // one.
  void fill_default_class() {
    const std::string path = prefix_ + catalogue_keys::kClass;
    auto known = data_.values.find(path);
    const auto clearance = data_.values.find(prefix_ + catalogue_keys::kClearance);
    const bool stated = clearance != data_.values.end() && !clearance->second.from_default &&
                        clearance->second.replaced.empty();
    if (known != data_.values.end() && known->second.from_default && stated) {
      data_.values.erase(known);
      data_.assumed.erase(path);
      known = data_.values.end();
    }
    if (known == data_.values.end() && stated) return fill_state_of_stated_clearance();
    const FieldValue* state = find(catalogue_keys::kState);
    if (known != data_.values.end() || clearance != data_.values.end() || !has_clearance_before_mounting() ||
        (state != nullptr && state->given == "operating"))
      return;
    const ReadDesignation read =
        read_designation(find(catalogue_keys::kCatalogue), find(catalogue_keys::kDesignation)->given);
    for (const catalogue::Suffix* suffix : read.name.suffixes)
      if (suffix->clearance)
        return put_default(catalogue_keys::kClass, std::string(suffix->letters),
                           "default: the suffix of bearing.designation");
    put_default(catalogue_keys::kClass, "CN",
                "default: normal clearance, as a catalogue bearing has it whose designation names no other");
  }

  void fill_class() {
    const FieldValue *name = find(catalogue_keys::kClass), *bore = find("bearing.bore");
    if (name == nullptr || (entry_ == nullptr && bore == nullptr)) return;
    const double diameter = entry_ != nullptr ? entry_->bore : bore->number;
    try {
      const FieldValue* angle = find("bearing.contact_angle");
      const catalogue::ClearanceRange range =
          catalogue::clearance_range(family_of(entry_, model_, angle != nullptr && angle->number != 0.0),
                                     class_of(name->given), diameter);
      put(catalogue_keys::kClearance, fmt::format("{:g} um", per_micro * range.middle()),
          fmt::format("default: middle of class {}, {:g} to {:g} um (ISO 5753)", name->given,
                      per_micro * range.least, per_micro * range.most));
      put_default(catalogue_keys::kState, "unmounted",
                  "default: a clearance class is for an unmounted bearing");
    } catch (const std::invalid_argument&) {  // reported by check_catalogue_bearing()
    }
  }

  // Each seat by its class.
  void fill_seats() {
    for (const Seat& seat : kSeats) {
      const FieldValue *name = find(seat.tolerance), *size = find(seat.diameter);
      if (name == nullptr || size == nullptr) continue;
      try {
        const catalogue::Deviations range = seat.range(name->given, size->number);
        put(seat.interference, fmt::format("{:g} um", per_micro * range.middle()),
            fmt::format("default: middle of class {}, {:g} to {:g} um (ISO 286, ISO 492)", name->given,
                        per_micro * range.least, per_micro * range.most));
      } catch (const std::invalid_argument&) {  // reported by check_catalogue_bearing()
      }
    }
  }

  // Material by the designation, where a cage has neither a stated material nor a stated density.
  void fill_named_material() {
    if (entry_ == nullptr || (model_ & described::in_motion) == 0 ||  // others may have no cage
        is_full(find(catalogue_keys::kComplement)))
      return;
    if (const auto density = data_.values.find(prefix_ + catalogue_keys::kDensity);
        density != data_.values.end() && !density->second.from_default)
      return;
    if (const auto named =
            cage_of(find(catalogue_keys::kCatalogue), find(catalogue_keys::kDesignation)->given))
      put_default(catalogue_keys::kMaterial, std::string(named->material), "default: " + named->reason);
  }

  void fill_material() {
    fill_named_material();
    const FieldValue* name = find(catalogue_keys::kMaterial);
    if (name == nullptr) return;
    const bearing::CageMaterial& material = bearing::cage_material(name->given);
    put(catalogue_keys::kDensity, fmt::format("{:g} kg/m3", material.density),
        fmt::format("default: a cage of {}", material.name));
  }

  // Number of rollers of a full complement where it is left out: as many as fit.
  void fill_complement() {
    const FieldValue *complement = find(catalogue_keys::kComplement), *pitch = find("bearing.pitch_diameter"),
                     *diameter = find("bearing.roller_diameter");
    if (!is_full(complement) || pitch == nullptr || diameter == nullptr) return;
    if (!(diameter->number < pitch->number)) return;
    const std::string most = fmt::format("{}", most_rollers(pitch->number, diameter->number));
    const std::string reason = "default: a full complement, the largest number that fits";
    if (entry_ != nullptr)
      put(catalogue_keys::kRollers, most, reason);  // the designation's own number is that of a cage
    else
      put_default(catalogue_keys::kRollers, most, reason);
  }

  // The pin and the bore of the planet are the races.
  void fill_rings() {
    const FieldValue *rings = find(catalogue_keys::kRings), *pitch = find("bearing.pitch_diameter"),
                     *diameter = find("bearing.roller_diameter"),
                     *clearance = find(catalogue_keys::kClearance);
    if (rings == nullptr || rings->given == "both" || pitch == nullptr || diameter == nullptr ||
        clearance == nullptr)
      return;
    const double reach = diameter->number + 0.5 * clearance->number;
    put("bearing.bore", millimetres(pitch->number - reach), "default: the pin, on which the rollers run");
    if (rings->given == "none")
      put("bearing.outside_diameter", millimetres(pitch->number + reach),
          "default: the bore of the planet, in which the rollers run");
  }

  CaseData& data_;
  std::string prefix_;
  Model model_;
  const catalogue::Entry* entry_ = nullptr;
  const catalogue::Inside* inside_ = nullptr;  // of that line, where it has one that this case takes
};

}  // namespace

namespace {

// Types of which no catalogue holds a line, by their basic numbers as ISO and DIN 623 write them.
struct OtherType {
  std::size_t digits;
  std::string_view letters;                // "*": any but those of cylindrical bearings, NU, NJ, NUP and N
  std::array<std::string_view, 4> begins;  // of the digits; they may repeat, and an empty one is in all
  const char *words, *type;                // of planet bearings; null: not computed
};

constexpr std::array kOtherTypes{
    OtherType{5, "*", {"30", "31", "32", "33"}, "a tapered roller bearing", "tapered-roller"},
    OtherType{5, "", {"292", "293", "294", "294"}, "a spherical roller thrust bearing", nullptr},
    OtherType{5, "*", {"21", "22", "23", "24"}, "a spherical roller bearing", "spherical-roller"},
    OtherType{5, "", {"51", "52", "53", "54"}, "a thrust ball bearing", nullptr},
    OtherType{5, "", {"81", "81", "89", "89"}, "a cylindrical roller thrust bearing", nullptr},
    OtherType{4, "", {"12", "13", "22", "23"}, "a self-aligning ball bearing", nullptr},
    OtherType{4, "", {"3", "3", "3", "3"}, "a double-row angular contact ball bearing", nullptr},
    OtherType{3, "QJ", {}, "a four-point contact ball bearing", nullptr},
    OtherType{4, "C", {}, "a toroidal roller bearing", nullptr}};

// Null for types with lines, and for names that are none of these.
const OtherType* other_type(std::string_view name) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto begin = std::ranges::find_if(name, is_digit);
  const auto end = std::find_if_not(begin, name.end(), is_digit);
  const std::string_view digits =
      name.substr(static_cast<std::size_t>(begin - name.begin()), static_cast<std::size_t>(end - begin));
  std::string_view letters = name.substr(0, static_cast<std::size_t>(begin - name.begin()));
  while (!letters.empty() && letters.back() == ' ') letters.remove_suffix(1);
  const auto found = std::ranges::find_if(kOtherTypes, [&](const OtherType& one) {
    const bool fits = one.letters == "*" ? !name.starts_with('N') : one.letters == letters;
    return fits && one.digits == digits.size() &&
           std::ranges::any_of(one.begins,
                               [&](std::string_view number) { return digits.starts_with(number); });
  });
  return found == kOtherTypes.end() ? nullptr : found;
}

// "NCF 2207", "SL 18 2207", "NJG 2307": series of several makers.
bool is_full_complement_name(std::string_view name) {
  return std::ranges::any_of(std::array<std::string_view, 5>{"NCF", "SL", "NJG", "NNCF", "NNC"},
                             [&](std::string_view series) { return name.starts_with(series); });
}

}  // namespace

std::optional<ConsistencyMessage> unknown_designation(const std::string& name, const FieldValue* table,
                                                      Model model) {
  if (line_of(table, name) != nullptr) return std::nullopt;
  if (const OtherType* other = other_type(name))
    return ConsistencyMessage{
        fmt::format("{}, {}, of which no catalogue has a line", quote(name), other->words),
        other->type == nullptr
            ? std::string("a cylindrical, needle, tapered or spherical roller bearing, or a deep groove or "
                          "angular contact ball bearing, is required: others are not computed")
        : (model & planetary_drivetrain) != 0
            ? fmt::format("bearing.type: {} with bearing.rows.contact_angle and number, diameter, length and "
                          "pitch diameter of its rollers is required instead of the designation",
                          other->type)
            : fmt::format("a planet bearing is required (model: planetary-drivetrain, bearing.type: {}): "
                          "single bearings of this type are not computed",
                          other->type)};
  constexpr std::size_t shown = 5;
  const bool rollers = (model & with_rollers) != 0;
  const std::string found = fmt::format("{} is {}", quote(name),
                                        table == nullptr ? "not in the catalogue" : "in neither catalogue");
  if (rollers && is_full_complement_name(name))
    return ConsistencyMessage{
        found + ", which lists bearings with a cage",
        "for a full complement state bearing.complement: full with roller_diameter, roller_length, "
        "pitch_diameter, bore, outside_diameter and width, and its ratings where they are printed; or your "
        "own "
        "row (bearing.catalogue: FILE)"};
  return ConsistencyMessage{
      found,
      fmt::format(
          "a listed designation is required, perhaps with common suffixes; nearest: {}. For another bearing, "
          "state your own row (bearing.catalogue: FILE), or number, diameter and pitch diameter of its {}",
          fmt::join(catalogue::nearest(designations_of(table, rollers), name, shown), ", "),
          rollers ? "rollers" : "balls")};
}

namespace {

void check_designation(CheckedCase& in) {
  if (!in.has(catalogue_keys::kDesignation)) return;
  const auto add_error = [&](std::string found, std::string required) {
    in.add_error_at(catalogue_keys::kDesignation, std::move(found), std::move(required));
  };
  const std::string& name = in.text(catalogue_keys::kDesignation);
  const bool of_rollers = (in.model() & with_rollers) != 0;
  if (const auto message = unknown_designation(name, table_of_case(in), in.model()))
    return add_error(message->found, message->required);
  const catalogue::Entry* entry = line_of(in);
  const bool rollers = catalogue::has_rollers(entry->family);
  if (rollers != of_rollers)
    return add_error(
        fmt::format("'{}', a bearing of {}", name, rollers ? "rollers" : "balls"),
        rollers ? "one of balls, such as 6205, is required" : "one of rollers, such as NU 205, is required");
  if (entry->family == catalogue::Family::needle_cage && in.has(catalogue_keys::kRings) &&
      in.choice(catalogue_keys::kRings) != "none")
    in.add_error_at(catalogue_keys::kRings,
                    fmt::format("{} together with {}", in.choice(catalogue_keys::kRings), name),
                    "none is required: needles in a cage run on the pin and in the planet");
  try {
    (void)known_inside(*entry);
  } catch (const std::invalid_argument& error) {
    add_error(name_of(*entry, name), error.what());
  }
}

catalogue::Family family_of(const ResolvedCase& in) {
  return family_of(line_of(in), in.model(), is_nonzero(in, "bearing.contact_angle"));
}

std::optional<double> bore_of(const ResolvedCase& in) {
  if (const catalogue::Entry* entry = line_of(in)) return entry->bore;
  return in.has("bearing.bore") ? std::optional<double>(in.quantity("bearing.bore")) : std::nullopt;
}

// Ratings of a line are those of steel, as are the formulas of the standards.
void check_rated_material(CheckedCase& in) {
  const char* modulus = "material.youngs_modulus";
  constexpr double softest = 190e9, stiffest = 225e9;  // [Pa]  of steels
  if (line_of(in) == nullptr || !is_stated(in, modulus) || is_stated(in, catalogue_keys::kDynamic)) return;
  if (const double stated = in.quantity(modulus); stated < softest || stated > stiffest)
    in.add_error_at(modulus,
                    fmt::format("{} together with {}, whose ratings are those of steel", in.given(modulus),
                                in.text(catalogue_keys::kDesignation)),
                    "a modulus of steel, 190 to 225 GPa, or bearing.dynamic_capacity, static_capacity and "
                    "fatigue_load_limit of a bearing of that material, is required");
}

void check_class(CheckedCase& in) {
  if (!in.has(catalogue_keys::kClass)) return;
  // For an unknown bearing the mistake is reported at its designation.
  if (std::any_of(in.mistakes.begin(), in.mistakes.end(), [](const Mistake& mistake) {
        return mistake.path.ends_with(catalogue_keys::kDesignation);
      }))
    return;
  const auto add_error = [&](std::string found, std::string required) {
    in.add_error_at(catalogue_keys::kClass, std::move(found), std::move(required));
  };
  // A class that its table does not have leaves the default, which is no mistake of the case.
  const auto state = in.assumed().find(catalogue_keys::kState);
  const bool stated = state == in.assumed().end();
  if (stated && in.has(catalogue_keys::kState) && in.choice(catalogue_keys::kState) == "operating")
    add_error("a clearance class together with bearing.clearance_state: operating",
              "bearing.clearance_state: unmounted, or a radial clearance instead of the class, is required. "
              "A class is for an unmounted bearing");
  if (in.has(catalogue_keys::kRings) && in.choice(catalogue_keys::kRings) != "both")
    add_error("a clearance class of a bearing without both rings",
              "bearing.radial_clearance, of pin, rollers and bore together, is required");
  const std::optional<double> bore = bore_of(in);
  if (!bore) {
    add_error("a clearance class without a bore", "bearing.designation or bearing.bore is required as well");
    return;
  }
  try {
    (void)catalogue::clearance_range(family_of(in), class_of(in.choice(catalogue_keys::kClass)), *bore);
  } catch (const std::invalid_argument& error) {
    add_error(in.choice(catalogue_keys::kClass), error.what());
  }
}

void check_seats(CheckedCase& in) {
  for (const Seat& seat : kSeats) {
    if (!has_all(in, {seat.tolerance, seat.diameter})) continue;
    try {
      (void)catalogue::shaft_deviations("h6", in.quantity(seat.diameter));
    } catch (const std::invalid_argument& error) {
      in.add_error_at(seat.tolerance,
                      fmt::format("{} on {}", in.choice(seat.tolerance), in.given(seat.diameter)),
                      error.what());
    }
  }
}

void check_complement(CheckedCase& in) {
  if (!is_full_complement(in) ||
      !has_all(in, {catalogue_keys::kRollers, "bearing.pitch_diameter", "bearing.roller_diameter"}))
    return;
  const double pitch = in.quantity("bearing.pitch_diameter"),
               diameter = in.quantity("bearing.roller_diameter");
  if (!(diameter < pitch)) return;
  const int most = most_rollers(pitch, diameter);
  if (in.integer(catalogue_keys::kRollers) < most)
    in.add_error_at(
        catalogue_keys::kComplement,
        fmt::format("a full complement of {} rollers with room for {} more",
                    in.integer(catalogue_keys::kRollers), most - in.integer(catalogue_keys::kRollers)),
        fmt::format("{} rollers, or their number left out, are required", most));
}

std::vector<Derived> quantities_of_one(const ResolvedCase& in) {
  std::vector<Derived> rows;
  if (const catalogue::Entry* line = line_of(in)) {
    const catalogue::Entry& entry = *line;
    const catalogue::Inside& inside = known_inside(entry);
    const std::string whose = " of " + name_of(entry, in.text(catalogue_keys::kDesignation));
    rows.push_back({"bearing.catalogue.dynamic_rating", entry.dynamic_rating, "N", "C" + whose});
    rows.push_back({"bearing.catalogue.dynamic_rating_inferred", inside.dynamic_rating, "N",
                    "C of ISO 281 by the inferred geometry"});
    rows.push_back({"bearing.catalogue.static_rating", entry.static_rating, "N", "C_0" + whose});
    rows.push_back({"bearing.catalogue.static_rating_inferred", inside.static_rating, "N",
                    "C_0 of ISO 76 by the inferred geometry"});
    if (entry.fatigue_load_limit > 0.0)
      rows.push_back({"bearing.catalogue.fatigue_load_limit", entry.fatigue_load_limit, "N", "C_u" + whose});
  }
  if (in.has(catalogue_keys::kClass)) {
    const catalogue::ClearanceRange range =
        catalogue::clearance_range(family_of(in), class_of(in.choice(catalogue_keys::kClass)), *bore_of(in));
    rows.push_back(
        {"bearing.clearance_class.least", per_micro * range.least, "um", "of bearings of this class"});
    rows.push_back(
        {"bearing.clearance_class.most", per_micro * range.most, "um", "of bearings of this class"});
  }
  for (const Seat& seat : kSeats) {
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

void fill_from_catalogue(CaseData& data, Model model) {
  for (const std::string& prefix : set_prefixes(data.shape)) CatalogueCase(data, prefix, model).fill();
}

void check_catalogue_bearing(CheckedCase& in) {
  check_designation(in);
  check_rated_material(in);
  check_class(in);
  check_seats(in);
  check_complement(in);
}

catalogue::ClearanceRange clearance_range_of(const ResolvedCase& in, const std::string& which) {
  const std::optional<double> bore = bore_of(in);
  if (!bore) throw std::invalid_argument("bearing.designation or bearing.bore is required as well");
  return catalogue::clearance_range(family_of(in), class_of(which), *bore);
}

namespace {

using bearing::friction::BearingSize;
using bearing::friction::TorqueFamily;

TorqueFamily family_of(const ResolvedCase& in, const catalogue::Entry* entry) {
  if (in.model() & with_rollers)
    return is_full_complement(in) ? TorqueFamily::full_complement : TorqueFamily::cylindrical;
  const double angle = entry != nullptr ? entry->contact_angle : in.quantity("bearing.contact_angle");
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
    put_series(in.text(catalogue_keys::kDesignation), size);
  } else if (has_all(in, {"bearing.bore", "bearing.outside_diameter", "bearing.width"})) {
    size.bore = in.quantity("bearing.bore");
    size.outside = in.quantity("bearing.outside_diameter");
    size.width = in.quantity("bearing.width");
  } else {
    return std::nullopt;
  }
  return size;
}

bool is_full_complement(const ResolvedCase& in, const std::string& set) {
  const std::string path = set + catalogue_keys::kComplement;
  return in.has(path) && in.choice(path) == "full";
}

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
  const std::string path = set + catalogue_keys::kDesignation;
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
  const std::string& name = in.text(set + catalogue_keys::kDesignation);
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
            path, in.given(path), name_of(entry, in.text(set + catalogue_keys::kDesignation)),
            known_inside(entry).elements, in.integer(set + catalogue_keys::kRollers),
            newtons(with_rollers_instead(rating, known_inside(entry),
                                         in.integer(set + catalogue_keys::kRollers)))));
      continue;
    }
    warnings.push_back(fmt::format(
        "{}: {} as stated replaces {} of {}; its {} stay as inferred for the latter", path, in.given(path),
        newtons(rating.value), name_of(entry, in.text(set + catalogue_keys::kDesignation)), elements));
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
    if (path != set + catalogue_keys::kDesignation && path != set + catalogue_keys::kCatalogue) continue;
    std::vector<std::string> kept;
    for (const char* one : {catalogue_keys::kDynamic, catalogue_keys::kStatic, catalogue_keys::kLimit,
                            "bearing.cage.inner_diameter", "bearing.cage.outer_diameter",
                            "bearing.cage.width", "bearing.cage.guide_land_diameter"})
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
  const std::string name = in.text(set + catalogue_keys::kDesignation);
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
    if (input.field->path != catalogue_keys::kDesignation || !resolved.has(input.path)) continue;
    const std::string set = set_of(input.path);
    const catalogue::Entry* entry = line_of(resolved, set);
    if (entry == nullptr) continue;
    add_suffixes(resolved, set, warnings);
    add_other_cage(resolved, set, warnings);
    add_table_without_effect(resolved, set, warnings);
    warnings.push_back(inferred_warning(input.path, resolved.text(input.path), *entry));
    if (const std::string rings = set + catalogue_keys::kRings;
        resolved.has(rings) && resolved.choice(rings) != "both" &&
        entry->family != catalogue::Family::needle_cage)
      warnings.push_back(
          fmt::format("{}: {}; ratings of {} are for its own rings. They hold where pin and planet have "
                      "raceways as hard and as smooth, of bearing steel",
                      rings, resolved.choice(rings), name_of(*entry, resolved.text(input.path))));
    add_replaced_ratings(resolved, set, *entry, warnings);
  }
  return warnings;
}

std::optional<std::string> table_in_use(const ResolvedCase& resolved, const std::string& path) {
  const std::string set = set_of(path);
  const catalogue::Entry* entry = line_of(resolved, set);
  if (entry == nullptr || entry != catalogue::find(catalogue_of(resolved.value(path)),
                                                   resolved.text(set + catalogue_keys::kDesignation)))
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
