#include "math/cpu.hpp"

namespace evil {
namespace {

#if defined(EVIL_HAS_AVX2)
constexpr InstructionSet kSets[] = {InstructionSet::plain, InstructionSet::sse2, InstructionSet::avx2};
bool has_avx2() noexcept {
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi2"); // asks the operating system as well
}
#else
constexpr InstructionSet kSets[] = {InstructionSet::base};
#endif

} // namespace

const char* name(InstructionSet set) noexcept {
    switch (set) {
    case InstructionSet::plain:
        return "plain";
    case InstructionSet::base:
        return "base";
    case InstructionSet::sse2:
        return "sse2";
    case InstructionSet::avx2:
        return "avx2";
    }
    return "unknown";
}

std::span<const InstructionSet> runnable_instruction_sets() noexcept {
    std::span<const InstructionSet> sets = kSets;
#if defined(EVIL_HAS_AVX2)
    static const bool wide = has_avx2();
    if (!wide) sets = sets.first(2);
#endif
    return sets;
}

InstructionSet best_instruction_set() noexcept { return runnable_instruction_sets().back(); }

} // namespace evil
