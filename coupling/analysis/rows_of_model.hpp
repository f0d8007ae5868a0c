// Rows of a structure that cases of several models share (mechanics/described.hpp): those of one model, or of
// a part that an analysis takes.
#pragma once

#include <optional>
#include <type_traits>
#include <vector>

#include "bearing/profile/profile.hpp"
#include "mechanics/described.hpp"
#include "mechanics/extents.hpp"

namespace orbearing::analysis {

using mechanics::Extents;

/// Types of members that a case can state.
template <class T>
inline constexpr bool can_be_stated =
    std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_same_v<T, std::optional<double>> ||
    std::is_same_v<T, std::vector<double>> || std::is_same_v<T, bearing::profile::Profile>;

/// A visitor that passes on the rows of one model.
template <class Visitor>
class RowsOfModel {
 public:
  RowsOfModel(Visitor& visit, described::Model model) : visit_(visit), model_(model) {}

  template <class Member>
  void operator()(Member& member, const described::Facts& facts) {
    if constexpr (can_be_stated<Member>)
      if ((facts.details.models & model_) != 0) visit_(member, facts);
  }

 private:
  Visitor& visit_;
  described::Model model_;
};

/// Describes the rows of `part` that cases of that model have.
template <class Visitor, class Part>
void describe_for_model(Visitor& visit, Part& part, described::Model model) {
  RowsOfModel<Visitor> rows(visit, model);
  describe(rows, part);
}

/// A visitor that passes on the rows of all members but some, or their parts.
template <class Visitor>
class RowsWithout {
 public:
  template <class... Members>
  explicit RowsWithout(Visitor& visit, const Members&... left_out) : visit_(visit), left_out_(left_out...) {}

  template <class Member>
  void operator()(Member& member, const described::Facts& facts) {
    if (!left_out_.hold(&member)) visit_(member, facts);
  }

 private:
  Visitor& visit_;
  Extents left_out_;
};

/// A visitor that passes on the rows of some members, or their parts, alone.
template <class Visitor>
class RowsOnly {
 public:
  template <class... Members>
  explicit RowsOnly(Visitor& visit, const Members&... taken) : visit_(visit), taken_(taken...) {}

  template <class Member>
  void operator()(Member& member, const described::Facts& facts) {
    if (taken_.hold(&member)) visit_(member, facts);
  }

 private:
  Visitor& visit_;
  Extents taken_;
};

/// Describes `part` but for some of its members.
template <class Visitor, class Part, class... Members>
void describe_without(Visitor& visit, Part& part, const Members&... left_out) {
  RowsWithout<Visitor> rows(visit, left_out...);
  describe(rows, part);
}

/// Describes some members of `part`.
template <class Visitor, class Part, class... Members>
void describe_only(Visitor& visit, Part& part, const Members&... taken) {
  RowsOnly<Visitor> rows(visit, taken...);
  describe(rows, part);
}

}  // namespace orbearing::analysis
