// Scratches of every kind that a motion integrates through, so many that rollers at random positions are on
// some of them.
#pragma once

#include <vector>

#include "bearing/defect/scratched_elements.hpp"

namespace orbearing::test {

inline bearing::defect::Scratch many(bearing::defect::Scratched race, double width, double spacing,
                                     bearing::ScratchForm form) {
  bearing::defect::Scratch scratch{.race = race, .width = width, .depth = 1e-4, .form = form};
  for (int i = 1; i * spacing < 6.0; ++i) scratch.more_angles.push_back(i * spacing);
  return scratch;
}

inline std::vector<bearing::defect::Scratch> scratched_races() {
  using bearing::ScratchForm, bearing::defect::Scratched;
  std::vector<bearing::defect::Scratch> all{many(Scratched::outer, 1.1e-3, 0.09, ScratchForm::raised_cosine),
                                            many(Scratched::inner, 0.9e-3, 0.13, ScratchForm::edges),
                                            many(Scratched::inner, 1.0e-3, 0.31, ScratchForm::profile)};
  all.back().profile = {0.0, 0.01, 0.05, 0.02, 0.06, 0.03, 0.0};
  return all;
}

/// With two scratched rollers, one of them with scratches of two kinds.
inline std::vector<bearing::defect::Scratch> scratched_everywhere() {
  using bearing::ScratchForm, bearing::defect::Scratched;
  std::vector<bearing::defect::Scratch> all = scratched_races();
  all.push_back(many(Scratched::roller, 0.8e-3, 0.5, ScratchForm::raised_cosine));
  all.push_back(many(Scratched::roller, 0.6e-3, 0.7, ScratchForm::edges));
  all.push_back(many(Scratched::roller, 0.9e-3, 0.4, ScratchForm::raised_cosine));
  all.back().element = 4;
  return all;
}

}  // namespace orbearing::test
