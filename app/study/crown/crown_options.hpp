// Options of `orbearing crown` besides the case, as text and as numbers.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/case/units.hpp"
#include "coupling/study/crowning/half_space_search.hpp"

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

/// Options as typed; empty: the default.
struct CrownOptions {
  std::string profiles;        // --profile         "iso16281, circular"
  std::string tilts;           // --tilts           "0 mrad, 1 mrad" or "0 mrad : 2 mrad : 0.5 mrad"
  std::string drops;           // --drops           the same with lengths
  std::string shares;          // --shares          of the time, one for each swept speed
  std::string tolerance;       // --tolerance       plus and minus about the drop
  std::string tilt_tolerance;  // --tilt-tolerance  plus and minus about each tilt
  std::string distribution;    // --distribution    of misses within the tolerances
  std::string life;            // --life            by life.method
  std::string of_set;          // --of: which of several sets
  bool spectrum = false;       // all swept speeds
  int starts = 10;
};

/// The same as JSON, so that a report can repeat the study.
nlohmann::ordered_json options_json(const CrownOptions& options);
CrownOptions options_from(const nlohmann::ordered_json& object);

/// One line that names all that differs between studies of a case.
std::string options_text(const CrownOptions& options);

/// A study, checked and in SI.
struct CrownRequest {
  study::PlanetaryDrivetrain drivetrain;
  study::DrivetrainGeometry geometry;
  study::crowning::LifeMethod method = study::crowning::LifeMethod::lundberg_palmgren;
  int laminae = 40;
  std::vector<study::crowning::SpectrumPoint> spectrum;
  std::vector<std::string> profiles;
  std::vector<double> tilts;  // [rad]  one of 0 where they are computed
  std::vector<double> drops;  // [m]  rising
  bool drops_stated = false;  // else the study extends them until the best is among them
  study::crowning::Tolerance tolerance;
  study::crowning::Distribution distribution = study::crowning::Distribution::worst;
  int starts = 10;

  bool computes_tilt() const { return drivetrain.seats.tilt == study::TiltState::computed; }
};

/// The case as crown takes it: tilts are computed where neither options nor the case state them.
struct CrownCase {
  ResolvedCase resolved;
  std::vector<std::string> warnings;  // why they are not, where that is the reason
};

/// Throws BadInput where the case has no planet bearing.
CrownCase crown_case(const ResolvedCase& resolved, const CrownOptions& options);

/// Request for a case from crown_case(). Throws BadInput with every mistake at once.
CrownRequest crown_request(const ResolvedCase& resolved, const CrownOptions& options);

}  // namespace orbearing::app
