// Which vector instructions this program may use here.
#pragma once

// Compiled sets in addition to the baseline; CMake's ORBEARING_AVX512=OFF leaves the widest out.
#if defined(__x86_64__) && !defined(_WIN32)
#define ORBEARING_HAS_AVX2
#ifndef ORBEARING_WITHOUT_AVX512
#define ORBEARING_HAS_AVX512
#endif
#endif

#include <string>
#include <vector>

namespace orbearing::mechanics {

/// Instruction sets for which this program holds a version, narrowest first.
enum class InstructionSet { baseline, avx2, avx512 };

/// "baseline", "avx2", "avx512".
std::string name_of(InstructionSet set);

/// All sets that can run here, narrowest first.
std::vector<InstructionSet> instruction_sets();

/// The widest set that can run here; ORBEARING_INSTRUCTION_SET in the environment holds it at a narrower one.
/// Throws std::invalid_argument where that names none that can run here.
InstructionSet best_instruction_set();

}  // namespace orbearing::mechanics
