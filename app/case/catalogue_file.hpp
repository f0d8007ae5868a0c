// Catalogues of bearings as tables: that of the program, and those of users. One reader for both; columns and
// families are listed in docs/bearings.md.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/case/field.hpp"
#include "app/case/mistake.hpp"
#include "bearing/catalogue/entries.hpp"

namespace orbearing::app {

/// The program's own catalogue (bearing/catalogue/catalogue.csv).
const std::vector<bearing::catalogue::Entry>& built_in_catalogue();

/// The lines of a table. `file` is shown in mistakes, which are added at the path of a case.
std::vector<bearing::catalogue::Entry> read_catalogue(const std::string& text, const std::string& file,
                                                      const std::string& path,
                                                      std::vector<Mistake>& mistakes);

/// Puts the text of the file that the value names beside its name, or of a table of several lines that the
/// case itself contains; false where it is no catalogue, with the mistakes added.
bool take_catalogue(FieldValue& value, const Location& location, const std::string& path,
                    const std::string& case_file, std::vector<Mistake>& mistakes);

/// The lines of a value that take_catalogue() has filled. Each text is read once.
const std::vector<bearing::catalogue::Entry>& catalogue_of(const FieldValue& value);

/// A table of that line alone: what a resolved case repeats of a user's file.
std::string table_of(const bearing::catalogue::Entry& entry);

}  // namespace orbearing::app
