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
  Rows(fields, planetary_drivetrain)
      .text("defect.set", "set with the scratched bearing, of several sets", Use(use::planet_defect, 0));
  Rows(fields, scratched_bearings)
      .quantity("signal.band",
                "lower and upper end of the band whose envelope is taken; left out: the band of largest "
                "spectral kurtosis",
                Use(use::defect | use::moving_defect | use::planet_defect, 0), dimension::frequency,
                positive(1e5))
      .listed();
}

}  // namespace orbearing::app::table
