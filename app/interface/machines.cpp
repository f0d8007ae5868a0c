#include "orbearing/machines.hpp"

#include <map>

#include "app/case/drivetrain_reader.hpp"
#include "app/case/machine_rows.hpp"
#include "app/case/member_values.hpp"
#include "app/errors.hpp"

namespace orbearing {

namespace {

using Values = std::map<app::MemberValues::Place, app::MemberValue>;

constexpr const char* kOther =
    ": found another value in the changed structure; required: the value of the "
    "case, since it follows from other inputs or several inputs state it; "
    "Case::with() sets these";

/// Settings of a case by the members in which two structures differ.
class Differences {
 public:
  explicit Differences(const app::ResolvedCase& of) : of_(of) {}

  void add(const Values& before, const Values& after, const std::string& prefix = "") {
    for (const auto& [place, value] : after) {
      const auto old = before.find(place);
      if (old == before.end() || old->second != value) add(path_of(prefix, place.first), value);
    }
    for (const auto& [place, value] : before)
      if (!after.contains(place) && !value.text.empty())
        mistakes_.push_back(path_of(prefix, place.first) +
                            ": found no such member in the changed structure, but a value in the case; "
                            "required: a choice that the case can take beside its other inputs");
  }
  void require(bool holds, const std::string& mistake) {
    if (!holds) mistakes_.push_back(mistake);
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
    if (!value.settable) {
      mistakes_.push_back((path.empty() ? "a member without a key" : path) + kOther);
      return;
    }
    if (value.text.empty()) {
      mistakes_.push_back(path +
                          ": found absent in the changed structure; required: a value, since a case "
                          "that is read cannot lose one");
      return;
    }
    const auto [there, fresh] = settings_.emplace(path, value.text);
    if (!fresh && there->second != value.text)
      mistakes_.push_back(path + ": found " + there->second + " and " + value.text +
                          " in the changed structure; required: one value");
  }

  const app::ResolvedCase& of_;
  std::map<std::string, std::string> settings_;
  std::vector<std::string> mistakes_;
};

bool are_same(const std::vector<gearset::Shaft>& some, const std::vector<gearset::Shaft>& others) {
  return std::ranges::equal(some, others, [](const gearset::Shaft& one, const gearset::Shaft& other) {
    return one.name == other.name && one.members == other.members && one.motor == other.motor &&
           one.load == other.load && one.ground == other.ground;
  });
}

void compare(const PlanetaryDrivetrain& before, const PlanetaryDrivetrain& after, Differences& found) {
  found.add(app::member_values(before.drive), app::member_values(after.drive));
  const bool same_sets = std::ranges::equal(before.sets, after.sets, {}, &analysis::NamedStatedSet::name,
                                            &analysis::NamedStatedSet::name);
  found.require(same_sets, "sets: found other sets in the changed structure; required: those of the case");
  found.require(are_same(before.shafts, after.shafts),
                "shafts: found other shafts in the changed structure; required: those of the case");
  if (!same_sets) return;
  for (std::size_t i = 0; i < before.sets.size(); ++i) {
    const std::string& name = before.sets[i].name;
    found.require(before.sets[i].set.oil_density == after.sets[i].set.oil_density,
                  std::string("the oil's density") + kOther);
    found.add(app::member_values(before.sets[i].set), app::member_values(after.sets[i].set),
              name.empty() ? "" : app::set_prefix(name));
  }
}
template <class Single>
void compare(const Single& before, const Single& after, Differences& found) {
  found.add(app::member_values(before), app::member_values(after));
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
  Differences found(in);
  std::visit([&](const auto& own) { compare(own, std::get<std::decay_t<decltype(own)>>(machine), found); },
             before);
  return Case(in.with(found.settings()));
}

}  // namespace orbearing
