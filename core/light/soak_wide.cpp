#include "light/soak_wide.hpp"
#include "math/wide.hpp"

namespace evil::EVIL_ISA {

void move_windows_wide(float* means, float* sums, const float* enters, const float* leaves, float share,
                       int count) noexcept {
    for (int i = 0; i < count; i += kLanes) {
        const Floats sum = load(sums + i);
        store(means + i, sum * share);
        store(sums + i, sum + load(enters + i) - load(leaves + i));
    }
}

} // namespace evil::EVIL_ISA
