#include "gpu/liquid_wide.hpp"
#include "math/wide.hpp"

namespace evil::EVIL_ISA {

static EVIL_INLINE Ints to_half(const float* from) {
    const Ints bits = float_to_bits(clamp(load(from), -60000.0f, 60000.0f));
    const Ints size = (bits & 0x7fffffff) + 0x1000, sign = shift_right_unsigned(bits, 16) & 0x8000;
    return sign | select(size < Ints(0x38800000), Ints(0), shift_right_unsigned(size - 0x38000000, 13));
}

void pack_halves_wide(const float* const planes[4], std::uint16_t* to, int count) noexcept {
    for (int i = 0; i < count; i += kLanes) {
        const Ints low = to_half(planes[0] + i) | (to_half(planes[1] + i) << 16);
        const Ints high = to_half(planes[2] + i) | (to_half(planes[3] + i) << 16);
        store_pairs(reinterpret_cast<float*>(to + 4 * i), bits_to_float(low), bits_to_float(high));
    }
}

} // namespace evil::EVIL_ISA
