// What `orbearing open` was given: a case file, a template, a folder of results, or nothing.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace orbearing::app::page {

using Json = nlohmann::ordered_json;

struct Opened {
  std::string kind;              // "case", "template", "results" or "start"
  std::string name;              // of the file, the template or the folder
  std::string text;              // of the case; empty at the start
  std::string file{};            // its name within the folder
  std::filesystem::path folder;  // the only one that is read and written; empty: none
};

/// Throws BadInput where `what` is neither a case file, nor a folder of results or with a case.yaml, nor the
/// name of a template. Empty: the start.
Opened opened_as(const std::string& what);

/// What the page is given of it; of a folder of results, finished or still computed, with "finished",
/// "points" and, where they are whole, "result" as --json prints it; else "options" that go on with it. Reads
/// the folder anew.
Json opened_json(const Opened& opened);

/// Folders of results in the folder that was opened (else in the one where the program was started), newest
/// first: name, case, fidelity, points found and of how many.
Json result_folders_json(const Opened& opened);

/// One of these by its name, or by "" the folder of results that was opened. Throws BadInput.
Opened results_within(const Opened& opened, const std::string& name);

/// Templates with name, title, purpose and text.
Json templates_json();

/// Takes a file of that name into the folder. Throws BadInput where it may not be written.
void save(const Opened& opened, const std::string& file, const std::string& text);

/// The lives in what `run --json` prints, as a table of HTML in whole hours; why there are none otherwise.
std::string lives_table(const Opened& opened, const Json& result);

/// The same in a sentence: `reason` is text of anybody's.
std::string no_lives(const std::string& reason);

/// A quantity in another unit: {"value": "3 mm", "unit": "um"} -> {"number": 3000, "text": "3000 um"}.
Json converted(const Json& request);

}  // namespace orbearing::app::page
