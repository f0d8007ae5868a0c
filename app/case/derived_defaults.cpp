#include "app/case/derived_defaults.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "app/case/catalogue_case.hpp"
#include "app/case/field_table.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/machine_rows.hpp"
#include "app/case/oil_case.hpp"
#include "app/case/part_of_data.hpp"
#include "app/case/requirements_case.hpp"
#include "app/case/settings.hpp"
#include "app/case/spectrum_case.hpp"
#include "bearing/life/rating_lives.hpp"
#include "coupling/analysis/derived_defaults.hpp"
#include "mechanics/number_text.hpp"

namespace orbearing::app {

namespace {

struct WrittenDefault {
  std::string text;  // as it would be written in a case
  std::string reason;
};

// Values of the set to which a derived default belongs.
class ValuesOfSet {
 public:
  ValuesOfSet(const CaseData& data, std::string prefix) : data_(data), prefix_(std::move(prefix)) {}

  bool has(std::string_view path) const { return find(path) != nullptr; }
  bool given(std::string_view path) const { return find(path) && !find(path)->from_default; }
  const std::string& choice(std::string_view path) const { return find(path)->value.given; }
  template <class Selection>
  typename Selection::Part part() const {
    return PartOfData<Selection>::read(data_, prefix_);
  }

 private:
  const StoredValue* find(std::string_view path) const {
    return value_in_set(data_, prefix_, std::string(path));
  }

  const CaseData& data_;
  std::string prefix_;
};

using Rule = std::optional<WrittenDefault> (*)(const ValuesOfSet&);

// Of choices, and by whether a value is stated.

// No maker's roller has a sharp end.
std::optional<WrittenDefault> roller_profile(const ValuesOfSet& value) {
  if (!value.has(keys().rollers) || !value.has(keys().bearing_type) ||
      value.choice(keys().bearing_type) == "spherical-roller")
    return std::nullopt;
  return WrittenDefault{"iso16281",
                        "reference profile of ISO/TS 16281, since catalogue rollers have relieved ends; "
                        "straight ones state straight"};
}

std::optional<WrittenDefault> life_method(const ValuesOfSet& value) {
  const bool required =
      std::ranges::any_of(requirement_paths(), [&](const std::string& path) { return value.has(path); });
  if (!required && !value.has(keys().dynamic_capacity)) return std::nullopt;
  return WrittenDefault{"iso-16281", required ? "a requirement is stated" : "the rating C is known"};
}

bool oil_is_stated(const ValuesOfSet& value) {
  return value.has(keys().contamination_factor) || value.has(keys().cleanliness) ||
         value.has(keys().viscosity_ratio) || value.has(keys().kinematic_viscosity);
}

std::optional<WrittenDefault> required_life(const ValuesOfSet& value) {
  if (!value.has("requirements.life") || !value.has(keys().life_method)) return std::nullopt;
  const bearing::rating::Life life = bearing::rating::governing_life(
      *value_named<bearing::rating::LifeMethod>(value.choice(keys().life_method)), oil_is_stated(value));
  return WrittenDefault{bearing::rating::hours_key(life), "the governing life, by life.method"};
}

// Planet bearings have rollers.
std::optional<WrittenDefault> minimum_load(const ValuesOfSet& value) {
  if (!value.has(kSpectrumPath)) return std::nullopt;
  return WrittenDefault{"0.02", "makers' rule of thumb for roller bearings [SKFMinimumLoad]"};
}

// Who states the error of a step gets that one.
std::optional<WrittenDefault> load_error_share(const ValuesOfSet& value) {
  if (!value.given(keys().length_error)) return std::nullopt;
  return WrittenDefault{"0", "simulation.length_error is given"};
}

// Who states the sliding speed gets that one.
std::optional<WrittenDefault> sliding_share(const ValuesOfSet& value) {
  if (!value.given(keys().sliding_scale)) return std::nullopt;
  return WrittenDefault{"0", "traction.sliding_scale is given"};
}

// Whether a structure of parameters needs the value, and whether bearings have it that are not moved in time.
enum class Needed { always, at_times, at_rest_too };

struct DefaultRule {
  std::string path;
  Rule apply;
  Needed needed;
  std::string_view text;
  const Field* field = find_field(path);
};

// A value of the library in the customary unit of its field.
template <class Default>
std::optional<WrittenDefault> written(const ValuesOfSet& values) {
  const std::optional<analysis::DerivedDefault> derived = Default::derive(values.part<Default>());
  if (!derived) return std::nullopt;
  static const described::Dimension unit = find_field(Default::key())->dimension;
  return WrittenDefault{mechanics::significant(derived->value * (1.0 / unit.factor), derived->digits) + " " +
                            std::string(unit.customary),
                        derived->reason};
}

template <class... Defaults>
std::vector<DefaultRule> rules_of(RowsOf<Defaults...>) {
  std::vector<DefaultRule> rules;
  RowsOf<Defaults...>::each([&]<class Default>(Default, std::size_t) {
    Needed needed = Needed::at_times;
    if constexpr (requires { Default::always; }) needed = Needed::always;
    rules.push_back({Default::key(), written<Default>, needed, Default::rule});
  });
  return rules;
}

// In an order in which each finds what it follows from.
std::vector<DefaultRule> all_rules() {
  using namespace analysis::defaults;
  std::vector<DefaultRule> rules = rules_of(
      RowsOf<PocketClearance, PocketStiffness, TouchDownStiffness, GuideLand, PocketDamping, SunSupport,
             RingSupport, CarrierSupport, Backlash, SunTilt, SunAxial, FlexpinDiameter, PinStiffness>());
  for (const DefaultRule& rule : std::initializer_list<DefaultRule>{
           {keys().profile_kind, roller_profile, Needed::at_rest_too,
            "iso16281: catalogue rollers have relieved ends; straight ones state straight"},
           {keys().life_method, life_method, Needed::at_rest_too,
            "iso-16281, where C is known from the catalogue or stated, or a requirement is"},
           {"requirements.life_key", required_life, Needed::at_rest_too,
            "the governing life, where requirements.life is given"},
           {keys().load_error_share, load_error_share, Needed::at_times,
            "0, where simulation.length_error is given"},
           {keys().sliding_share, sliding_share, Needed::at_rest_too,
            "0, where traction.sliding_scale is given"},
           {kMinimumLoadPath, minimum_load, Needed::at_rest_too,
            "0.02, where spectrum is given: makers' rule of thumb for roller bearings"}})
    rules.push_back(rule);
  return rules;
}
const std::vector<DefaultRule>& default_rules() {
  static const std::vector<DefaultRule> rules = all_rules();
  return rules;
}

void fill_one(CaseData& data, const std::string& prefix, const DefaultRule& rule) {
  const std::string full = in_each_set(*rule.field) ? prefix + rule.path : rule.path;
  const auto stored = data.values.find(full);
  if (stored != data.values.end() && !stored->second.from_default) return;
  const std::optional<WrittenDefault> derived = rule.apply(ValuesOfSet(data, prefix));
  if (!derived && !rule.field->default_text.empty()) return;  // nothing is there for it to follow from
  if (stored != data.values.end()) {
    data.assumed.erase(full);
    data.values.erase(stored);
  }
  if (!derived) return;
  FieldReading reading = read_field_text(*rule.field, derived->text);
  if (!reading.good) return;  // outside the range of the field: the case must state a value
  data.values[full] = {std::move(reading.value), {}, true};
  data.assumed[full] = "default: " + derived->reason;
}

}  // namespace

std::string_view default_rule(std::string_view path) {
  for (const DefaultRule& rule : default_rules())
    if (rule.path == path) return rule.text;
  return {};
}

bool follows_always(std::string_view path) {
  return std::ranges::any_of(default_rules(), [&](const DefaultRule& rule) {
    return rule.needed == Needed::always && rule.path == path;
  });
}

void fill_derived_defaults(CaseData& data) {
  const auto found = data.values.find("model");
  if (found == data.values.end()) return;
  const Model model =
      specific_model(model_of(found->second.value.given), data.values.contains("simulation.duration"),
                     data.values.contains(keys().rollers));
  fill_from_catalogue(data, model);
  fill_from_grade(data, model);
  if ((model & planetary_drivetrain) != 0) fill_from_torque(data);
  const bool in_time = (model & model_sets::in_time) != 0;
  for (const std::string& prefix : set_prefixes(data.shape))
    for (const DefaultRule& rule : default_rules()) {
      const bool at_rest = rule.needed == Needed::at_rest_too;
      if (!in_time && !at_rest) continue;
      // The pin belongs to a set, though its field does not: each of several finds its own, in `of_set`.
      if (data.shape.several && !in_each_set(*rule.field) && !at_rest) continue;
      if ((rule.field->models & model) == 0) continue;
      fill_one(data, prefix, rule);
    }
}

}  // namespace orbearing::app
