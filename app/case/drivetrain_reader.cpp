#include "app/case/drivetrain_reader.hpp"

#include <algorithm>

#include "app/case/bearing_type.hpp"

namespace orbearing::app {

namespace {

std::optional<gearset::SetMember> set_member_of(const CaseShape& shape, const std::string& text) {
  const std::size_t dot = text.find('.');
  if (dot == std::string::npos) return std::nullopt;
  const auto set = std::ranges::find(shape.sets, text.substr(0, dot));
  const auto member = value_named<gearset::Member>(text.substr(dot + 1));
  if (set == shape.sets.end() || !member) return std::nullopt;
  return gearset::SetMember{static_cast<std::size_t>(set - shape.sets.begin()), *member};
}

// Puts one word of a shaft's list onto the shaft; false for a word that means nothing.
bool put(const CaseShape& shape, const std::string& text, gearset::Shaft& shaft) {
  if (text == "motor") return shaft.motor = true;
  if (text == "load") return shaft.load = true;
  if (text == "ground") return shaft.ground = true;
  const std::optional<gearset::SetMember> member = set_member_of(shape, text);
  if (member) shaft.members.push_back(*member);
  return member.has_value();
}

}  // namespace

ReadShaft shaft_of(const ResolvedCase& in, const std::string& name) {
  ReadShaft read{.shaft = {.name = name}};
  const std::vector<std::string>& words = in.texts(shaft_path(name));
  for (std::size_t i = 0; i < words.size(); ++i)
    if (!put(in.shape(), words[i], read.shaft)) read.unknown.push_back(i);
  return read;
}

std::string unequal_loads_by(const ResolvedCase& in) {
  return in.model() == planetary_drivetrain && !in.shape().several
             ? unequal_loads_by(stated_drivetrain(in).single())
             : "";
}

namespace {

analysis::StatedSet read_set(const ResolvedCase& in, Missing missing) {
  // Without a bearing nothing of one is expected.
  return part_of<analysis::StatedSet>(in, has_planet_bearing(in) ? missing : Missing::left_out);
}

struct DrivetrainAsFarAsStated {
  analysis::StatedDrivetrain drivetrain;
};

analysis::StatedDrivetrain read_drivetrain(const ResolvedCase& in, Missing missing) {
  analysis::StatedDrivetrain drivetrain{.drive = part_of<gearset::Drive>(in, missing)};
  if (!in.shape().several) {
    drivetrain.sets.push_back({"", read_set(in, missing)});
    return drivetrain;
  }
  for (const std::string& name : in.shape().sets)
    drivetrain.sets.push_back({name, read_set(in.of_set(name), missing)});
  for (const std::string& name : in.shape().shafts) drivetrain.shafts.push_back(shaft_of(in, name).shaft);
  return drivetrain;
}

}  // namespace

const analysis::StatedDrivetrain& stated_drivetrain(const ResolvedCase& in, Missing missing) {
  if (missing == Missing::refused)
    return in.once<analysis::StatedDrivetrain>([&] { return read_drivetrain(in, missing); });
  return in
      .once<DrivetrainAsFarAsStated>([&] { return DrivetrainAsFarAsStated{read_drivetrain(in, missing)}; })
      .drivetrain;
}

}  // namespace orbearing::app
