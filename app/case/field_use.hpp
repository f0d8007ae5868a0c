// Uses of a field of a case: by each command, fidelity and export. Every row of the table of fields states
// them; inputs that are given and not used are refused or warned of from here.
#pragma once

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/case/analysis_id.hpp"
#include "mechanics/described.hpp"

namespace orbearing::app {

class ResolvedCase;

/// Whether `path` is one of these, or begins with one of them.
inline bool is_one_of(std::string_view path, std::initializer_list<std::string_view> paths) {
  return std::find(paths.begin(), paths.end(), path) != paths.end();
}
inline bool begins_with_one_of(std::string_view path, std::initializer_list<std::string_view> parts) {
  return std::any_of(parts.begin(), parts.end(),
                     [&](std::string_view part) { return path.starts_with(part); });
}

/// Condition under which a field has an effect: one of `paths` has one of `values`; without values, it is
/// given and not zero. An absent field meets no value.
struct Condition {
  std::vector<std::string> paths;
  std::vector<std::string> values{};
  bool absent = false;  // instead: none of `paths` is stated; a default is not
  // Instead: what follows from several values at once, in the set of the field: "sets.NAME." or "".
  std::function<bool(const ResolvedCase&, std::string_view set)> holds{};
  std::string text{};  // of that: "it counts only where ..."
};

/// Analyses that use a field where all conditions hold, besides the other uses of its row.
struct Way {
  AnalysisSet by{};
  std::vector<Condition> conditions{};
};

/// Conditions of a row.
Condition where(std::string path, std::vector<std::string> values);
Condition where_given(std::vector<std::string> paths);
Condition where_absent(std::string path);
Condition where_true(bool (*holds)(const ResolvedCase&, std::string_view set), std::string text);
/// Pins with position errors: quasi-static loads then depend on the compliance under the planets.
Condition where_planets_carry_unlike_loads();
/// Gears on springs that follow from their bearings.
Condition where_bearings_make_springs();

/// Uses of a field. There is no default: a row without it does not compile. An analysis that is named nowhere
/// in the row warns of a value that is given and neither the default nor zero.
struct Use {
  Use(AnalysisSet used_by, AnalysisSet not_modelled, AnalysisSet refused = {})
      : by(used_by), not_modelled_by(not_modelled), refused_by(refused) {}
  /// The condition is one of all ways that the row has so far.
  Use when(Condition condition) const;
  /// Makes `analyses` use it where `conditions` hold. Elsewhere, those that do not use it do not model it.
  Use used_too(AnalysisSet analyses, std::vector<Condition> conditions) const;
  Use used_too(AnalysisSet analyses, Condition condition) const;
  /// `analyses` use it where `conditions` hold, and only there.
  Use used_only(AnalysisSet analyses, std::vector<Condition> conditions) const;
  /// Wherever `analyses` use it so far, one of `either` has to hold besides.
  Use limited(AnalysisSet analyses, const std::vector<Condition>& either) const;

  AnalysisSet by;                       // it changes their results
  AnalysisSet not_modelled_by;          // it is not modelled there: their results are equal to the last bit
  AnalysisSet refused_by;               // they ought to and cannot: exit code 2
  std::vector<Condition> conditions{};  // of `by`: all must hold, else the value is warned of
  std::vector<Way> ways{};              // besides
};

/// With the scratched planet bearing: it is moved as by monolithic, and has no life.
Use with_planet_defect(const Use& use, std::string_view path);
/// With the carrier as a body: it uses the inputs of natural frequencies and of quasi-static points, except
/// moments of inertia, supports of members in their planes and stated tilts of the planets; positions of
/// bearings and backlash have an effect too.
Use with_carrier_body(Use use, std::string_view path);
/// Quasi-static points, and natural frequencies, model the carrier as a body where a case states its
/// bearings: uses as by with_carrier_body().
Use with_carrier_beside(const Use& use, std::string_view path);

/// Condition of a row on another input.
Condition condition_of(const described::Where& where);

/// Uses of a field whose row is beside its member: by the analyses that include its physics, except those
/// that cannot use it.
Use use_of(const described::Facts& facts, unsigned models);

}  // namespace orbearing::app
