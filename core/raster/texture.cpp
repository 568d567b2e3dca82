#include "raster/texture.hpp"
#include "raster/spans.hpp"
#include <algorithm>

namespace evil::raster {
namespace {

// Which texels of `size` make up texel `at` of half = max(1, size / 2), and how much of each: for an odd size, three share.
struct Share {
    int first = 0;
    std::uint32_t weight[3] = {};
    std::uint32_t total = 1;
};

Share share(int at, int half, int size) {
    if (size == 1) return {0, {1, 0, 0}, 1};
    const auto n = static_cast<std::uint32_t>(half), i = static_cast<std::uint32_t>(at);
    if (size % 2 == 0) return {2 * at, {1, 1, 0}, 2};
    return {2 * at, {n - i, n, i + 1}, 2 * n + 1};
}

// The mean of four, each channel to the nearest.
Pixel mean_of_four(const Pixel* above, const Pixel* below) {
    constexpr Pixel kEven = 0x00ff00ffu, kTwo = 0x00020002u;
    const auto sum = [&](int shift) {
        return (above[0] >> shift & kEven) + (above[1] >> shift & kEven) + (below[0] >> shift & kEven) +
               (below[1] >> shift & kEven) + kTwo;
    };
    return (sum(0) >> 2 & kEven) | (sum(8) >> 2 & kEven) << 8;
}

Picture halved(const Picture& from) {
    Picture to{std::max(1, from.width / 2), std::max(1, from.height / 2), {}};
    to.texels.resize(static_cast<std::size_t>(to.width) * static_cast<std::size_t>(to.height));
    if (from.width % 2 == 0 && from.height % 2 == 0) { // by far the most
        for (int y = 0; y < to.height; ++y) {
            const Pixel* row = from.texels.data() + static_cast<std::size_t>(2 * y) * from.width;
            Pixel* out = to.texels.data() + static_cast<std::size_t>(y) * to.width;
            for (int x = 0; x < to.width; ++x) out[x] = mean_of_four(row + 2 * x, row + from.width + 2 * x);
        }
        return to;
    }
    for (int y = 0; y < to.height; ++y) {
        const Share rows = share(y, to.height, from.height);
        for (int x = 0; x < to.width; ++x) {
            const Share columns = share(x, to.width, from.width);
            const std::uint64_t total = std::uint64_t{rows.total} * columns.total;
            std::uint64_t sum[4] = {total / 2, total / 2, total / 2, total / 2};
            for (int j = 0; j < 3; ++j) {
                if (rows.weight[j] == 0) continue;
                const Pixel* texel = from.texels.data() + static_cast<std::size_t>(rows.first + j) * from.width;
                for (int i = 0; i < 3; ++i) {
                    if (columns.weight[i] == 0) continue;
                    const std::uint64_t weight = std::uint64_t{rows.weight[j]} * columns.weight[i];
                    for (int c = 0; c < 4; ++c) sum[c] += weight * (texel[columns.first + i] >> (8 * c) & 255u);
                }
            }
            Pixel mean = 0;
            for (int c = 0; c < 4; ++c) mean |= static_cast<Pixel>(sum[c] / total) << (8 * c);
            to.texels[static_cast<std::size_t>(y) * to.width + x] = mean;
        }
    }
    return to;
}

} // namespace

Texture make_texture(const std::uint8_t* straight, int width, int height) {
    Texture texture;
    Picture full{width, height, {}};
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    full.texels.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint8_t* p = straight + 4 * i;
        const Pixel pixel = Pixel{p[0]} | Pixel{p[1]} << 8 | Pixel{p[2]} << 16 | Pixel{p[3]} << 24;
        full.texels[i] = p[3] == 255 ? pixel : premultiply(pixel);
    }
    texture.levels.push_back(std::move(full));
    while (texture.levels.back().width > 1 || texture.levels.back().height > 1)
        texture.levels.push_back(halved(texture.levels.back()));
    return texture;
}

Box seen_part(const Picture& picture) {
    Box seen{picture.width, picture.height, 0, 0};
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            if (picture.texels[static_cast<std::size_t>(y) * picture.width + x] == 0) continue;
            seen = {std::min(seen.left, x), std::min(seen.top, y), std::max(seen.right, x + 1), y + 1};
        }
    return seen.right > 0 ? seen : Box{};
}

bool corners_are_clear(const Picture& picture) {
    for (const int row : {0, 1, picture.height - 2, picture.height - 1})
        for (const int column : {0, 1, picture.width - 2, picture.width - 1}) {
            const int x = std::clamp(column, 0, picture.width - 1), y = std::clamp(row, 0, picture.height - 1);
            if (picture.texels[static_cast<std::size_t>(y) * picture.width + x] != 0) return false;
        }
    return true;
}

} // namespace evil::raster
