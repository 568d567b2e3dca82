#include "light/shading.hpp"
#include "light/shade_wide.hpp"
#include <algorithm>

namespace evil::light {
namespace {

bool reaches(const Lamp& lamp, Vec2 middle, float radius) {
    if (lamp.parallel) return true;
    return length(middle - lamp.at) < lamp.reach + radius;
}

bool all_solid(const Field& field, const Patch& patch) {
    for (int y = patch.y; y < patch.y + patch.rows; ++y)
        for (int x = patch.x; x < patch.x + kPatch; ++x)
            if (!field.solid[static_cast<std::size_t>(y) * patch.stride + x]) return false;
    return true;
}

// One lamp on one square of a map.
struct Work {
    Block& block;
    const Cast& cast;
    const Field& field;
    const Planes& to;
    InstructionSet set;

    Patch patch_of(const Square& square) const {
        return {square.x, square.y, std::min(kPatch, field.height - square.y), field.stride};
    }
    bool is_needed(const Square& square) const {
        if (square.x >= field.width || square.y >= field.height) return false;
        if (!reaches(cast.lamp, square.middle(), square.radius())) return false;
        return square.side > kPatch || !all_solid(field, patch_of(square));
    }
    Near near_of(const std::vector<std::uint32_t>& which) const {
        if (block.hiding.hidden.size() < which.size()) block.hiding.hidden.resize(which.size());
        return {field.casters.rows.data(), field.casters.corners.data(), which.data(), static_cast<int>(which.size()),
                block.hiding.hidden.data()};
    }
    Shares own() const { return {block.shares, kPatch}; }
    std::span<const std::uint32_t> moving() const { return std::span(cast.casters).first(cast.moving); }
    std::span<const std::uint32_t> standing() const { return std::span(cast.casters).subspan(cast.moving); }

    // Calls lit(patch, casters) for the patches of a square that light may fall on, with those of `among` that matter
    // there, and dark(square) for squares that they keep all light from: from each quarter to its quarters.
    template <class Lit, class Dark>
    void divide(const Square& square, std::size_t depth, std::span<const std::uint32_t> among, Lit&& lit,
                Dark&& dark) const {
        if (!is_needed(square)) return;
        std::vector<std::uint32_t>& near = block.hiding.lists[depth];
        if (!find_what_matters(near, block.hiding, among, cast.lamp, field.casters.rows, field.casters.corners, square,
                               set))
            return dark(square);
        if (square.side == kPatch) return lit(patch_of(square), near);
        const int side = square.side / 2;
        for (int quarter = 0; quarter < 4; ++quarter)
            divide({square.x + quarter % 2 * side, square.y + quarter / 2 * side, side}, depth + 1, near, lit, dark);
    }
    template <class F> void each_patch(const Square& square, F&& f) const {
        for (int y = square.y; y < std::min(square.y + square.side, field.height); y += kPatch)
            for (int x = square.x; x < std::min(square.x + square.side, field.width); x += kPatch)
                f(Square{x, y, kPatch});
    }

    void add(const Patch& patch, const Shares& shares) const {
        const bool veiled = !cast.veil.shares.empty() && put_veil(cast.veil, patch, shares, block.veiled);
        EVIL_PICK(set, light_patch_wide)(cast.lamp, patch, veiled ? Shares{block.veiled, kPatch} : shares, to);
    }
    void shade(const Square& square) const {
        divide(
            square, 0, cast.casters,
            [&](const Patch& patch, const std::vector<std::uint32_t>& near) {
                EVIL_PICK(set, shade_patch_wide)(cast.lamp, near_of(near), patch, own());
                add(patch, own());
            },
            [](const Square&) {});
    }

    // Of a lamp that stands still: finds out what of the square is not known yet, as if nothing moved.
    void learn(const Square& square) const {
        bool known = true;
        each_patch(square, [&](const Square& one) {
            const Patch patch = patch_of(one);
            known =
                known && (!is_needed(one) || EVIL_PICK(set, knows_patch_wide)(patch, shares_of(*cast.baked, patch)));
        });
        if (known) return;
        divide(
            square, 0, standing(),
            [&](const Patch& patch, const std::vector<std::uint32_t>& near) {
                const Shares kept = shares_of(*cast.baked, patch);
                if (!EVIL_PICK(set, knows_patch_wide)(patch, kept))
                    EVIL_PICK(set, shade_patch_wide)(cast.lamp, near_of(near), patch, kept);
            },
            [&](const Square& dark) {
                each_patch(dark, [&](const Square& one) {
                    const Patch patch = patch_of(one);
                    const Shares kept = shares_of(*cast.baked, patch);
                    for (int y = 0; y < patch.rows; ++y) std::fill_n(kept.at + y * kept.stride, kPatch, 0.0f);
                });
            });
    }
    // Where something that moves may cast a shadow, all casters are asked.
    void shade_kept(const Square& square) const {
        divide(
            square, 0, moving(),
            [&](const Patch& patch, const std::vector<std::uint32_t>& near) {
                const Shares kept = shares_of(*cast.baked, patch);
                if (near.empty()) return add(patch, kept);
                const Square one{patch.x, patch.y, kPatch};
                block.both.assign(standing().begin(), standing().end());
                keep_near(block.both, cast.lamp, field.casters.rows, one.middle(), one.radius(), set);
                block.both.insert(block.both.begin(), near.begin(), near.end());
                EVIL_PICK(set, shade_kept_wide)
                (cast.lamp, near_of(block.both), static_cast<int>(near.size()), patch, kept, own());
                add(patch, own());
            },
            [](const Square&) {});
    }
};

} // namespace

void shade(std::vector<Block>& blocks, std::span<const Cast> casts, const Field& field, const Planes& to,
           Threads& threads, InstructionSet set) {
    if (casts.empty()) return;
    const int across = (field.width + kBlock - 1) / kBlock, down = (field.height + kBlock - 1) / kBlock;
    const auto count = static_cast<std::size_t>(across) * down;
    if (blocks.size() < count) blocks.resize(count);
    parallel_for(threads, count, 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            for (const Cast& cast : casts) {
                const Work work{blocks[i], cast, field, to, set};
                const Square square{static_cast<int>(i) % across * kBlock, static_cast<int>(i) / across * kBlock,
                                    kBlock};
                if (!cast.baked) {
                    work.shade(square);
                    continue;
                }
                work.learn(square);
                work.shade_kept(square);
            }
    });
}

} // namespace evil::light
