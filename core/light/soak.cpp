#include "light/soak.hpp"
#include <algorithm>

namespace evil::light {
namespace {

void add(Soft& sum, const Soft& one, float sign) {
    sum.red += sign * one.red, sum.green += sign * one.green;
    sum.blue += sign * one.blue, sum.air += sign * one.air;
}

Soft scaled(const Soft& one, float by) { return {one.red * by, one.green * by, one.blue * by, one.air * by}; }

// The mean over a window of `half` texels to either side, which moves along a row; beyond its ends, the end goes on.
void blur_row(const Soft* from, Soft* to, int count, int half) {
    Soft sum{};
    for (int i = -half; i <= half; ++i) add(sum, from[std::clamp(i, 0, count - 1)], 1.0f);
    const float share = 1.0f / static_cast<float>(2 * half + 1);
    for (int i = 0; i < count; ++i) {
        to[i] = scaled(sum, share);
        add(sum, from[std::min(i + half + 1, count - 1)], 1.0f);
        add(sum, from[std::max(i - half, 0)], -1.0f);
    }
}

// The same down columns first..last, a row at a time.
void blur_columns(const Soft* from, Soft* to, int width, int height, int half, int first, int last, Soft* sums) {
    const auto row = [&](int y) { return static_cast<std::size_t>(std::clamp(y, 0, height - 1)) * width; };
    const float share = 1.0f / static_cast<float>(2 * half + 1);
    std::fill(sums + first, sums + last, Soft{});
    for (int y = -half; y <= half; ++y)
        for (int x = first; x < last; ++x) add(sums[x], from[row(y) + x], 1.0f);
    for (int y = 0; y < height; ++y) {
        Soft* out = to + row(y);
        const Soft *enters = from + row(y + half + 1), *leaves = from + row(y - half);
        for (int x = first; x < last; ++x) {
            out[x] = scaled(sums[x], share);
            add(sums[x], enters[x], 1.0f);
            add(sums[x], leaves[x], -1.0f);
        }
    }
}

} // namespace

void soak(std::span<Soft> texels, std::span<const std::uint8_t> solid, int width, int height, int reach,
          std::vector<Soft>& blurred, std::vector<Soft>& other, Threads& threads) {
    const int half = std::max(1, (reach + 1) / 2); // two passes reach twice as far, and fade as a parabola does
    const auto rows = static_cast<std::size_t>(height), columns = static_cast<std::size_t>(width);
    blurred.resize(texels.size() + columns); // and a row for sums
    other.resize(texels.size());
    const Soft* from = texels.data();
    for (int pass = 0; pass < 2; ++pass) {
        parallel_for(threads, rows, 16, [&](std::size_t first, std::size_t last) {
            for (std::size_t y = first; y < last; ++y) blur_row(from + y * columns, &other[y * columns], width, half);
        });
        parallel_for(threads, columns, 64, [&](std::size_t first, std::size_t last) {
            blur_columns(other.data(), blurred.data(), width, height, half, static_cast<int>(first),
                         static_cast<int>(last), blurred.data() + texels.size());
        });
        from = blurred.data();
    }
    for (std::size_t i = 0; i < texels.size(); ++i)
        if (solid[i]) texels[i] = scaled(blurred[i], 1.0f / std::max(blurred[i].air, 0.5f));
}

} // namespace evil::light
