#include "raster/pyramid.hpp"
#include "raster/pyramid_wide.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace evil::raster {
namespace {

constexpr std::size_t kPad = 16; // pixels beyond a row's end that the loops may touch, and before its start

using Level = Pyramid::Level;

Pixel* row_of(Level& level, int y) { return level.pixels.data() + static_cast<std::size_t>(y) * level.stride + kPad; }

void shape(Level& level, int width, int height) {
    level.width = width, level.height = height;
    level.stride = static_cast<std::size_t>(width) + 3 * kPad;
    level.pixels.resize(level.stride * static_cast<std::size_t>(height));
}

// What lies beyond a row is as its end is.
void hold_ends(Level& level, int y) {
    Pixel* row = row_of(level, y);
    std::fill_n(row - kPad, kPad, row[0]);
    std::fill_n(row + level.width, 2 * kPad, row[level.width - 1]);
}

void copy_in(Level& level, const Target& target) {
    shape(level, target.width, target.height);
    for (int y = 0; y < target.height; ++y) {
        std::copy_n(raster::row_of(target, y), target.width, row_of(level, y));
        hold_ends(level, y);
    }
}

void copy_out(Level& level, const Target& target) {
    for (int y = 0; y < target.height; ++y) std::copy_n(row_of(level, y), target.width, raster::row_of(target, y));
}

void halve(Level& from, Level& to, Set set) {
    shape(to, (from.width + 1) / 2, (from.height + 1) / 2);
    for (int y = 0; y < to.height; ++y) {
        const int low = 2 * y, high = std::min(low + 1, from.height - 1);
        EVIL_PICK(set, halve_row_wide)(row_of(to, y), row_of(from, low), row_of(from, high), to.width);
        hold_ends(to, y);
    }
}

// Rows y of twice the size, three parts of the nearer and one of the farther: into `row`.
const Pixel* between_rows(Level& half, int y, std::vector<Pixel>& row, Set set) {
    const int near = y / 2, far = std::clamp(y % 2 ? near + 1 : near - 1, 0, half.height - 1);
    row.resize(half.stride);
    EVIL_PICK(set, mix_rows_wide)(row.data(), row_of(half, near) - kPad, row_of(half, far) - kPad,
                                  static_cast<int>(half.stride - kPad));
    return row.data() + kPad;
}

// What is in `to` gives way to what is in `from`, doubled, by so many parts of 256.
void double_into(Level& to, Level& from, int share, std::vector<Pixel>& row, Set set) {
    for (int y = 0; y < to.height; ++y) {
        EVIL_PICK(set, double_row_wide)(row_of(to, y), between_rows(from, y, row, set), to.width, share);
        hold_ends(to, y);
    }
}

void add_double(Level& to, Level& from, std::vector<Pixel>& row, Set set) { // the light of both
    for (int y = 0; y < to.height; ++y) {
        EVIL_PICK(set, add_double_row_wide)(row_of(to, y), between_rows(from, y, row, set), to.width);
        hold_ends(to, y);
    }
}

// Halves level after level, from one on; the number of the lowest.
int descend(Pyramid& pyramid, int from, int to, Set set) {
    int at = from;
    while (at < to && std::max(pyramid.levels[at].width, pyramid.levels[at].height) > 2) {
        halve(pyramid.levels[at], pyramid.levels[at + 1], set);
        ++at;
    }
    return at;
}

void make_levels(Pyramid& pyramid, int count) {
    if (pyramid.levels.size() < static_cast<std::size_t>(count)) pyramid.levels.resize(count);
}

int parts(float share) { return static_cast<int>(256.0f * share + 0.5f); }

// The glow of what is bright, at half the size: in level 1.
void glow(const Target& target, float threshold, Pyramid& pyramid, Set set) {
    make_levels(pyramid, kBloomLevels + 1);
    copy_in(pyramid.levels[0], target);
    Level& first = pyramid.levels[1];
    halve(pyramid.levels[0], first, set);
    for (int y = 0; y < first.height; ++y) {
        EVIL_PICK(set, keep_bright_wide)(row_of(first, y), first.width, threshold);
        hold_ends(first, y);
    }
    const int lowest = descend(pyramid, 1, kBloomLevels, set);
    for (int at = lowest - 1; at >= 1; --at) add_double(pyramid.levels[at], pyramid.levels[at + 1], pyramid.row, set);
}

} // namespace

Depth depth_of(float radius) {
    Depth depth;
    float reach = 1.0f + std::clamp(radius, 0.0f, 4096.0f); // each level doubles how far a pixel is spread
    while (reach > 1.0f) {
        depth.share = std::min(reach, 2.0f) - 1.0f;
        reach *= 0.5f;
        ++depth.levels;
    }
    return depth;
}

void blur(const Target& target, float radius, Pyramid& pyramid, Set set) {
    const Depth depth = depth_of(radius);
    if (depth.levels == 0) return;
    make_levels(pyramid, depth.levels + 1);
    copy_in(pyramid.levels[0], target);
    const int lowest = descend(pyramid, 0, depth.levels, set);
    for (int at = lowest - 1; at >= 0; --at)
        double_into(pyramid.levels[at], pyramid.levels[at + 1], at == depth.levels - 1 ? parts(depth.share) : 256,
                    pyramid.row, set);
    copy_out(pyramid.levels[0], target);
}

// The bright parts at a quarter of the size, gathered along the ways to the point, in one number a pixel.
static Greys gathered(const Target& target, const draw::Shafts& shafts, Pyramid& pyramid, Set set) {
    make_levels(pyramid, 3);
    copy_in(pyramid.levels[0], target);
    halve(pyramid.levels[0], pyramid.levels[1], set);
    halve(pyramid.levels[1], pyramid.levels[2], set);
    Level& quarter = pyramid.levels[2];
    std::vector<std::uint8_t>&bright = pyramid.shafts.bright, &other = pyramid.shafts.gathered;
    bright.resize(static_cast<std::size_t>(quarter.width) * static_cast<std::size_t>(quarter.height));
    other.resize(bright.size());
    std::array<std::uint8_t, 256> shares;
    for (int channel = 0; channel < 256; ++channel) shares[channel] = beyond(channel, shafts.threshold);
    std::uint8_t* value = bright.data();
    for (int y = 0; y < quarter.height; ++y)
        for (const Pixel pixel : std::span(row_of(quarter, y), static_cast<std::size_t>(quarter.width)))
            *value++ = shares[std::max({pixel & 255u, pixel >> 8 & 255u, pixel >> 16 & 255u})];
    Greys from{bright.data(), quarter.width, quarter.height};
    Greys to{other.data(), quarter.width, quarter.height};
    for (int pass = 0; pass < kShaftPasses; ++pass) {
        gather(from, to, 0.25f * shafts.from, shaft_taps(shafts.reach, pass), pyramid.shafts);
        std::swap(from, to);
    }
    return from;
}

void shine(const Target& target, const draw::Shafts& shafts, Pyramid& pyramid, Set set) {
    const Greys plane = gathered(target, shafts, pyramid, set);
    const Glow glow = glow_of(shafts);
    std::array<Pixel, 256> colours;
    for (int value = 0; value < 256; ++value) {
        const auto part = [&](float factor) {
            return static_cast<Pixel>(std::min(factor * static_cast<float>(value) + 0.5f, 255.0f));
        };
        colours[value] = part(glow.red) | part(glow.green) << 8 | part(glow.blue) << 16;
    }
    Level &half = pyramid.levels[1], &quarter = pyramid.levels[2];
    for (int y = 0; y < quarter.height; ++y) {
        const std::uint8_t* values = plane.values + static_cast<std::size_t>(y) * plane.width;
        for (int x = 0; x < quarter.width; ++x) row_of(quarter, y)[x] = colours[values[x]];
        hold_ends(quarter, y);
    }
    double_into(half, quarter, 256, pyramid.row, set);
    pyramid.other.resize(static_cast<std::size_t>(target.width) + 2 * kPad);
    pyramid.mask.assign(static_cast<std::size_t>(target.width) + kPad, 255);
    for (int y = 0; y < target.height; ++y) {
        const Pixel* row = between_rows(half, y, pyramid.row, set);
        EVIL_PICK(set, double_row_wide)(pyramid.other.data(), row, target.width, 256);
        screen_row(set, raster::row_of(target, y), pyramid.other.data(), pyramid.mask.data(), target.width);
    }
}

void finish(const Target& target, const draw::Post& post, Pyramid& pyramid, Set set) {
    if (post.bloom > 0.0f) glow(target, post.threshold, pyramid, set);
    Finish how{nullptr,
               0,
               post.bloom,
               post.saturation,
               post.vignette,
               post.grain,
               2.0f / static_cast<float>(target.width),
               2.0f / static_cast<float>(target.height),
               post.seed,
               post.table.data()};
    pyramid.other.resize(static_cast<std::size_t>(target.width) + 2 * kPad);
    for (int y = 0; y < target.height; ++y) {
        how.y = y;
        if (post.bloom > 0.0f) {
            const Pixel* half = between_rows(pyramid.levels[1], y, pyramid.row, set);
            EVIL_PICK(set, double_row_wide)(pyramid.other.data(), half, target.width, 256);
            how.glow = pyramid.other.data();
        }
        EVIL_PICK(set, finish_row_wide)(raster::row_of(target, y), target.width, how);
    }
}

} // namespace evil::raster
