#include "math/rotations_wide.hpp"
#include "math/sincos.hpp"

namespace evil::EVIL_ISA {
namespace {

constexpr std::size_t kAtOnce = 8; // that the compiler makes a few wide instructions of

bool reduces(const double* angles) {
    bool all = true;
    for (std::size_t i = 0; i < kAtOnce; ++i)
        all &= (angles[i] <= series::kLargestReduced) & (angles[i] >= -series::kLargestReduced);
    return all;
}

} // namespace

void rotations(const double* angles, std::size_t count, Rot* out) noexcept {
    std::size_t done = 0;
    for (; done + kAtOnce <= count && reduces(angles + done); done += kAtOnce) {
        float c[kAtOnce], s[kAtOnce];
        for (std::size_t i = 0; i < kAtOnce; ++i) {
            SinCos f = series::sincos_reduced(angles[done + i]);
            c[i] = f.cos;
            s[i] = f.sin;
        }
        for (std::size_t i = 0; i < kAtOnce; ++i) out[done + i] = {c[i], s[i]};
    }
    for (; done < count; ++done) {
        SinCos f = sincos(angles[done]);
        out[done] = {f.cos, f.sin};
    }
}

} // namespace evil::EVIL_ISA
