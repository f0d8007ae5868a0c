// A case: every input with its value, checked.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "orbearing/errors.hpp"

namespace orbearing {

namespace app {
class ResolvedCase;
}

/// It does not change: with() makes a changed copy, in which values that follow from an input are derived
/// anew. Threads may share it. Every error throws BadInput with a line for each mistake: its location, what
/// was found, what is required.
class Case {
 public:
  /// From a file; `settings` are texts like "input.power=75 kW" that replace values of the file.
  static Case read(const std::string& file, const std::vector<std::string>& settings = {});
  /// From the text of a file; `name` is the file's name in messages.
  static Case parse(const std::string& text, const std::string& name = "case.yaml",
                    const std::vector<std::string>& settings = {});

  Case with(const std::string& path, const std::string& text) const;
  /// By a number in SI; of a list of numbers, "PATH[i]" is its element i, counted from 0.
  Case with(const std::string& path, double number) const;

  /// Whether there is a value at a path such as "bearing.radial_clearance", stated, assumed or derived.
  bool has(const std::string& path) const;
  /// In SI; of a switch 1 or 0.
  double number(const std::string& path) const;
  /// As written, with its unit.
  std::string text(const std::string& path) const;
  /// All of it as YAML, from which the same numbers follow.
  std::string resolved() const;

  /// Internal to the library.
  explicit Case(app::ResolvedCase resolved);
  const app::ResolvedCase& content() const { return *content_; }

 private:
  std::shared_ptr<const app::ResolvedCase> content_;
};

}  // namespace orbearing
