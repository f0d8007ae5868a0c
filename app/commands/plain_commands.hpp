// Commands with a case as their only option: each is a word, its purpose and what it computes.
#pragma once

#include <string>
#include <variant>

#include "app/case/analysis_result.hpp"
#include "app/commands/common_options.hpp"

namespace orbearing::app {

/// The analysis that the case's machine has under a word (app/case/machine_rows.hpp), with warnings of inputs
/// that it does not use. Throws BadInput where there is none.
AnalysisResult result_of_machine(const ResolvedCase& point, const std::string& word);

struct MeshCommand {
  static constexpr const char* command = "mesh";
  static constexpr const char* purpose = "mesh stiffness over a mesh period, contact ratio, phases";
  static AnalysisResult compute(const ResolvedCase& point);
};
struct CarrierCommand {
  static constexpr const char* command = "carrier";
  static constexpr const char* purpose =
      "loads and lives of each planet bearing over a revolution of a carrier on its own bearings";
  static AnalysisResult compute(const ResolvedCase& point);
};

/// A command without `compute` has the analyses of machines under its word: none so far, since drivetrains
/// have these, too.
template <class Word>
struct PlainCommand {
  static constexpr const char* command = Word::command;
  static constexpr const char* purpose = Word::purpose;
  Printing print;
  StatedCase stated;
};
template <class Word>
void describe(OptionList& list, PlainCommand<Word>& m) {
  described::members(list, m, described::part(m.print), described::part(m.stated));
}

/// Prints the result of a command. Returns its exit code.
int present_plain(const ResolvedCase& point, const AnalysisResult& result, const Printing& print);
int execute_plain(const Printing& print, const StatedCase& stated,
                  AnalysisResult (*compute)(const ResolvedCase&));

template <class Word>
int execute(const PlainCommand<Word>& options) {
  return execute_plain(options.print, options.stated, [](const ResolvedCase& point) {
    if constexpr (requires { Word::compute(point); })
      return Word::compute(point);
    else
      return result_of_machine(point, Word::command);
  });
}

/// In the order of the help.
using PlainCommands = std::variant<PlainCommand<MeshCommand>, PlainCommand<CarrierCommand>>;

}  // namespace orbearing::app
