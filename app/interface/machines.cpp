#include "orbearing/machines.hpp"

#include <map>

#include "app/case/drivetrain_reader.hpp"
#include "app/case/machine_rows.hpp"
#include "app/case/member_values.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/errors.hpp"

namespace orbearing {

namespace {

using Values = std::map<app::MemberValues::Place, app::MemberValue>;

/// Values of one part of a machine, whose inputs are in the set of that prefix.
struct PartValues {
  std::string prefix;
  Values values;
};

std::vector<PartValues> values_of(const PlanetaryDrivetrain& machine) {
  std::vector<PartValues> parts{{"", app::member_values(machine.drive)}};
  for (const auto& [name, set] : machine.sets)
    parts.push_back({name.empty() ? "" : app::set_prefix(name), app::member_values(set)});
  return parts;
}
template <class Single>
std::vector<PartValues> values_of(const Single& machine) {
  return {{"", app::member_values(machine)}};
}
std::vector<PartValues> values_of(const Machine& machine) {
  return std::visit([](const auto& one) { return values_of(one); }, machine);
}

/// Settings of a case by the members in which two structures differ.
class Differences {
 public:
  explicit Differences(const app::ResolvedCase& of) : of_(of) {}

  void add(const PartValues& before, const PartValues& after) {
    for (const auto& [place, value] : after.values) {
      const auto old = before.values.find(place);
      if (old == before.values.end() || old->second != value) add(path_of(after.prefix, place.first), value);
    }
  }

  /// Throws BadInput where there are changes that no setting makes.
  std::vector<app::Setting> settings() const {
    if (!mistakes_.empty()) throw BadInput(mistakes_);
    std::vector<app::Setting> found;
    for (const auto& [path, text] : settings_) found.push_back({path, text});
    return found;
  }

 private:
  // Sets share some inputs, which are at the top of the case.
  std::string path_of(const std::string& prefix, const std::string& path) const {
    return belongs(of_.shape(), prefix + path) ? prefix + path : path;
  }

  void add(const std::string& path, const app::MemberValue& value) {
    if (!value.settable)
      return mistakes_.push_back(
          (path.empty() ? "a member without a key" : path) +
          ": found another value in the changed structure; required: the value of the case, since it follows "
          "from other inputs or several inputs state it; Case::with() sets these");
    if (value.text.empty())
      return mistakes_.push_back(path +
                                 ": found absent in the changed structure; required: a value, since a case "
                                 "that is read cannot lose one");
    const auto [there, fresh] = settings_.emplace(path, value.text);
    if (!fresh && there->second != value.text)
      mistakes_.push_back(path + ": found " + there->second + " and " + value.text +
                          " in the changed structure; required: one value");
  }

  const app::ResolvedCase& of_;
  std::map<std::string, std::string> settings_;
  std::vector<std::string> mistakes_;
};

// Throws BadInput where the case that was made has another value than `after` in a member that changed.
void require_changes(const PartValues& before, const PartValues& after, const PartValues& made) {
  std::vector<std::string> mistakes;
  const auto require = [&](bool holds, const std::string& path) {
    if (!holds)
      mistakes.push_back(
          after.prefix + path +
          ": found a change that the other inputs of the case do not leave; required: one that "
          "Case::with() can make");
  };
  for (const auto& [place, value] : after.values) {
    const auto old = before.values.find(place), now = made.values.find(place);
    const bool same = old != before.values.end() && old->second == value;
    require(same || (now != made.values.end() && now->second == value), place.first);
  }
  for (const auto& [place, value] : before.values)
    require(after.values.contains(place) || !made.values.contains(place), place.first);
  if (!mistakes.empty()) throw BadInput(mistakes);
}

bool are_same(const std::vector<gearset::Shaft>& some, const std::vector<gearset::Shaft>& others) {
  return std::ranges::equal(some, others, [](const gearset::Shaft& one, const gearset::Shaft& other) {
    return one.name == other.name && one.members == other.members && one.motor == other.motor &&
           one.load == other.load && one.ground == other.ground;
  });
}

// What of a drivetrain no member with a key states.
void require_same_rest(const PlanetaryDrivetrain& before, const PlanetaryDrivetrain& after) {
  if (!std::ranges::equal(before.sets, after.sets, {}, &analysis::NamedStatedSet::name,
                          &analysis::NamedStatedSet::name))
    throw BadInput("sets: found other sets in the changed structure; required: those of the case");
  if (!are_same(before.shafts, after.shafts))
    throw BadInput("shafts: found other shafts in the changed structure; required: those of the case");
}

}  // namespace

Machine machine_of(const Case& stated) {
  const app::ResolvedCase& in = stated.content();
  if (in.model() == app::planetary_drivetrain) return app::stated_drivetrain(in);
  Machine machine;
  app::Machines::each([&]<class Row>(Row, std::size_t) {
    if (Row::model == in.model()) machine = app::machine_of<typename Row::Type>(in);
  });
  return machine;
}

PlanetaryDrivetrain drivetrain_of(const Case& stated) {
  const app::ResolvedCase& in = stated.content();
  if (in.model() != app::planetary_drivetrain)
    throw BadInput(in.origin("model") + ": model: found " + in.choice("model") +
                   "; required: planetary-drivetrain");
  return app::stated_drivetrain(in);
}

Case changed(const Case& stated, const Machine& machine) {
  const app::ResolvedCase& in = stated.content();
  const Machine before = machine_of(stated);
  if (before.index() != machine.index())
    throw BadInput(in.file() + ": found the structure of another machine; required: that of the model " +
                   in.choice("model"));
  if (const auto* drivetrain = std::get_if<PlanetaryDrivetrain>(&before))
    require_same_rest(*drivetrain, std::get<PlanetaryDrivetrain>(machine));
  const std::vector<PartValues> own = values_of(before), wanted = values_of(machine);
  Differences found(in);
  for (std::size_t i = 0; i < own.size(); ++i) found.add(own[i], wanted[i]);
  const std::vector<app::Setting> settings = found.settings();
  Case made(in.with(settings));
  if (const std::vector<std::string> replaced =
          app::replaced_inputs(made.content(), described::each(settings, &app::Setting::path));
      !replaced.empty())
    throw BadInput(replaced);
  const std::vector<PartValues> now = values_of(machine_of(made));
  for (std::size_t i = 0; i < own.size(); ++i) require_changes(own[i], wanted[i], now[i]);
  return made;
}

}  // namespace orbearing
