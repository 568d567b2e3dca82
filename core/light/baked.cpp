#include "light/baked.hpp"
#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace evil::light {
namespace {

// One row takes over another that is `across` texels further right.
void take_over(float* to, const float* from, int across, int count) {
    const int kept = count - std::abs(across);
    std::memmove(to + std::max(-across, 0), from + std::max(across, 0), static_cast<std::size_t>(kept) * sizeof(float));
    std::fill_n(across > 0 ? to + kept : to, std::abs(across), kUnknown);
}

void scroll(Baked& baked, int across, int down) {
    const int count = baked.stride;
    const auto row = [&](int y) { return baked.shares.data() + static_cast<std::size_t>(y) * baked.stride; };
    for (int i = 0; i < baked.height; ++i) {
        const int y = down >= 0 ? i : baked.height - 1 - i; // rows are read before they are written
        if (y + down >= 0 && y + down < baked.height)
            take_over(row(y), row(y + down), across, count);
        else
            std::fill_n(row(y), count, kUnknown);
    }
}

} // namespace

void move_to(Baked& baked, const BakedOf& of, int left, int top, int stride, int height) {
    const std::int64_t across = std::int64_t{left} - baked.left, down = std::int64_t{top} - baked.top;
    const bool same = baked.of == of && baked.stride == stride && baked.height == height;
    if (!same || std::abs(across) >= stride || std::abs(down) >= height) {
        baked.stride = stride, baked.height = height;
        baked.shares.assign(static_cast<std::size_t>(stride) * height, kUnknown);
    } else if (across != 0 || down != 0) {
        scroll(baked, static_cast<int>(across), static_cast<int>(down));
    }
    baked.of = of, baked.left = left, baked.top = top;
}

} // namespace evil::light
