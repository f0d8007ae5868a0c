// Case files: YAML and --set options -> ResolvedCase. Every mistake is reported at once.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/case/rows_file.hpp"

namespace orbearing::app {

/// Reads and checks a case file. `settings` are the texts of the --set options: "path=value".
/// Throws BadInput (app/errors.hpp) with all mistakes, also where the file cannot be read.
/// `file` may be a folder that holds case.yaml.
ResolvedCase read_case(const std::string& file, const std::vector<std::string>& settings = {});

/// The same for a command that computes one operating point: without the sweep of the file. An option that
/// gives a sweep is a mistake.
ResolvedCase read_point(const std::string& file, const std::vector<std::string>& settings);

/// The same for a text in memory; `name` is the name of the file in messages.
ResolvedCase parse_case(std::string_view text, const std::string& name,
                        const std::vector<std::string>& settings = {});

/// Source of a case: with other settings it is read again, even if its files have changed or were deleted.
struct CaseSource {
  std::string name;  // of the file, in messages and for files in its folder
  std::string text;
  KeptFiles files{};  // files that the case names
};

/// Reads a file, or case.yaml of a folder, as it is. Throws BadInput.
CaseSource source_of(const std::string& file);

/// The case of the source with settings; files that it names are added to the source.
ResolvedCase parse_case(CaseSource& source, const std::vector<std::string>& settings);

}  // namespace orbearing::app
