// Choices of a crowning study besides the case, as text and as numbers.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/case/units.hpp"
#include "app/options/option.hpp"
#include "coupling/analysis/crowning/half_space_search.hpp"

namespace orbearing::app {

// Lists of quantities on the command line: "0 mrad, 1 mrad" or "0 um : 16 um : 2 um".

/// Permitted values of a list.
struct ListRange {
  double least = 0.0, most = 0.0;  // [dimension.si]
  std::string words;               // "tilts from 0 to 100 mrad"
};

/// Numbers [dimension.si] in the order given; "FROM : TO : STEP" means all in between. Faults are added to
/// `mistakes` as they were written, each beginning with `option`.
std::vector<double> quantity_list(const std::string& option, const std::string& text,
                                  const Dimension& dimension, const ListRange& range,
                                  std::vector<std::string>& mistakes);

inline constexpr double kMostDrop = 1e-3;  // [m]  that a study takes

/// Choices of a study as typed; empty: the default.
struct CrownChoices {
  std::string profiles;        // "iso16281, circular"
  std::string tilts;           // "0 mrad, 1 mrad" or "0 mrad : 2 mrad : 0.5 mrad"
  std::string drops;           // the same with lengths
  bool spectrum = false;       // all swept speeds
  std::string shares;          // of the time, one for each swept speed
  std::string tolerance;       // plus and minus about the drop
  std::string tilt_tolerance;  // plus and minus about each tilt
  std::string distribution;    // of misses within the tolerances
  std::string life;            // by life.method
  std::string of_set;          // which of several sets
  int starts = 10;             // of the search
};
inline void describe(OptionList& list, CrownChoices& m) {
  described::members(
      list, m,
      option(m.profiles, "--profile",
             "kinds of profile, separated by commas: chamfer, circular, straight-circular, lundberg, "
             "johns-gohar, iso16281, fujiwara-kawase; default: that of the case, else iso16281"),
      option(m.tilts, "--tilts",
             "stated tilts of the planet's bore on its pin: a list or FROM : TO : STEP. Default: none, tilts "
             "are computed from planet, pin and bearings (if not possible: \"0 mrad, 1 mrad, 2 mrad\")"),
      option(m.drops, "--drops",
             "relief of one roller at the outermost of 40 laminae: a list or FROM : TO : STEP of "
             "lengths. Default: 17 from 0 to about three times that of ISO/TS 16281"),
      option(m.spectrum, "--spectrum",
             "all speeds of the sweep, for equal times, instead of the one speed of the case"),
      option(m.shares, "--shares",
             "with --spectrum: shares of the time, one for each speed, separated by commas"),
      option(m.tolerance, "--tolerance",
             "tolerance of the drop, plus and minus, that the recommended drop takes into account, e.g. "
             "\"1 um\""),
      option(m.tilt_tolerance, "--tilt-tolerance",
             "the same for each stated tilt, or for the inclination of the pin in either direction "
             "where tilts are computed, e.g. \"0.5 mrad\""),
      option(m.distribution, "--distribution",
             "distribution of deviations within the tolerances: normal (cut off at three standard "
             "deviations; default), uniform, or worst (the limits only; the only one for stated tilts)",
             {.choices = {"normal", "uniform", "worst"}}),
      option(m.life, "--life",
             "lundberg-palmgren (the life of a sweep for straight rollers without tilt) or iso16281 "
             "(with its stress riser at the ends); default: by life.method of the case",
             {.choices = {"lundberg-palmgren", "iso16281"}}),
      option(m.of_set, "--of", "the set of the studied planet bearing, if the case has several sets",
             {.type = "SET"}),
      option(m.starts, "--starts", "random starts of the search for the best crown; default: 10",
             {.range = described::Range{1, 1000}}));
}

/// The same as JSON, so that a report can repeat the study.
nlohmann::ordered_json choices_json(const CrownChoices& choices);
CrownChoices choices_from(const nlohmann::ordered_json& object);

/// One line that names all that differs between studies of a case.
std::string choices_text(const CrownChoices& choices);

/// A study, checked and in SI.
struct CrownRequest {
  analysis::PlanetaryDrivetrain drivetrain;
  analysis::DrivetrainGeometry geometry;
  analysis::crowning::LifeMethod method = analysis::crowning::LifeMethod::lundberg_palmgren;
  int laminae = 40;
  std::vector<analysis::crowning::SpectrumPoint> spectrum;
  std::vector<std::string> profiles;
  std::vector<double> tilts;  // [rad]  one of 0 where they are computed
  std::vector<double> drops;  // [m]  rising
  bool drops_stated = false;  // else the study extends them until the best is among them
  analysis::crowning::Tolerance tolerance;
  analysis::crowning::Distribution distribution = analysis::crowning::Distribution::worst;
  int starts = 10;

  bool computes_tilt() const { return drivetrain.seats.tilt == analysis::TiltState::computed; }
};

/// The case as crown takes it: tilts are computed where neither choices nor the case state them.
struct CrownCase {
  ResolvedCase resolved;
  std::vector<std::string> warnings;  // why they are not, where that is the reason
};

/// Throws BadInput where the case has no planet bearing.
CrownCase crown_case(const ResolvedCase& resolved, const CrownChoices& choices);

/// Request for a case from crown_case(). Throws BadInput with every mistake at once.
CrownRequest crown_request(const ResolvedCase& resolved, const CrownChoices& choices);

}  // namespace orbearing::app
