// Lines of the program's catalogue, or of a case's own, by the designation that a case states; suffixes
// behind a listed designation, and what the lines print.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/case/catalogue_fields.hpp"
#include "app/case/field.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/resolved_case.hpp"
#include "bearing/catalogue/classes.hpp"
#include "bearing/catalogue/entries.hpp"
#include "bearing/catalogue/suffixes.hpp"

namespace orbearing::app::catalogue_lines {

namespace catalogue = bearing::catalogue;

/// The largest number of rollers that fit without a cage.
int most_rollers(double pitch_diameter, double roller_diameter);

catalogue::ClearanceClass class_of(const std::string& name);

/// Seat of a bearing by a tolerance class instead of an interference.
struct Seat {
  std::string tolerance, diameter, interference;  // keys of inputs
  catalogue::Deviations (*range)(std::string_view tolerance, double diameter);
};
/// Of the inner ring on its pin, and of the outer ring in its planet.
const std::array<Seat, 2>& seats();

/// By its line, if any, or as a case states it.
catalogue::Family family_of(const catalogue::Entry* entry, unsigned model, bool has_contact_angle);
catalogue::Family family_of(const ResolvedCase& in);
/// Requirement where a clearance class has no bore.
inline constexpr const char* kBoreRequired = "bearing.designation or bearing.bore is required as well";
/// Bore [m] by the line of the case's designation, or as stated; none: not known.
std::optional<double> bore_of(const ResolvedCase& in);

/// Cached, since each point of a sweep is a copy of its case and repeats the request. Throws
/// std::invalid_argument where no interior fits.
const catalogue::Inside& known_inside(const catalogue::Entry& entry);

/// A line, and suffixes of the designation that the line does not have.
struct ReadDesignation {
  const catalogue::Entry* line = nullptr;
  catalogue::SuffixedName name{};
};
/// A suffix that is listed is a part of the designation; others are read behind a listed one. A user's own
/// lines go before those of the program. `table` may be null.
ReadDesignation read_designation(const FieldValue* table, const std::string& designation);
const catalogue::Entry* line_of(const FieldValue* table, const std::string& designation);

/// The case's own catalogue; null where it has none.
const FieldValue* table_of_case(const ResolvedCase& in, const std::string& set = "");
/// Null where the case has no designation, or one that no line has.
const catalogue::Entry* line_of(const ResolvedCase& in, const std::string& set = "");

/// A bearing as its maker calls it: without suffixes that were read behind a listed designation.
std::string maker_name(const catalogue::Entry& entry, const std::string& designation);
/// The same with the source of the line.
std::string name_of(const catalogue::Entry& entry, const std::string& designation);
/// Designations of rollers, or of balls: a user's own first.
std::vector<std::string> designations_of(const FieldValue* table, bool rollers);

/// Ratings of a bearing that a line prints, by the inputs that may state others; 0: not printed.
struct PrintedRating {
  std::string path;
  double value;  // [N]
};
std::array<PrintedRating, 3> ratings_of(const catalogue::Entry& entry);
/// Exponent of a rating of rollers over their number, all else equal: C of [ISO281], C_0 of [ISO76], and C_u,
/// which is proportional to C_0.
double exponent_of_number(std::string_view rating);
/// A printed rating with `rollers` instead of those of the line.
double with_rollers_instead(const PrintedRating& rating, const catalogue::Inside& inside, int rollers);
std::string newtons(double force);

/// Cage by a designation or by the catalogue line that it selects: material and reason.
struct NamedCage {
  std::string_view material;
  std::string reason;  // "the suffix P (cage of polyamide) of NJ 2206 ECP"
};
/// Suffixes of the designation come before what the line has, and the maker's suffix comes last.
std::optional<NamedCage> cage_of(const FieldValue* table, const std::string& designation);

}  // namespace orbearing::app::catalogue_lines
