// Some rows of a structure (mechanics/described.hpp): those that a machine, or an analysis of it, has.
#pragma once

#include "mechanics/described.hpp"
#include "mechanics/extents.hpp"

namespace orbearing::mechanics {

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
  template <class Self, class Variant>
  void choose(Self& self, Variant& member, const described::Facts& facts) {
    if (!left_out_.hold(&member)) visit_.choose(self, member, facts);
  }
  template <class Self, class Variant>
  void choose_by_inputs(Self& self, Variant& member) {
    if (!left_out_.hold(&member)) visit_.choose_by_inputs(self, member);
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
  template <class Self, class Variant>
  void choose(Self& self, Variant& member, const described::Facts& facts) {
    if (taken_.hold(&member)) visit_.choose(self, member, facts);
  }
  template <class Self, class Variant>
  void choose_by_inputs(Self& self, Variant& member) {
    if (taken_.hold(&member)) visit_.choose_by_inputs(self, member);
  }

 private:
  Visitor& visit_;
  Extents taken_;
};

/// A visitor that passes on all rows, whose members a case may leave out.
template <class Visitor>
class RowsNotRequired {
 public:
  explicit RowsNotRequired(Visitor& visit) : visit_(visit) {}

  template <class Member>
  void operator()(Member& member, described::Facts facts) {
    facts.details.may_be_absent = true;
    visit_(member, facts);
  }
  template <class Self, class Variant>
  void choose(Self& self, Variant& member, described::Facts facts) {
    facts.details.may_be_absent = true;
    visit_.choose(self, member, facts);
  }
  template <class Self, class Variant>
  void choose_by_inputs(Self& self, Variant& member) {
    visit_.choose_by_inputs(self, member);
  }

 private:
  Visitor& visit_;
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

/// Describes `part`, which a case may leave out.
template <class Visitor, class Part>
void describe_not_required(Visitor& visit, Part& part) {
  RowsNotRequired<Visitor> rows(visit);
  describe(rows, part);
}

}  // namespace orbearing::mechanics
