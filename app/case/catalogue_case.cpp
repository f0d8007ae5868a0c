#include "app/case/catalogue_case.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "app/case/catalogue_lines.hpp"
#include "app/case/field_table.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/oil_case.hpp"
#include "app/units.hpp"
#include "bearing/default_design.hpp"

namespace orbearing::app {

using namespace catalogue_lines;

namespace {

std::string millimetres(double length) {
  return fmt::format("{:.9g} mm", per_milli * length);
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
    const FieldValue* name = find(keys().designation);
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
    put(rollers ? keys().rollers : keys().balls, fmt::format("{}", inside.elements), inferred);
    put(rollers ? keys().roller_diameter : keys().ball_diameter, millimetres(inside.diameter), inferred);
    if (rollers)
      put(keys().roller_length, millimetres(inside.length), inferred);
    else
      put(keys().contact_angle, fmt::format("{:g} deg", kDegree * entry_->contact_angle), published);
    if (entry_->family == catalogue::Family::angular_contact)
      put_default(keys().radial_clearance, "0 um",
                  "default: without load the balls touch at the nominal contact angle");
    put(keys().pitch_diameter, millimetres(inside.pitch_diameter), inferred);
    if (entry_->family != catalogue::Family::needle_cage) {
      put(keys().bore, millimetres(entry_->bore), published);
      put(keys().outside_diameter, millimetres(entry_->outside), published);
    } else {
      put_default(keys().rings, "none", published + ", which has no rings");
    }
    put(keys().width, millimetres(entry_->width), published);
    inside_ = &inside;
    if (rollers) put_default(keys().bearing_type, "cylindrical-roller", published);
    fill_default_cage(inside);
  }

  // Stated ratings remain. Without a cage there are more rollers than the line's ratings apply to.
  void fill_ratings() {
    if (inside_ == nullptr) return;
    const std::string published = "default: " + name_of(*entry_, find(keys().designation)->given);
    const FieldValue* rollers = find(keys().rollers);
    const bool full = is_full(find(keys().complement)) && rollers != nullptr;
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
    const FieldValue *pitch = find(keys().pitch_diameter), *width = find(keys().width),
                     *roller = find(keys().roller_diameter), *ball = find(keys().ball_diameter),
                     *length = find(keys().roller_length);
    const FieldValue* diameter = roller != nullptr ? roller : ball;
    if (inside_ != nullptr || is_full(find(keys().complement)) || pitch == nullptr || width == nullptr ||
        diameter == nullptr || (roller != nullptr && length == nullptr))
      return;
    put_cage(bearing::default_cage_size(pitch->number, diameter->number,
                                        roller != nullptr ? length->number : diameter->number,
                                        width->number));
  }

  void put_cage(const bearing::CageSize& cage) {
    if ((model_ & model_sets::in_motion) == 0) return;  // others need none
    const std::string reason =
        "default: a typical cage of a bearing of this section, guided at the outer ring";
    put_default(keys().cage_inner_diameter, millimetres(cage.inner_diameter), reason);
    put_default(keys().cage_outer_diameter, millimetres(cage.outer_diameter), reason);
    put_default(keys().cage_width, millimetres(cage.width), reason);
  }

  // Whether the bearing has both rings, and so a clearance before mounting.
  bool has_clearance_before_mounting() const {
    const FieldValue* rings = find(keys().rings);
    return entry_ != nullptr && entry_->family != catalogue::Family::needle_cage &&
           (rings == nullptr || rings->given == "both");
  }

  // A clearance that takes the place of a default class is before mounting as well. Planets with two gears,
  // or in pairs, take that of the running bearing alone.
  void fill_state_of_stated_clearance() {
    if (entry_ == nullptr) return;
    const bool before_mounting = has_clearance_before_mounting() && find(keys().stepped_teeth) == nullptr &&
                                 find(keys().second_planet_teeth) == nullptr;
    const Field& running = *find_field(keys().clearance_state);
    put_default(keys().clearance_state, before_mounting ? "unmounted" : running.default_text,
                "default: " + (before_mounting ? "clearance before mounting, as that of a designation's class"
                                               : running.default_reason));
  }

  // Clearance class of the designation's suffix, else normal: the class of bearings ordered without another
  // one.
  void fill_default_class() {
    const std::string path = prefix_ + keys().clearance_class;
    auto known = data_.values.find(path);
    const auto clearance = data_.values.find(prefix_ + keys().radial_clearance);
    const bool stated = clearance != data_.values.end() && !clearance->second.from_default &&
                        clearance->second.replaced.empty();
    if (known != data_.values.end() && known->second.from_default && stated) {
      data_.values.erase(known);
      data_.assumed.erase(path);
      known = data_.values.end();
    }
    if (known == data_.values.end() && stated) return fill_state_of_stated_clearance();
    const FieldValue* state = find(keys().clearance_state);
    if (known != data_.values.end() || clearance != data_.values.end() || !has_clearance_before_mounting() ||
        (state != nullptr && state->given == "operating"))
      return;
    const ReadDesignation read =
        read_designation(find(catalogue_keys::kCatalogue), find(keys().designation)->given);
    for (const catalogue::Suffix* suffix : read.name.suffixes)
      if (suffix->clearance)
        return put_default(keys().clearance_class, std::string(suffix->letters),
                           "default: the suffix of bearing.designation");
    put_default(keys().clearance_class, "CN",
                "default: normal clearance, as a catalogue bearing has it whose designation names no other");
  }

  void fill_class() {
    const FieldValue *name = find(keys().clearance_class), *bore = find(keys().bore);
    if (name == nullptr || (entry_ == nullptr && bore == nullptr)) return;
    const double diameter = entry_ != nullptr ? entry_->bore : bore->number;
    try {
      const FieldValue* angle = find(keys().contact_angle);
      const catalogue::ClearanceRange range =
          catalogue::clearance_range(family_of(entry_, model_, angle != nullptr && angle->number != 0.0),
                                     class_of(name->given), diameter);
      put(keys().radial_clearance, fmt::format("{:g} um", per_micro * range.middle()),
          fmt::format("default: middle of class {}, {:g} to {:g} um (ISO 5753)", name->given,
                      per_micro * range.least, per_micro * range.most));
      put_default(keys().clearance_state, "unmounted",
                  "default: a clearance class is for an unmounted bearing");
    } catch (const std::invalid_argument&) {  // reported by check_catalogue_bearing()
    }
  }

  // Each seat by its class.
  void fill_seats() {
    for (const Seat& seat : seats()) {
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
    if (entry_ == nullptr || (model_ & model_sets::in_motion) == 0 ||  // others may have no cage
        is_full(find(keys().complement)))
      return;
    if (const auto density = data_.values.find(prefix_ + keys().cage_density);
        density != data_.values.end() && !density->second.from_default)
      return;
    if (const auto named = cage_of(find(catalogue_keys::kCatalogue), find(keys().designation)->given))
      put_default(catalogue_keys::kMaterial, std::string(named->material), "default: " + named->reason);
  }

  void fill_material() {
    fill_named_material();
    const FieldValue* name = find(catalogue_keys::kMaterial);
    if (name == nullptr) return;
    const bearing::CageMaterial& material = bearing::cage_material(name->given);
    put(keys().cage_density, fmt::format("{:g} kg/m3", material.density),
        fmt::format("default: a cage of {}", material.name));
  }

  // Number of rollers of a full complement where it is left out: as many as fit.
  void fill_complement() {
    const FieldValue *complement = find(keys().complement), *pitch = find(keys().pitch_diameter),
                     *diameter = find(keys().roller_diameter);
    if (!is_full(complement) || pitch == nullptr || diameter == nullptr) return;
    if (!(diameter->number < pitch->number)) return;
    const std::string most = fmt::format("{}", most_rollers(pitch->number, diameter->number));
    const std::string reason = "default: a full complement, the largest number that fits";
    if (entry_ != nullptr)
      put(keys().rollers, most, reason);  // the designation's own number is that of a cage
    else
      put_default(keys().rollers, most, reason);
  }

  // The pin and the bore of the planet are the races.
  void fill_rings() {
    const FieldValue *rings = find(keys().rings), *pitch = find(keys().pitch_diameter),
                     *diameter = find(keys().roller_diameter), *clearance = find(keys().radial_clearance);
    if (rings == nullptr || rings->given == "both" || pitch == nullptr || diameter == nullptr ||
        clearance == nullptr)
      return;
    const double reach = diameter->number + 0.5 * clearance->number;
    put(keys().bore, millimetres(pitch->number - reach), "default: the pin, on which the rollers run");
    if (rings->given == "none")
      put(keys().outside_diameter, millimetres(pitch->number + reach),
          "default: the bore of the planet, in which the rollers run");
  }

  CaseData& data_;
  std::string prefix_;
  Model model_;
  const catalogue::Entry* entry_ = nullptr;
  const catalogue::Inside* inside_ = nullptr;  // of that line, where it has one that this case takes
};

}  // namespace

void fill_from_catalogue(CaseData& data, Model model) {
  for (const std::string& prefix : set_prefixes(data.shape)) CatalogueCase(data, prefix, model).fill();
}

bool is_full_complement(const ResolvedCase& in, const std::string& set) {
  const std::string path = set + keys().complement;
  return in.has(path) && in.choice(path) == "full";
}

}  // namespace orbearing::app
