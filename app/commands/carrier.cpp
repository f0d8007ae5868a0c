#include "app/commands/carrier.hpp"

#include "app/case/unused_inputs.hpp"
#include "app/commands/kept_result.hpp"
#include "app/commands/presentation.hpp"
#include "app/study/carrier_study.hpp"
#include "app/study/drivetrain_case.hpp"

namespace orbearing::app {

int execute(const CarrierOptions& options) {
  const ResolvedCase resolved = point_of(options.stated);
  require_carrier(resolved);
  const std::vector<std::string> unused =
      require_used(resolved, AnalysisId::carrier);  // refuses before it computes
  const Record record = record_of(carrier_study(resolved));
  present_record(resolved, record, joined(unused, gear_warnings(resolved)), options.print);
  return 0;
}

}  // namespace orbearing::app
