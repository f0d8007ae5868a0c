#include "mechanics/packs/instruction_set.hpp"

#include <cstdlib>
#include <stdexcept>

namespace orbearing::mechanics {

std::string name_of(InstructionSet set) {
  switch (set) {
    case InstructionSet::avx512:
      return "avx512";
    case InstructionSet::avx2:
      return "avx2";
    case InstructionSet::baseline:
      break;
  }
  return "baseline";
}

std::vector<InstructionSet> instruction_sets() {
  std::vector<InstructionSet> sets{InstructionSet::baseline};
#ifdef ORBEARING_HAS_AVX2
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) sets.push_back(InstructionSet::avx2);
#endif
#ifdef ORBEARING_HAS_AVX512
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    sets.push_back(InstructionSet::avx512);
#endif
  return sets;
}

InstructionSet best_instruction_set() {
  const std::vector<InstructionSet> sets = instruction_sets();
  const char* wanted = std::getenv("ORBEARING_INSTRUCTION_SET");
  if (wanted == nullptr || *wanted == '\0') return sets.back();
  for (const InstructionSet set : sets)
    if (name_of(set) == wanted) return set;
  throw std::invalid_argument("ORBEARING_INSTRUCTION_SET: found " + std::string(wanted) +
                              "; required: one that can run here, up to " + name_of(sets.back()));
}

}  // namespace orbearing::mechanics
