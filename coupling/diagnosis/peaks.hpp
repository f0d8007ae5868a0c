// Peaks of a spectrum, and which of the expected lines each one is.
#pragma once

#include <string>
#include <vector>

#include "coupling/diagnosis/spectrum.hpp"

namespace orbearing::diagnosis {

struct Peak {
  double frequency = 0.0;  // [Hz]  between the lines of the spectrum, by the shape of the Hann window
  double amplitude = 0.0;  // [unit of the signal]
};

/// Which peaks are looked for.
struct PeakSearch {
  double highest = 0.0;       // [Hz]
  double least_share = 0.01;  // [-]  of the largest one up to there
  std::size_t most = 24;
};

/// Largest first. Of a spectrum by Window::hann: what is less than four lines from a larger one is its side
/// lobe.
std::vector<Peak> peaks_of(const Spectrum& spectrum, const PeakSearch& search);

/// A line that may be there, and how many steps it is from what causes it: the least explains a peak.
struct ExpectedLine {
  double frequency = 0.0;  // [Hz]
  std::string name;
  int order = 1;
};

/// "name", "2 x name".
std::string harmonic_name(int harmonic, const std::string& name);

/// Adds harmonics 1 to `harmonics` of `frequency`, each with side bands up to `bands` times `spacing` to both
/// sides: "name", "2 x name - spacing name". Their order grows from `order` on.
void add_lines(double frequency, const std::string& name, int harmonics, double spacing,
               const std::string& spacing_name, int bands, int order, std::vector<ExpectedLine>& lines);

/// The name of the simplest expected line within `tolerance` [Hz]; "unknown" where none is.
std::string name_of(double frequency, const std::vector<ExpectedLine>& lines, double tolerance);

}  // namespace orbearing::diagnosis
