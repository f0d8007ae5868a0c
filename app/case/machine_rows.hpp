// Machines whose cases are types, and analyses of the library that take them: one row for each. Fields of
// cases, which analysis uses which input, checks and runs follow from the types in these rows.
#pragma once

#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>

#include "app/case/field_use.hpp"
#include "coupling/analysis/contact_film.hpp"
#include "coupling/analysis/duplex_run.hpp"
#include "coupling/analysis/pair_meshes.hpp"
#include "mechanics/described.hpp"

namespace orbearing::app {

/// Relative differences between runs whose inputs differ by round-off [-].
namespace scatter {
inline constexpr double at_rest = 1e-14;   // equilibria of rollers are found to 1e-15
inline constexpr double of_balls = 1e-13;  // those of balls
inline constexpr double of_films = 1e-8;   // of the Reynolds solver's iterations
inline constexpr double in_motion = 3e-3;  // lives from another start (docs/sensitivities.md)
}  // namespace scatter

/// How a result is named.
struct ResultNames {
  const char* name;                 // in the manifest
  const char* title;                // of the netCDF file
  const char* json_file = nullptr;  // of the folder, which holds what --json prints; null: none
};

namespace machine_rows {

using described::Model;

struct PairOfGears {
  using Type = analysis::PairOfGears;
  static constexpr Model model = described::gear_pair;
  static constexpr std::string_view prefix = "pair.";  // of what `check` derives
};
struct DuplexPair {
  using Type = analysis::DuplexPair;
  static constexpr Model model = described::duplex_pair;
  static constexpr std::string_view prefix = "pair.";
};
struct SpinFilm {
  using Type = analysis::SpinFilm;
  static constexpr Model model = described::spin_film;
  static constexpr std::string_view prefix = "";
};

struct MeshesOfPair {
  static constexpr auto analyse = analysis::meshes_of_pair;
  static constexpr Model model = described::gear_pair;
  static constexpr std::string_view command = "mesh";
  static constexpr const char* name = "mesh";        // for users, among those that use an input
  static constexpr const char* other_fidelity = "";  // required instead of another --fidelity
  static constexpr ResultNames names{"mesh", "meshes of a pair of gears"};
  static constexpr double scatter = app::scatter::at_rest;
};
struct DuplexModes {
  static constexpr auto analyse = analysis::duplex_modes;
  static constexpr Model model = described::duplex_pair;
  static constexpr std::string_view command = "modes";
  static constexpr const char* name = "modes of a duplex pair";
  static constexpr const char* other_fidelity = "";
  static constexpr ResultNames names{"modes", "modes of a shaft on a duplex pair"};
  static constexpr double scatter = app::scatter::of_balls;
};
struct DuplexRun {
  static constexpr auto analyse = analysis::duplex_run;
  static constexpr Model model = described::duplex_pair;
  static constexpr std::string_view command = "run";
  static constexpr const char* name = "run of a duplex pair";
  static constexpr const char* other_fidelity =
      "none for the model duplex-pair, which is in static equilibrium";
  static constexpr ResultNames names{"duplex", "shaft on a duplex pair", "duplex.json"};
  static constexpr double scatter = app::scatter::of_balls;
};
struct FilmOfContact {
  static constexpr auto analyse = analysis::film_of_contact;
  static constexpr Model model = described::spin_film;
  static constexpr std::string_view command = "run";
  static constexpr const char* name = "run of a contact that rolls and spins";
  static constexpr const char* other_fidelity = "none for the model spin-film, which is steady";
  static constexpr ResultNames names{"film", "film of a contact"};
  static constexpr double scatter = app::scatter::of_films;
};

}  // namespace machine_rows

/// Calls `call` with each row, and its number.
template <class... Rows>
struct RowsOf {
  template <class Call>
  static void each(const Call& call) {
    std::size_t number = 0;
    (call(Rows{}, number++), ...);
  }
};
using Machines = RowsOf<machine_rows::PairOfGears, machine_rows::DuplexPair, machine_rows::SpinFilm>;
using MachineAnalyses = RowsOf<machine_rows::MeshesOfPair, machine_rows::DuplexModes, machine_rows::DuplexRun,
                               machine_rows::FilmOfContact>;

/// Type of the inputs of a library function.
template <class Function>
struct InputsOf;
template <class Result, class Inputs>
struct InputsOf<Result (*)(const Inputs&)> {
  using Type = Inputs;
};

/// The same of a row of MachineAnalyses.
template <class Row>
using InputsOfRow = typename InputsOf<std::decay_t<decltype(Row::analyse)>>::Type;

/// The bit of the analysis of that number among those of all.
constexpr use::Analysis use_of_machine_analysis(std::size_t number) {
  return static_cast<use::Analysis>(unsigned{use::first_of_machines} << number);
}

}  // namespace orbearing::app
