#include "fluid/water/press_wide.hpp"
#include "math/wide.hpp"

namespace evil::EVIL_ISA {

using fluid::PressView;
using fluid::Tile;

namespace {

EVIL_INLINE float sum_of(Floats lanes) {
    float all[kLanes];
    store(all, lanes);
    return ((all[0] + all[4]) + (all[2] + all[6])) + ((all[1] + all[5]) + (all[3] + all[7]));
}

EVIL_INLINE Floats from_neighbours(const PressView& v, const float* p, std::ptrdiff_t at) {
    return (load(v.left + at) * load(p + at - 1) + load(v.right + at) * load(p + at + 1)) +
           (load(v.below + at) * load(p + at - v.stride) + load(v.above + at) * load(p + at + v.stride));
}

EVIL_INLINE Mask of_colour(const Tile& tile, int colour) { // tiles begin at even columns
    return ((lane_numbers() + Ints(tile.j + colour)) & Ints(1)) == Ints(0);
}

} // namespace

void press_start(const PressView& v) noexcept {
    for (std::size_t k = 0; k < v.count; ++k) {
        const Tile& tile = v.tiles[k];
        const Floats z = load(v.inverse + tile.at) * load(v.b + tile.at);
        store(v.z + tile.at, select(of_colour(tile, 0), z, Floats(0.0f)));
    }
}

void press_relax(const PressView& v, int colour) noexcept {
    for (std::size_t k = 0; k < v.count; ++k) {
        const Tile& tile = v.tiles[k];
        const Floats z = load(v.inverse + tile.at) * (load(v.b + tile.at) + from_neighbours(v, v.z, tile.at));
        store(v.z + tile.at, select(of_colour(tile, colour), z, load(v.z + tile.at)));
    }
}

void press_restrict(const PressView& fine, const PressView& coarse) noexcept {
    for (std::size_t k = 0; k < coarse.count; ++k) {
        const Tile& tile = coarse.tiles[k];
        const std::ptrdiff_t low = std::ptrdiff_t{2} * tile.j * fine.stride + 2 * tile.i;
        float left[2 * kLanes];
        for (int half = 0; half < 2; ++half) {
            Floats sum(0.0f);
            for (std::ptrdiff_t at : {low + half * kLanes, low + half * kLanes + fine.stride})
                sum +=
                    load(fine.b + at) - (load(fine.total + at) * load(fine.z + at) - from_neighbours(fine, fine.z, at));
            store(left + half * kLanes, sum);
        }
        for (int i = 0; i < kLanes; ++i) coarse.b[tile.at + i] = left[2 * i] + left[2 * i + 1];
    }
}

void press_prolong(const PressView& coarse, const PressView& fine) noexcept {
    for (std::size_t k = 0; k < coarse.count; ++k) {
        const Tile& tile = coarse.tiles[k];
        const std::ptrdiff_t low = std::ptrdiff_t{2} * tile.j * fine.stride + 2 * tile.i;
        float both[2 * kLanes];
        for (int i = 0; i < kLanes; ++i) both[2 * i] = both[2 * i + 1] = coarse.z[tile.at + i];
        for (int half = 0; half < 2; ++half)
            for (std::ptrdiff_t at : {low + half * kLanes, low + half * kLanes + fine.stride}) {
                const Floats more = select(load(fine.inverse + at) > 0.0f, load(both + half * kLanes), Floats(0.0f));
                store(fine.z + at, load(fine.z + at) + more);
            }
    }
}

float press_apply(const PressView& v, const float* p, float* result) noexcept {
    Floats sum(0.0f);
    for (std::size_t k = 0; k < v.count; ++k) {
        const std::ptrdiff_t at = v.tiles[k].at;
        const Floats here = load(p + at), image = load(v.total + at) * here - from_neighbours(v, p, at);
        store(result + at, image);
        sum += here * image;
    }
    return sum_of(sum);
}

float press_dot(const PressView& v, const float* p, const float* q) noexcept {
    Floats sum(0.0f);
    for (std::size_t k = 0; k < v.count; ++k) sum += load(p + v.tiles[k].at) * load(q + v.tiles[k].at);
    return sum_of(sum);
}

float press_advance(const PressView& v, float step, const float* search, const float* image, float* p) noexcept {
    Floats sum(0.0f);
    for (std::size_t k = 0; k < v.count; ++k) {
        const std::ptrdiff_t at = v.tiles[k].at;
        store(p + at, load(p + at) + Floats(step) * load(search + at));
        const Floats b = load(v.b + at) - Floats(step) * load(image + at);
        store(v.b + at, b);
        sum += b * b;
    }
    return sum_of(sum);
}

void press_turn(const PressView& v, float keep, float* search) noexcept {
    for (std::size_t k = 0; k < v.count; ++k) {
        const std::ptrdiff_t at = v.tiles[k].at;
        store(search + at, load(v.z + at) + Floats(keep) * load(search + at));
    }
}

} // namespace evil::EVIL_ISA
