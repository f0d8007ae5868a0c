// Machines whose cases are types, and analyses of the library that take them: one row for each. Fields of
// cases, which analysis uses which input, checks and runs follow from the types in these rows.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>
#include <type_traits>
#include <utility>

#include "app/case/analysis_id.hpp"
#include "app/case/model.hpp"
#include "coupling/analysis/ball_run.hpp"
#include "coupling/analysis/bearing_stiffness.hpp"
#include "coupling/analysis/bearing_under_load.hpp"
#include "coupling/analysis/contact_film.hpp"
#include "coupling/analysis/duplex_run.hpp"
#include "coupling/analysis/pair_meshes.hpp"
#include "coupling/analysis/scratched_bearing.hpp"
#include "mechanics/described.hpp"

namespace orbearing::app {

/// Relative differences between runs whose inputs differ by round-off [-].
namespace scatter {
inline constexpr double at_rest = 1e-14;   // equilibria of rollers are found to 1e-15
inline constexpr double of_balls = 1e-13;  // those of balls
inline constexpr double of_films = 1e-8;   // of the Reynolds solver's iterations
inline constexpr double in_motion = 3e-3;  // lives from another start (docs/sensitivities.md)
}  // namespace scatter

/// How a line of progress begins, and of how many parts it counts.
struct ProgressLine {
  const char* doing;
  std::size_t parts;
};

/// How a result is named.
struct ResultNames {
  const char* name;                 // in the manifest
  const char* title;                // of the netCDF file
  const char* json_file = nullptr;  // of the folder, which holds what --json prints; null: none
};

/// Calls `call` with each row, and its number.
template <class... Rows>
struct RowsOf {
  template <class Call>
  static void each(const Call& call) {
    std::size_t number = 0;
    (call(Rows{}, number++), ...);
  }
};
/// File of a result folder that holds what `run --json` prints of a ball bearing in time.
inline constexpr const char* ball_file_name = "ball.json";
/// The same of a bearing with scratches, or a gear set with one.
inline constexpr const char* defect_file_name = "defect.json";
/// Progress of a signal.
inline constexpr ProgressLine signal_progress{"signal, in hundredths: ", 100};

namespace machine_rows {

struct PairOfGears {
  using Type = analysis::PairOfGears;
  /// By their `problems`: one where all of its required inputs are there, several as far as they are.
  using Checked = RowsOf<Type>;
  static constexpr Model model = gear_pair;
  static constexpr std::string_view prefix = "pair.";  // of what `check` derives
};
struct DuplexPair {
  using Type = analysis::DuplexPair;
  using Checked = RowsOf<Type>;
  static constexpr Model model = duplex_pair;
  static constexpr std::string_view prefix = "pair.";
};
struct SpinFilm {
  using Type = analysis::SpinFilm;
  using Checked = RowsOf<Type>;
  static constexpr Model model = spin_film;
  static constexpr std::string_view prefix = "";
};
struct RollerBearing {
  using Type = analysis::RollerBearing;
  using Checked =
      RowsOf<analysis::OilOfRollers, analysis::LoadOnRollers, analysis::ViscosityRatio, analysis::OilOfLife>;
  static constexpr Model model = roller_bearing;
  static constexpr std::string_view prefix = "";
};
struct BallBearing {
  using Type = analysis::BallBearing;
  using Checked = RowsOf<analysis::LoadOnRing, analysis::ViscosityRatio, analysis::OilOfLife>;
  static constexpr Model model = ball_bearing;
  static constexpr std::string_view prefix = "";
};
struct BallsInTime {
  using Type = analysis::BallsInTime;
  using Checked =
      RowsOf<analysis::BallsInTime, analysis::LoadOnRing, analysis::ViscosityRatio, analysis::OilOfLife>;
  static constexpr Model model = ball_motion;
  static constexpr std::string_view prefix = "";
};

struct ScratchedBalls {
  using Type = analysis::ScratchedBallBearing;
  using Checked = RowsOf<analysis::ScratchOfBalls, analysis::SampledRing, analysis::RingOnBalls>;
  static constexpr Model model = raceway_defect;
  static constexpr std::string_view prefix = "defect.";
};
struct ScratchedRollers {
  using Type = analysis::RingOnRollers;
  using Checked = RowsOf<analysis::ScratchOfRollers, analysis::SampledRing, analysis::RingOnRollers>;
  static constexpr Model model = roller_defect;
  static constexpr std::string_view prefix = "defect.";
};

struct MeshesOfPair {
  static constexpr auto analyse = analysis::meshes_of_pair;
  static constexpr Model model = gear_pair;
  static constexpr std::string_view command = "mesh";
  static constexpr const char* name = "mesh";  // for users, among those that use an input
  static constexpr ResultNames names{"mesh", "meshes of a pair of gears"};
  static constexpr double scatter = app::scatter::at_rest;
};
struct DuplexModes {
  static constexpr auto analyse = analysis::duplex_modes;
  static constexpr Model model = duplex_pair;
  static constexpr std::string_view command = "modes";
  static constexpr const char* name = "modes of a duplex pair";
  static constexpr ResultNames names{"modes", "modes of a shaft on a duplex pair"};
  static constexpr double scatter = app::scatter::of_balls;
};
struct DuplexRun {
  static constexpr auto analyse = analysis::duplex_run;
  static constexpr Model model = duplex_pair;
  static constexpr std::string_view command = "run";
  static constexpr const char* name = "run of a duplex pair";
  static constexpr const char* other_fidelity =  // required instead of another --fidelity
      "none for the model duplex-pair, which is in static equilibrium";
  static constexpr ResultNames names{"duplex", "shaft on a duplex pair", "duplex.json"};
  static constexpr double scatter = app::scatter::of_balls;
};
struct FilmOfContact {
  static constexpr auto analyse = analysis::film_of_contact;
  static constexpr Model model = spin_film;
  static constexpr std::string_view command = "run";
  static constexpr const char* name = "run of a contact that rolls and spins";
  static constexpr const char* other_fidelity = "none for the model spin-film, which is steady";
  static constexpr ResultNames names{"film", "film of a contact"};
  static constexpr double scatter = app::scatter::of_films;
};

struct SingleBearingAtRest {
  static constexpr std::string_view command = "run";
  static constexpr const char* name = "run of a single bearing";
  static constexpr const char* other_fidelity = "quasi-static for a single bearing under a static load";
  static constexpr ResultNames names{"static", "bearing under a static load"};
};
struct RollersUnderLoad : SingleBearingAtRest {
  static constexpr auto analyse = analysis::rollers_under_load;
  static constexpr Model model = roller_bearing;
  static constexpr double scatter = app::scatter::at_rest;
};
struct BallsUnderLoad : SingleBearingAtRest {
  static constexpr auto analyse = analysis::balls_under_load;
  static constexpr Model model = ball_bearing;
  static constexpr double scatter = app::scatter::of_balls;
};
struct RunOfBalls {
  static constexpr auto analyse = analysis::run_of_balls;
  static constexpr Model model = ball_motion;
  static constexpr std::string_view command = "run";
  static constexpr const char* name = "run of a ball bearing in time";
  static constexpr const char* other_fidelity =
      "dynamic for a ball bearing in time, or a case without the block simulation";
  static constexpr ResultNames names{"dynamic", "ball bearing in time", ball_file_name};
  static constexpr double scatter = app::scatter::in_motion;
  static constexpr ProgressLine progress{"time, in thousandths: ", 1000};
  static double simulated(const analysis::BallsInTime& in) { return in.simulation.options.duration; }
};
struct StiffnessOfSingleBearing {
  static constexpr std::string_view command = "stiffness";
  static constexpr const char* name = "stiffness of a single bearing";
  static constexpr ResultNames names{"stiffness", "stiffness"};
};
struct StiffnessOfRollers : StiffnessOfSingleBearing {
  static constexpr auto analyse = analysis::stiffness_of_rollers;
  static constexpr Model model = roller_bearing;
  static constexpr double scatter = app::scatter::at_rest;
};
struct StiffnessOfBalls : StiffnessOfSingleBearing {
  static constexpr auto analyse = analysis::stiffness_of_balls;
  static constexpr Model model = ball_bearing;
  static constexpr double scatter = app::scatter::of_balls;
};

struct RunOfScratches {
  static constexpr std::string_view command = "run";
  static constexpr const char* name = "run of a bearing with scratches";
  static constexpr const char* other_fidelity =
      "none for the model raceway-defect, whose ring moves on balls without mass, or dynamic, for all of the "
      "bearing in motion";
  static constexpr ResultNames names{"defect", "vibration of a bearing with scratches", defect_file_name};
  static constexpr double scatter = app::scatter::in_motion;
};
struct RingOnBalls : RunOfScratches {
  static constexpr auto analyse = analysis::ring_on_balls;
  static constexpr Model model = raceway_defect;
};
struct RingOnRollers : RunOfScratches {
  static constexpr auto analyse = analysis::ring_on_rollers;
  static constexpr Model model = roller_defect;
  static constexpr const char* other_fidelity =
      "none for a single scratched bearing of rollers, or a planetary drivetrain with a block 'defect', "
      "where "
      "all of its bearings move";
};
struct ScratchedBallsInMotion : RunOfScratches {
  static constexpr auto analyse = analysis::moving_scratched_balls;
  static constexpr Model model = raceway_defect;
  static constexpr const char* name = "run --fidelity dynamic of a bearing with scratches";
  static constexpr const char* required_since = "the cage moves too";
  static constexpr ResultNames names{"defect, all in motion", RunOfScratches::names.title, defect_file_name};
  static constexpr ProgressLine progress = signal_progress;
  static double simulated(const analysis::ScratchedBallsInMotion& in) {
    return analysis::time_of_signal(in.of);
  }
};

}  // namespace machine_rows

using Machines = RowsOf<machine_rows::BallsInTime, machine_rows::RollerBearing, machine_rows::BallBearing,
                        machine_rows::PairOfGears, machine_rows::DuplexPair, machine_rows::SpinFilm,
                        machine_rows::ScratchedBalls, machine_rows::ScratchedRollers>;
using MachineAnalyses =
    RowsOf<machine_rows::RollersUnderLoad, machine_rows::BallsUnderLoad, machine_rows::RunOfBalls,
           machine_rows::StiffnessOfRollers, machine_rows::StiffnessOfBalls, machine_rows::MeshesOfPair,
           machine_rows::DuplexModes, machine_rows::DuplexRun, machine_rows::FilmOfContact,
           machine_rows::RingOnBalls, machine_rows::RingOnRollers, machine_rows::ScratchedBallsInMotion>;

/// Gets the share of a motion that is done [-].
using ShareDone = std::function<void(double)>;

/// Types of the inputs and of the result of a library function.
template <class Function>
struct InputsOf;
template <class Output, class Inputs>
struct InputsOf<Output (*)(const Inputs&)> {
  using Type = Inputs;
  using Result = Output;
};
template <class Output, class Inputs>
struct InputsOf<Output (*)(const Inputs&, const ShareDone&)> : InputsOf<Output (*)(const Inputs&)> {};

/// The same of a row of MachineAnalyses.
template <class Row>
using InputsOfRow = typename InputsOf<std::decay_t<decltype(Row::analyse)>>::Type;
template <class Row>
using ResultOfRow = typename InputsOf<std::decay_t<decltype(Row::analyse)>>::Result;

/// Results that limits of lives, pressures and safety apply to.
template <class Result>
inline constexpr bool is_rated = requires(const Result& result) {
  result.life_table();
};

template <class... Rows>
constexpr std::size_t count_of(RowsOf<Rows...>) {
  return sizeof...(Rows);
}
static_assert(static_cast<std::size_t>(AnalysisId::first_of_machines) + count_of(MachineAnalyses{}) <= 64,
              "a set of analyses has 64 at most");

/// The row of that number among all analyses.
constexpr AnalysisId id_of_machine_analysis(std::size_t number) {
  return static_cast<AnalysisId>(static_cast<std::size_t>(AnalysisId::first_of_machines) + number);
}

}  // namespace orbearing::app
