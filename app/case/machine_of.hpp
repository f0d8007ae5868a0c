// The structure of a machine, or of a part of its inputs, from a case.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/case/catalogue_case.hpp"
#include "app/case/catalogue_quantities.hpp"
#include "app/case/described_case.hpp"
#include "app/case/field_table.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/machine_fields.hpp"
#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Values that always follow from others, where these are missing or wrong.
enum class Missing { refused, left_out };

/// A visitor of the rows of a machine: gives each member the value that the case has.
class MachineFromCase {
 public:
  explicit MachineFromCase(const ResolvedCase& in, Missing missing = Missing::refused)
      : in_(in), missing_(missing) {}

  template <class Member>
  void operator()(Member& member, const described::Facts& facts) {
    const bool there = in_.has(facts.path);
    if (looking_)
      found_ = found_ || there;
    else if (!there && !is_expected(facts.path))
      return;
    else if (is_of_missing_cage(facts.path))
      return;
    else if constexpr (is_list_of_parts<Member>)
      read_rows(member, facts.path);
    else
      DescribedCase(in_).read_value(member, facts);
  }

  // Members that follow from several inputs.
  void operator()(bearing::Lubricant& member, const described::Facts&) {
    if (has_all(in_, {keys().viscosity, keys().pressure_viscosity}))
      member = from_case<bearing::Lubricant>(in_);
  }
  void operator()(std::optional<bearing::friction::BearingSize>& member, const described::Facts&) {
    member = size_of(in_);
  }

  template <class Self, class Variant>
  void choose(Self& self, Variant& member, const described::Facts& facts) {
    if (looking_) {
      found_ = found_ || in_.has(facts.path);
      return;
    }
    if (in_.has(facts.path))
      each_alternative<Variant>([&](const auto& one, std::size_t) {
        if (one.name == in_.choice(facts.path)) member = one;
      });
    std::visit([&](auto& chosen) { describe(self, chosen); }, member);
  }

  template <class Self, class Variant>
  void choose_by_inputs(Self& self, Variant& member) {
    if (looking_) return;
    each_alternative<Variant>([&](auto one, std::size_t) {
      looking_ = true;
      found_ = false;
      describe(self, one);
      looking_ = false;
      if (found_) member = one;
    });
    std::visit([&](auto& chosen) { describe(self, chosen); }, member);
  }

 private:
  // Values that always follow from others must be there. A case may have no cage.
  bool is_expected(const std::string& path) const {
    if (path.starts_with("bearing.cage.") &&
        (!has_all(in_, {keys().cage_width, keys().cage_density}) || goes_without_cage(in_)))
      return false;
    return missing_ == Missing::refused && follows_always(path) &&
           (find_field(path)->models & in_.model()) != 0;
  }
  bool is_of_missing_cage(const std::string& path) const {
    return path.starts_with("bearing.cage.") && is_full_complement(in_);
  }

  // Numbers of one row after another.
  class Row {
   public:
    explicit Row(const double* number) : next_(number) {}
    void operator()(double& member, const described::Facts&) { member = *next_++; }

   private:
    const double* next_;
  };

  template <class Part>
  void read_rows(std::vector<Part>& member, const std::string& path) {
    const std::vector<double>& numbers = in_.list(path);
    ColumnsOfRows visit;
    Part part{};
    describe(visit, part);
    member.clear();
    for (std::size_t i = 0; i < numbers.size(); i += visit.columns.size()) {
      Row row(&numbers[i]);
      describe(row, member.emplace_back());
    }
  }

  const ResolvedCase& in_;
  Missing missing_;
  bool looking_ = false, found_ = false;  // whether the case states an input of an alternative
};

/// The rows of a part whose members are always the same ones, whatever a case chooses: found once, since
/// parts are read for each point of a sweep.
template <class Part>
class RowsOfPart {
 public:
  RowsOfPart() {
    Part part{};
    begin_ = bytes_of(part);
    describe(*this, part);
  }

  template <class Member>
  void operator()(Member& member, const described::Facts& facts) {
    rows_.push_back({facts, bytes_of(member) - begin_, read<Member>});
  }
  void read_all(MachineFromCase& visit, Part& part) const {
    for (const Row& row : rows_) row.read(visit, bytes_of(part) + row.offset, row.facts);
  }

 private:
  struct Row {
    described::Facts facts;
    std::ptrdiff_t offset;
    void (*read)(MachineFromCase&, std::byte*, const described::Facts&);
  };

  template <class T>
  static std::byte* bytes_of(T& object) {
    return reinterpret_cast<std::byte*>(&object);
  }
  template <class Member>
  static void read(MachineFromCase& visit, std::byte* at, const described::Facts& facts) {
    visit(*reinterpret_cast<Member*>(at), facts);
  }

  const std::byte* begin_ = nullptr;
  std::vector<Row> rows_;
};

/// A machine, or what an analysis takes of it, with the values of the case.
template <class Machine>
Machine machine_of(const ResolvedCase& in, Missing missing = Missing::refused) {
  Machine machine{};
  MachineFromCase visit(in, missing);
  describe(visit, machine);
  return machine;
}

/// The same of a part without choices among structures, by rows that are found once.
template <class Part>
Part part_of(const ResolvedCase& in, Missing missing = Missing::refused) {
  static const RowsOfPart<Part> rows;
  Part part{};
  MachineFromCase visit(in, missing);
  rows.read_all(visit, part);
  return part;
}

}  // namespace orbearing::app
