#include "app/study/defect_study.hpp"

#include <fmt/format.h>


#include "app/case/defect_case.hpp"
#include "app/errors.hpp"

namespace orbearing::app {

namespace {

namespace defect = bearing::defect;
using defect::Scratched;

void warn(const ResolvedCase& in, DefectStudy& study) {
  constexpr double resolved_share = 0.4;  // of the sampling rate
  if (study.at_rest.natural_frequency > resolved_share * study.vibration.rate)
    study.warnings.push_back(
        fmt::format("signal.sampling_rate: {} cannot hold the ring's vibration at {:.4g} Hz",
                    in.given("signal.sampling_rate"), study.at_rest.natural_frequency));
}

// A ring on its contacts is no rigid body at such frequencies, and its motion would take hours in silence.
void require_few_steps(const ResolvedCase& in, double natural_frequency) {
  constexpr double most = 1e6;  // [Hz]
  if (natural_frequency > most)
    throw BadInput(fmt::format(
        "{}: bearing.outer_ring_mass: found {}, with which the ring vibrates at {:.3g} Hz on its contacts; "
        "required: a "
        "mass with at most {:.0f} Hz, far above which no ring is rigid",
        in.origin("bearing.outer_ring_mass"), in.given("bearing.outer_ring_mass"), natural_frequency, most));
}

}  // namespace

bool is_defect(const ResolvedCase& resolved) {
  return (resolved.model() & described::single_scratched) != 0;
}

void require_wide_scratch(const ResolvedCase& in) {
  constexpr double least = 1e-6;  // [m]
  if (!in.has("defect.width") || in.quantity("defect.width") >= least) return;
  throw BadInput(fmt::format(
      "{}: defect.width: found '{}'; required: at least 1 um, below which an element sinks in by less "
      "than the size of an atom",
      in.origin("defect.width"), in.given("defect.width")));
}

DefectStudy defect_study(const ResolvedCase& in, DefectRung rung, const std::function<void(double)>& progress,
                         const std::function<void(study::RingVibration&)>& disturb) {
  require_wide_scratch(in);
  const defect::ScratchedBearing scratched = scratched_bearing_of(in);
  const bearing::BearingGeometry geometry = bearing::geometry_of(scratched.bearing);
  DefectStudy study{.scratched = scratched.scratch.race,
                    .passing = defect::passing_frequencies(scratched.bearing, scratched.shaft_speed)};
  study.defect_frequency = diagnosis::defect_frequency(study.scratched, study.passing);
  study.at_rest = defect::ScratchedMotion(scratched).static_position();
  if (study.defect_frequency) {
    study.inner_depth = defect::greatest_depth(scratched.scratch.width, bearing::Race::inner, geometry);
    study.outer_depth = defect::greatest_depth(scratched.scratch.width, bearing::Race::outer, geometry);
  }
  require_few_steps(in, study.at_rest.natural_frequency);
  study.rollers = scratched.bearing.has_rollers();
  study.moving = rung == DefectRung::all;
  study.vibration = study.moving
                        ? study::sample_vibration(scratched, scratched_motion_of(in),
                                                  scratched_length_error_of(in), sampling_of(in), progress)
                        : study::sample_vibration(scratched, sampling_of(in));
  if (!study.vibration.report.completed)
    throw ComputationFailed(in.text("name") + ": " + study.vibration.report.message);
  if (disturb) disturb(study.vibration);
  study.run_up = sampling_of(in).run_up_from < 1.0;
  study.turned = study.passing;
  if (study.run_up)
    study.turned = diagnosis::slower(study.passing, study.vibration.shaft_speed / scratched.shaft_speed);
  if (study.moving)
    study.turned =
        diagnosis::as_turned(study.turned, scratched.bearing.element_count(), study.vibration.cage_speed);
  study.view = diagnosis::bearing_view(study.vibration.acceleration.row(0).transpose(),
                                       {.rate = study.vibration.rate,
                                        .band = stated_band_of(in),
                                        .angle = study.run_up ? &study.vibration.shaft_angle : nullptr},
                                       study.at_rest.natural_frequency, study.scratched, study.rollers,
                                       study.passing, study.turned);
  warn(in, study);
  return study;
}

std::vector<Derived> defect_quantities(const ResolvedCase& in) {
  const defect::ScratchedBearing scratched = scratched_bearing_of(in);
  const defect::PassingFrequencies passing =
      defect::passing_frequencies(scratched.bearing, scratched.shaft_speed);
  const defect::StaticPosition at_rest = defect::ScratchedMotion(scratched).static_position();
  return {{"defect.shaft_frequency", passing.shaft, "Hz", "turns of the shaft"},
          {"defect.cage_frequency", passing.cage, "Hz", "turns of the cage at pure rolling"},
          {"defect.outer_pass_frequency", passing.outer_pass, "Hz", "balls over a place of the outer race"},
          {"defect.inner_pass_frequency", passing.inner_pass, "Hz", "balls over a place of the inner race"},
          {"defect.ball_pass_frequency", passing.element_pass, "Hz", "a place of a ball over either race"},
          {"defect.static_displacement", 1e6 * at_rest.position[0], "um", "outer ring along the load"},
          {"defect.natural_frequency", at_rest.natural_frequency, "Hz",
           "outer ring along the load, about its static balance"}};
}

}  // namespace orbearing::app
