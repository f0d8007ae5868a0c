// Rows of a structure that cases of several models share (mechanics/described.hpp): those of one model.
#pragma once

#include <optional>
#include <type_traits>
#include <vector>

#include "mechanics/described.hpp"

namespace orbearing::analysis {

/// Types of members that a case can state.
template <class T>
inline constexpr bool can_be_stated =
    std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_same_v<T, std::optional<double>> ||
    std::is_same_v<T, std::vector<double>>;

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

}  // namespace orbearing::analysis
