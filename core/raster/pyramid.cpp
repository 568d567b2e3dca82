#include "raster/pyramid.hpp"
#include "raster/pyramid_wide.hpp"
#include <algorithm>
#include <cmath>

namespace evil::raster {
namespace {

constexpr std::size_t kPad = 16; // pixels beyond a row's end that the loops may touch, and before its start

using Level = Pyramid::Level;
using Lines = Pyramid::Lines;

Deep deep(std::uint32_t* row, std::size_t stride) { return {row + kPad, row + stride + kPad}; }

Deep row_of(Level& level, int y) {
    return deep(level.pixels.data() + 2 * static_cast<std::size_t>(y) * level.stride, level.stride);
}

void shape(Level& level, int width, int height) {
    level.width = width, level.height = height;
    level.stride = static_cast<std::size_t>(width) + 3 * kPad;
    level.pixels.resize(2 * level.stride * static_cast<std::size_t>(height));
}

// What lies beyond a row is as its end is.
void hold_ends(std::uint32_t* row, int width) {
    std::fill_n(row - kPad, kPad, row[0]);
    std::fill_n(row + width, 2 * kPad, row[width - 1]);
}

void hold_ends(Deep row, int width) { hold_ends(row.rb, width), hold_ends(row.ga, width); }

void begin(Pyramid& pyramid, int levels, const Target& target, const Bands& bands) {
    if (pyramid.levels.size() < static_cast<std::size_t>(levels)) pyramid.levels.resize(levels);
    if (pyramid.lines.size() < static_cast<std::size_t>(bands.most)) pyramid.lines.resize(bands.most);
    const std::size_t room = static_cast<std::size_t>(target.width) + 3 * kPad;
    for (Lines& lines : pyramid.lines)
        if (lines.full.size() < room) {
            for (std::vector<Pixel>* line : {&lines.full, &lines.other}) line->resize(room);
            for (std::vector<std::uint32_t>* line : {&lines.between, &lines.glow}) line->resize(2 * room);
            lines.mask.assign(room, 255);
        }
}

// Each row of a level out of two rows of what is twice as large: `halve_row(to, low, high, band)`.
template <class HalveRow> void halve(int width, int height, Level& to, const Bands& bands, HalveRow&& halve_row) {
    shape(to, (width + 1) / 2, (height + 1) / 2);
    each_band(bands, to.width, to.height, [&](const Rows& rows, std::size_t band) {
        for (int y = rows.first; y < rows.last; ++y) {
            halve_row(row_of(to, y), 2 * y, std::min(2 * y + 1, height - 1), band);
            hold_ends(row_of(to, y), to.width);
        }
    });
}

constexpr auto kNothing = [](Deep) {};

void halve(Level& from, Level& to, const Bands& bands, Set set) {
    halve(from.width, from.height, to, bands, [&](Deep row, int low, int high, std::size_t) {
        EVIL_PICK(set, halve_row_wide)(row, row_of(from, low), row_of(from, high), to.width);
    });
}

// Level 0 is the picture's half; `then` is done to each of its rows.
template <class Then> void halve(const Target& target, Pyramid& pyramid, Then&& then, const Bands& bands, Set set) {
    const auto padded = [&](std::vector<Pixel>& line, int y) {
        std::copy_n(raster::row_of(target, y), target.width, line.data() + kPad);
        hold_ends(line.data() + kPad, target.width);
        return line.data() + kPad;
    };
    Level& to = pyramid.levels[0];
    halve(target.width, target.height, to, bands, [&](Deep row, int low, int high, std::size_t band) {
        Lines& lines = pyramid.lines[band];
        EVIL_PICK(set, halve_picture_wide)(row, padded(lines.full, low), padded(lines.other, high), to.width);
        then(row);
    });
}

// Row y of twice the size, three parts of the nearer and one of the farther of two rows.
Deep between_rows(Level& half, int y, Lines& lines, Set set) {
    const int near = y / 2, far = std::clamp(y % 2 ? near + 1 : near - 1, 0, half.height - 1);
    const Deep to = deep(lines.between.data(), half.stride), one = row_of(half, near), other = row_of(half, far);
    EVIL_PICK(set, mix_rows_wide)({to.rb - kPad, to.ga - kPad}, {one.rb - kPad, one.ga - kPad},
                                  {other.rb - kPad, other.ga - kPad}, static_cast<int>(half.stride - kPad));
    return to;
}

// What is in level `at` gives way to what is in the one below, doubled, by so many parts of 256.
void double_into(Pyramid& pyramid, int at, int share, const Bands& bands, Set set) {
    Level &to = pyramid.levels[at], &from = pyramid.levels[at + 1];
    each_band(bands, to.width, to.height, [&](const Rows& rows, std::size_t band) {
        for (int y = rows.first; y < rows.last; ++y) {
            const Deep half = between_rows(from, y, pyramid.lines[band], set);
            EVIL_PICK(set, double_row_wide)(row_of(to, y), half, to.width, share);
            hold_ends(row_of(to, y), to.width);
        }
    });
}

void add_double(Pyramid& pyramid, int at, const Bands& bands, Set set) { // the light of both
    Level &to = pyramid.levels[at], &from = pyramid.levels[at + 1];
    each_band(bands, to.width, to.height, [&](const Rows& rows, std::size_t band) {
        for (int y = rows.first; y < rows.last; ++y) {
            const Deep half = between_rows(from, y, pyramid.lines[band], set);
            EVIL_PICK(set, add_double_row_wide)(row_of(to, y), half, to.width);
            hold_ends(row_of(to, y), to.width);
        }
    });
}

// Halves level after level, from 0 on, down to one of that number at most; the number of the lowest.
int descend(Pyramid& pyramid, int to, const Bands& bands, Set set) {
    int at = 0;
    while (at < to && std::max(pyramid.levels[at].width, pyramid.levels[at].height) > 2) {
        halve(pyramid.levels[at], pyramid.levels[at + 1], bands, set);
        ++at;
    }
    return at;
}

int parts(float share) { return static_cast<int>(256.0f * share + 0.5f); }

// The glow of what is bright, at half the size: in level 0.
void glow(const Target& target, float threshold, Pyramid& pyramid, const Bands& bands, Set set) {
    const int width = (target.width + 1) / 2;
    const auto keep_bright = [&](Deep row) { EVIL_PICK(set, keep_bright_wide)(row, width, threshold); };
    halve(target, pyramid, keep_bright, bands, set);
    for (int at = descend(pyramid, kBloomLevels - 1, bands, set) - 1; at >= 0; --at)
        add_double(pyramid, at, bands, set);
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

void blur(const Target& target, float radius, Pyramid& pyramid, const Bands& bands, Set set) {
    const Depth depth = depth_of(radius);
    if (depth.levels == 0 || std::max(target.width, target.height) <= 2) return;
    begin(pyramid, depth.levels, target, bands);
    const auto share_of = [&](int step) { return step == depth.levels ? parts(depth.share) : 256; };
    halve(target, pyramid, kNothing, bands, set);
    for (int at = descend(pyramid, depth.levels - 1, bands, set) - 1; at >= 0; --at)
        double_into(pyramid, at, share_of(at + 2), bands, set);
    each_band(bands, target.width, target.height, [&](const Rows& rows, std::size_t band) {
        Lines& lines = pyramid.lines[band];
        for (int y = rows.first; y < rows.last; ++y) {
            Pixel* row = raster::row_of(target, y);
            std::copy_n(row, target.width, lines.full.data());
            const Deep half = between_rows(pyramid.levels[0], y, lines, set);
            EVIL_PICK(set, double_picture_wide)(lines.full.data(), half, target.width, share_of(1));
            std::copy_n(lines.full.data(), target.width, row);
        }
    });
}

// The bright parts at a quarter of the size, gathered along the ways to the point, in one number a pixel.
static Greys gathered(const Target& target, const draw::Shafts& shafts, Pyramid& pyramid, const Bands& bands, Set set) {
    halve(target, pyramid, kNothing, bands, set);
    halve(pyramid.levels[0], pyramid.levels[1], bands, set);
    Level& quarter = pyramid.levels[1];
    std::vector<std::uint16_t>&bright = pyramid.shafts.bright, &other = pyramid.shafts.gathered;
    const auto width = static_cast<std::size_t>(quarter.width);
    bright.resize(width * static_cast<std::size_t>(quarter.height));
    other.resize(bright.size());
    each_band(bands, quarter.width, quarter.height, [&](const Rows& rows, std::size_t) {
        std::uint16_t* value = bright.data() + width * static_cast<std::size_t>(rows.first);
        for (int y = rows.first; y < rows.last; ++y)
            for (int x = 0; x < quarter.width; ++x) {
                const std::uint32_t rb = row_of(quarter, y).rb[x], ga = row_of(quarter, y).ga[x];
                *value++ = beyond(std::max({rb & 0xffffu, rb >> 16, ga & 0xffffu}), shafts.threshold);
            }
    });
    Greys from{bright.data(), quarter.width, quarter.height};
    Greys to{other.data(), quarter.width, quarter.height};
    for (int pass = 0; pass < kShaftPasses; ++pass) {
        gather(from, to, 0.25f * shafts.from, shaft_taps(shafts.reach, pass), pyramid.shafts, bands);
        std::swap(from, to);
    }
    return from;
}

// What a row of greys adds to the picture.
static void colour_row(Deep row, const std::uint16_t* greys, int count, const Glow& glow) {
    const auto part = [](float factor, std::uint16_t grey) {
        return static_cast<std::uint32_t>(std::min(factor * static_cast<float>(grey), 255.0f * kParts));
    };
    for (int x = 0; x < count; ++x) {
        row.rb[x] = part(glow.red, greys[x]) | part(glow.blue, greys[x]) << 16;
        row.ga[x] = part(glow.green, greys[x]);
    }
}

void shine(const Target& target, const draw::Shafts& shafts, Pyramid& pyramid, const Bands& bands, Set set) {
    begin(pyramid, 2, target, bands);
    const Greys plane = gathered(target, shafts, pyramid, bands, set);
    const Glow glow = glow_of(shafts);
    Level &half = pyramid.levels[0], &quarter = pyramid.levels[1];
    each_band(bands, quarter.width, quarter.height, [&](const Rows& rows, std::size_t) {
        for (int y = rows.first; y < rows.last; ++y) {
            const std::uint16_t* greys = plane.values + static_cast<std::size_t>(y) * plane.width;
            colour_row(row_of(quarter, y), greys, quarter.width, glow);
            hold_ends(row_of(quarter, y), quarter.width);
        }
    });
    double_into(pyramid, 0, 256, bands, set);
    each_band(bands, target.width, target.height, [&](const Rows& rows, std::size_t band) {
        Lines& lines = pyramid.lines[band];
        for (int y = rows.first; y < rows.last; ++y) {
            const Deep row = between_rows(half, y, lines, set);
            EVIL_PICK(set, double_picture_wide)(lines.full.data(), row, target.width, 256);
            screen_row(set, raster::row_of(target, y), lines.full.data(), lines.mask.data(), target.width);
        }
    });
}

void finish(const Target& target, const draw::Post& post, Pyramid& pyramid, const Bands& bands, Set set) {
    begin(pyramid, kBloomLevels, target, bands);
    if (post.bloom > 0.0f) glow(target, post.threshold, pyramid, bands, set);
    const Finish all{{},
                     0,
                     post.bloom,
                     post.saturation,
                     post.vignette,
                     post.grain,
                     2.0f / static_cast<float>(target.width),
                     2.0f / static_cast<float>(target.height),
                     post.seed,
                     post.table.data()};
    each_band(bands, target.width, target.height, [&](const Rows& rows, std::size_t band) {
        Lines& lines = pyramid.lines[band];
        Finish how = all;
        for (int y = rows.first; y < rows.last; ++y) {
            how.y = y;
            if (post.bloom > 0.0f) {
                how.glow = deep(lines.glow.data(), lines.glow.size() / 2);
                EVIL_PICK(set, double_row_wide)(how.glow, between_rows(pyramid.levels[0], y, lines, set), target.width,
                                                256);
            }
            EVIL_PICK(set, finish_row_wide)(raster::row_of(target, y), target.width, how);
        }
    });
}

} // namespace evil::raster
