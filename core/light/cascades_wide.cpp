// Rows of rays, eight cells at a time. Rows have room for the last eight, whatever they hold beyond their end.
#include "light/cascades_wide.hpp"
#include "light/cascades.hpp"
#include "math/wide.hpp"

namespace evil::EVIL_ISA {
namespace {

// Cells i..i + 7 of a row of `count`; `outside` for those that it has not, where it is not said to have all.
template <bool all> EVIL_INLINE Floats look(const float* row, int i, int count, float outside) {
    if (all || (i >= 0 && i + kLanes <= count)) return load(row + i);
    if (i + kLanes <= 0 || i >= count) return outside;
    float lanes[kLanes];
    for (int lane = 0; lane < kLanes; ++lane) lanes[lane] = i + lane >= 0 && i + lane < count ? row[i + lane] : outside;
    return load(lanes);
}

struct Part { // of a row: where eight cells at a time have all that they look at
    int from, to;
};

EVIL_INLINE void narrow(Part& part, const float* far, int shift, int count) {
    if (!far) part.to = part.from;
    if (part.from + shift < 0) part.from = -shift;
    if (part.to + kLanes + shift > count + 1) part.to = count + 1 - kLanes - shift;
}

// Calls f for every eighth cell, saying whether it is in that part.
template <class F> EVIL_INLINE void each_block(const Part& part, int count, F f) {
    int i = 0;
    for (; i < count && i < part.from; i += kLanes) f.template operator()<false>(i);
    for (; i < count && i < part.to; i += kLanes) f.template operator()<true>(i);
    for (; i < count; i += kLanes) f.template operator()<false>(i);
}

struct Rays {
    Floats through, light[3];
};

template <bool all> EVIL_INLINE Rays join(const light::Pair& pair, int i, int count, std::size_t stride) {
    const float *near = pair.near + i, *far = pair.far;
    Rays rays{load(near), {load(near + stride), load(near + 2 * stride), load(near + 3 * stride)}};
    if (!all && !far) return rays;
    for (int c = 0; c < 3; ++c)
        rays.light[c] += rays.through * look<all>(far + (c + 1) * stride, i + pair.shift, count, 0.0f);
    rays.through *= look<all>(far, i + pair.shift, count, 1.0f);
    return rays;
}

EVIL_INLINE void put(const Rays& rays, std::size_t stride, float* to) {
    store(to, rays.through);
    for (int c = 0; c < 3; ++c) store(to + (c + 1) * stride, rays.light[c]);
}

template <bool all>
EVIL_INLINE void add_way(Floats* sum, const light::Way& way, const light::Surround& surround, int i, int count,
                         std::size_t stride) {
    const float* far = way.far;
    const auto end = [&](int c) {
        const float sky = surround.sky[c] * way.angle;
        return all || far ? look<all>(far + c * stride, i + way.shift, count, sky) : Floats(sky);
    };
    if (!way.near) {
        for (int c = 0; c < 3; ++c) sum[c] += end(c) * way.weight;
        return;
    }
    const float* near = way.near + i;
    const float share = way.angle * way.weight;
    Floats through = load(near), blocked = (Floats(1.0f) - through) * share, rest = through * way.weight;
    for (int c = 0; c < 3; ++c)
        sum[c] += load(near + (c + 1) * stride) * share + blocked * surround.fill[c] + rest * end(c);
}

template <int count_of_ways>
EVIL_INLINE void gather(const light::Way* ways, const light::Surround& surround, int count, std::size_t stride,
                        float* to) {
    Part part{0, count};
    for (int w = 0; w < count_of_ways; ++w) narrow(part, ways[w].far, ways[w].shift, count);
    each_block(part, count, [&]<bool all>(int i) {
        Floats sum[3] = {0.0f, 0.0f, 0.0f};
        for (int w = 0; w < count_of_ways; ++w) add_way<all>(sum, ways[w], surround, i, count, stride);
        for (int c = 0; c < 3; ++c) store(to + c * stride + i, sum[c]);
    });
}

} // namespace

// A ray is blocked by a solid cell that it ends in, or by two whose corner it would slip through.
void first_rays_wide(const light::FirstRays& rays, int count, std::size_t stride, float* to) noexcept {
    using light::Cells;
    for (int i = 0; i < count; i += kLanes) {
        const float *start = rays.from + i, *beside = start + rays.shift, *ahead = rays.to + i,
                    *end = ahead + rays.shift;
        Floats hit = load(end), corner = load(ahead) * load(beside) * (Floats(1.0f) - hit);
        Floats air = Floats(1.0f) - load(start);
        Rays met{Floats(1.0f) - hit - corner, {}};
        for (int c = 0; c < 3; ++c) {
            const std::size_t colour = (Cells::colour + c) * rays.plane;
            met.light[c] = air * load(start + colour) * (hit * load(end + colour) + corner * load(ahead + colour));
            if (!rays.glows) continue;
            const std::size_t glow = (Cells::glow + c) * rays.plane;
            met.light[c] += load(end + glow) + corner * load(ahead + glow);
        }
        put(met, stride, to + i);
    }
}

void join_rays_wide(const light::Pair* pairs, int pair_count, int count, std::size_t stride, float* to) noexcept {
    Part part{0, count};
    for (int i = 0; i < pair_count; ++i) narrow(part, pairs[i].far, pairs[i].shift, count);
    each_block(part, count, [&]<bool all>(int i) {
        Rays rays = join<all>(pairs[0], i, count, stride);
        if (pair_count == 2) {
            Rays other = join<all>(pairs[1], i, count, stride);
            rays.through = (rays.through + other.through) * 0.5f;
            for (int c = 0; c < 3; ++c) rays.light[c] = (rays.light[c] + other.light[c]) * 0.5f;
        }
        put(rays, stride, to + i);
    });
}

void gather_rays_wide(const light::Way* ways, int way_count, const light::Surround& surround, int count,
                      std::size_t stride, float* to) noexcept {
    way_count == 2 ? gather<2>(ways, surround, count, stride, to) : gather<4>(ways, surround, count, stride, to);
}

} // namespace evil::EVIL_ISA
