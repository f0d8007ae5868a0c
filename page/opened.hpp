// Argument of `orbearing open`: a case file, a template, a folder of results, or nothing.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace orbearing::page {

using Json = nlohmann::ordered_json;

struct Opened {
  std::string kind;              // "case", "template", "results" or "start"
  std::string name;              // of the file, the template or the folder
  std::string text;              // of the case; empty at the start
  std::string file{};            // its name within the folder
  std::filesystem::path folder;  // the only one that is read and written; empty: none
  std::string fault{};           // why the text is not that of the file now
};

/// Throws BadInput where `what` is neither a case file, nor a folder of results or with a case.yaml, nor the
/// name of a template; and where the case in a folder of results is not the one that was run. Empty: the
/// start.
Opened opened_as(const std::string& what);

/// The same with the text that its file has now; where it cannot be read, with the former text and a fault.
Opened read_again(const Opened& opened);

/// Object for the page, with the "checksum" of the text of a file; of a folder of results, finished or still
/// computed, with "finished", "points" and, where they are complete, "result" as --json prints it; else
/// "options" that continue it. Reads the results anew; "error" states why there are none.
Json opened_json(const Opened& opened);

/// Folders of results in the folder that was opened (else in the one where the program was started), newest
/// first: name, case, fidelity, points found and of how many.
Json result_folders_json(const Opened& opened);

/// One of these by its name, or by "" the folder of results that was opened. Throws BadInput.
Opened results_within(const Opened& opened, const std::string& name);

/// Templates with name, title, purpose and text.
Json templates_json();

/// The text of a file changed since it was read: `now` is its checksum.
struct OtherVersion {
  std::string now;
};

/// Takes a file of that name into the folder. `began_with`: checksum of the version that the text replaces;
/// empty: of none. Throws BadInput where it may not be written, OtherVersion where the file has another
/// content.
void save(const Opened& opened, const std::string& file, const std::string& text,
          const std::string& began_with);

/// The lives in what `run --json` prints, as a table of HTML in whole hours; why there are none otherwise.
std::string lives_table(const Opened& opened, const Json& result);

/// The same in a sentence: `reason` is text of any source.
std::string no_lives(const std::string& reason);

/// A quantity in another unit: {"value": "3 mm", "unit": "um"} -> {"number": 3000, "text": "3000 um"}.
Json converted(const Json& request);

}  // namespace orbearing::page
