// Fields of a bearing with scratches, and of its signal.
#include "app/case/described_fields.hpp"
#include "app/case/field_table.hpp"
#include "bearing/defect/scratched_bearing.hpp"
#include "coupling/study/planet_scratch.hpp"
#include "coupling/study/scratch_run.hpp"

namespace orbearing::app::table {

void add_defect_fields(std::vector<Field>& fields) {
  add_described(fields, bearing::defect::VibratingRing{});
  add_described(fields, bearing::defect::Scratch{});
  add_described(fields, study::Sampling{});
  add_described(fields, study::ScratchedPosition{});
  add_described(fields, study::PlanetSampling{});
  fields.push_back({.path = "defect.set",
                    .kind = Kind::text,
                    .meaning = "set with the scratched bearing, of several sets",
                    .use = Use(use::planet_defect, 0),
                    .models = planetary_drivetrain});
  fields.push_back({.path = "signal.band",
                    .kind = Kind::list,
                    .meaning =
                        "lower and upper end of the band whose envelope is taken; left out: the band of "
                        "largest spectral kurtosis",
                    .use = Use(use::defect | use::moving_defect | use::planet_defect, 0),
                    .models = scratched_bearings,
                    .dimension = dimension::frequency,
                    .range = {.least = 0.0, .most = 1e5, .least_allowed = false},
                    .element = Kind::quantity});
}

}  // namespace orbearing::app::table
