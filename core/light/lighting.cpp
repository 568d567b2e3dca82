#include "light/lighting.hpp"
#include "draw/scene.hpp"
#include "light/shade_wide.hpp"
#include <algorithm>
#include <cmath>
#include <optional>

namespace evil::light {
namespace {

constexpr float kHard =
    0.25f; // texels: half a lamp's line at the least; its half shadows are a texel wide all the same
constexpr std::size_t kRows = 16;            // of the map, that a thread packs at a time
constexpr std::size_t kWorthSharing = 40000; // texels in reach of lamps, about 200 us: less than that wakes no threads

struct Grid { // of the map's texels
    int width, height, stride;
    int left, top;   // which of the world's texels is the first
    Affine to_texel; // from the world
    float scale;     // texels a metre
};

// The texels keep their places in the world while the camera moves, so that shadows do not crawl.
Grid lay_out(LightMap& map, const Affine& view, int step, int width, int height) {
    const float s = static_cast<float>(step);
    const auto start = [s](float origin) {
        float first = origin - s * std::floor(origin / s) - 0.5f * s;
        return first > 0.5f ? first - s : first;
    };
    map.step = s;
    map.first = {start(view.tx), start(view.ty)};
    map.width = static_cast<int>(std::ceil((static_cast<float>(width) - 0.5f - map.first.x) / s)) + 1;
    map.height = static_cast<int>(std::ceil((static_cast<float>(height) - 0.5f - map.first.y) / s)) + 1;
    const Affine to_texel = compose({1.0f / s, 0, 0, 1.0f / s, 0.5f - map.first.x / s, 0.5f - map.first.y / s}, view);
    return {map.width,
            map.height,
            (map.width + kPatch - 1) / kPatch * kPatch,
            -static_cast<int>(std::lround(std::clamp(to_texel.tx, -1e9f, 1e9f))),
            -static_cast<int>(std::lround(std::clamp(to_texel.ty, -1e9f, 1e9f))),
            to_texel,
            std::sqrt(std::fabs(determinant(to_texel)))};
}

Rgb linear(const Rgb& colour, float strength) {
    Rgb result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = static_cast<float>(power(colour[i], 1.0 / kToScreen)) * strength;
    return result;
}

// False for a lamp that is too far away to count, or not anywhere.
bool to_lamp(Lamp& lamp, const Light& light, const Slide* slide, const Pose& pose, const Grid& grid, bool soft) {
    const Rot turn = rotation(light.angle);
    lamp.at = apply(grid.to_texel, transform(pose, light.at));
    lamp.way = normalised(apply_linear(grid.to_texel, rotate(pose.q, {turn.c, turn.s})));
    lamp.parallel = light.reach == Reach::parallel;
    lamp.spot = light.reach == Reach::cone;
    const float reach = lamp.reach = light.radius * grid.scale;
    lamp.height = lamp.parallel ? 0.0f : kHeight * reach;
    lamp.size = !soft ? kHard : lamp.parallel ? light.size * kFar : std::max(light.size * grid.scale, kHard);
    lamp.quarters = static_cast<int>(std::lround(4.0f * light.falloff));
    const float widest = sincos(0.5 * light.cone).cos, full = sincos(0.5 * light.cone * (1.0f - light.edge)).cos;
    lamp.cone_middle = widest;
    lamp.cone_slope = 1.0f / std::max(full - widest, 1e-4f);
    const Rgb colour = linear(light.colour, light.intensity);
    for (std::size_t i = 0; i < 3; ++i) lamp.glow[i] = colour[i] * light.tint[i];
    if (slide) {
        const Affine own{turn.c, turn.s, -turn.s, turn.c, light.at.x, light.at.y};
        put_slide(lamp, *slide, compose(grid.to_texel, compose(affine(pose), own)), light.radius, grid.scale);
    }
    const float right = static_cast<float>(grid.width) + reach, bottom = static_cast<float>(grid.height) + reach;
    return lamp.parallel || (lamp.at.x > -reach && lamp.at.y > -reach && lamp.at.x < right && lamp.at.y < bottom);
}

// A lamp shines out of the bodies that it is in.
void find_casters(Cast& cast, const Light& light, const Casters& all, const Grid& grid,
                  std::vector<std::uint32_t>& holders, std::vector<std::uint32_t>& housings, InstructionSet set) {
    holders.clear();
    if (!cast.lamp.parallel)
        for (const Caster& caster : all.rows)
            if (holds(all, caster, cast.lamp.at)) holders.push_back(caster.body);
    housings.insert(housings.end(), holders.begin(), holders.end());
    if (light.body.slot != kNone) housings.push_back(light.body.slot);
    const Vec2 half = 0.5f * Vec2{static_cast<float>(grid.width), static_cast<float>(grid.height)};
    const Vec2 middle = cast.lamp.parallel ? half : cast.lamp.at;
    const float radius = cast.lamp.parallel ? length(half) : cast.lamp.reach;
    for (std::uint32_t i = 0; i < all.rows.size(); ++i) {
        const Caster& caster = all.rows[i];
        if (!(caster.category & light.mask) || caster.body == light.body.slot) continue;
        if (std::ranges::find(holders, caster.body) == holders.end()) cast.casters.push_back(i);
    }
    keep_near(cast.casters, cast.lamp, all.rows, middle, radius, set);
}

Cast& next(std::vector<Cast>& casts, std::size_t& count) {
    if (count == casts.size()) casts.emplace_back();
    return casts[count++];
}

BakedOf baked_of(const Light& light, const Pose& pose, const Grid& grid, std::uint64_t casters, bool shadows,
                 bool soft) {
    const Affine& m = grid.to_texel;
    return {light.serial,  casters, pose, light.at, light.angle, light.cone, light.edge, light.radius, light.size,
            light.falloff, m.a,     m.b,  m.c,      m.d,         light.mask, shadows,    soft};
}

void find_lamps(Scratch& scratch, const Lights& lights, const Look& look, const World& world, const Grid& grid,
                float alpha) {
    const bool soft = look.quality != Quality::low;
    scratch.open_count = scratch.shaded_count = 0;
    scratch.housings.clear();
    scratch.baked.resize(lights.rows.size());
    std::optional<std::uint64_t> still;
    for (std::uint32_t slot = 0; slot < lights.rows.size(); ++slot) {
        const Light& light = lights.rows[slot];
        if (!lights.slots.taken(slot) || !light.on) continue;
        Pose pose;
        if (light.body.slot != kNone)
            pose = draw::between(world.previous[light.body.slot], world.present[light.body.slot], alpha);
        Lamp lamp;
        const Slide* slide = light.slide == kNone ? nullptr : &lights.slides[light.slide];
        if (!to_lamp(lamp, light, slide, pose, grid, soft)) continue;
        const bool shadows = light.shadows && look.shadows;
        Cast& cast = shadows ? next(scratch.shaded, scratch.shaded_count) : next(scratch.open, scratch.open_count);
        cast.lamp = lamp, cast.baked = nullptr;
        cast.casters.clear(), cast.moving = 0;
        cast.veil.shares.clear();
        if (shadows)
            find_casters(cast, light, scratch.casters, grid, scratch.holders, scratch.housings, world.instruction_set);
        if (!light.still) continue;
        if (!still) still = sum_of_still(world, scratch.words);
        const auto standing = std::ranges::stable_partition(
            cast.casters, [&](std::uint32_t caster) { return !scratch.casters.rows[caster].still; });
        cast.moving = static_cast<std::size_t>(standing.begin() - cast.casters.begin());
        cast.baked = &scratch.baked[slot];
        move_to(*cast.baked, baked_of(light, pose, grid, *still, shadows, soft), grid.left, grid.top, grid.stride,
                grid.height);
    }
}

// Where light is added up: three planes, or nine with the ways that it comes from.
Planes planes_at(float* first, std::size_t plane, bool directed) {
    Planes planes{};
    for (std::size_t c = 0; c < 3; ++c) {
        planes.light[c] = first + c * plane;
        if (directed) planes.across[c] = first + (3 + c) * plane, planes.down[c] = first + (6 + c) * plane;
    }
    return planes;
}

// What lamps with shadows give, on and in bodies, is added to the rest: light, and the ways that it comes from.
void add_shaded(Scratch& scratch, const Grid& grid, int reach, const Planes& open, const Planes& shaded, bool directed,
                Threads& threads, InstructionSet set) {
    const std::size_t count = static_cast<std::size_t>(grid.stride) * grid.height;
    const bool bodies = std::ranges::find(scratch.solid, std::uint8_t{1}) != scratch.solid.end();
    float* const* to[] = {open.light, open.across, open.down};
    float* const* from[] = {shaded.light, shaded.across, shaded.down};
    parallel_for(threads, directed ? 3 : 1, 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            if (bodies)
                add_soaked(to[i], from[i], scratch.solid, grid.stride, grid.height, reach, set, scratch.soak[i]);
            else
                for (std::size_t c = 0; c < 3; ++c)
                    for (std::size_t at = 0; at < count; ++at) to[i][c][at] += from[i][c][at];
        }
    });
}

void pack(LightMap& map, const Grid& grid, const Planes& planes, Threads& threads, InstructionSet set) {
    const std::size_t count = static_cast<std::size_t>(map.width) * map.height;
    map.texels.resize(count);
    if (map.directed) map.across.resize(count), map.down.resize(count);
    parallel_for(threads, static_cast<std::size_t>(map.height), kRows, [&](std::size_t first, std::size_t last) {
        for (std::size_t y = first; y < last; ++y) {
            const int from = static_cast<int>(y) * grid.stride;
            const std::size_t to = y * map.width;
            EVIL_PICK(set, pack_factors_wide)(planes.light, from, map.width, &map.texels[to]);
            if (!map.directed) continue;
            EVIL_PICK(set, pack_ways_wide)(planes.light, planes.across, from, map.width, &map.across[to]);
            EVIL_PICK(set, pack_ways_wide)(planes.light, planes.down, from, map.width, &map.down[to]);
        }
    });
}

bool is_worth_sharing(const Scratch& scratch, const Look& look, std::size_t texels) {
    if (look.quality == Quality::high) return true;
    double lit = 0;
    for (const auto& casts :
         {std::span(scratch.open).first(scratch.open_count), std::span(scratch.shaded).first(scratch.shaded_count)})
        for (const Cast& cast : casts) {
            const double reach = cast.lamp.reach, side = 2.0 * reach;
            lit +=
                cast.lamp.parallel ? static_cast<double>(texels) : std::min(side * side, static_cast<double>(texels));
        }
    return lit >= static_cast<double>(kWorthSharing);
}

} // namespace

void remove_orphans(Lights& lights, const Slots& bodies) {
    for (std::uint32_t slot = 0; slot < lights.rows.size(); ++slot)
        if (lights.slots.taken(slot) && lights.rows[slot].body.slot != kNone && !bodies.alive(lights.rows[slot].body))
            lights.slots.release(slot);
}

void compute(LightMap& map, Scratch& scratch, const Lights& lights, const Look& look, const World& world,
             const Affine& view, float alpha, int width, int height, Threads& threads) {
    map.on = look.on;
    map.directed = look.on && look.directed;
    if (!map.on) return;
    const Grid grid = lay_out(map, view, look.step, width, height);
    gather(scratch.casters, world, grid.to_texel, alpha);
    find_lamps(scratch, lights, look, world, grid, alpha);
    if (scratch.shaded_count > 0 && find_haze(scratch.haze, look.smokes, world, grid.to_texel, grid.width, grid.height))
        for (Cast& cast : std::span(scratch.shaded).first(scratch.shaded_count))
            find_veil(cast.veil, scratch.haze, cast.lamp);

    const std::size_t plane = static_cast<std::size_t>(grid.stride) * grid.height;
    std::optional<Threads::Shift> shift;
    if (is_worth_sharing(scratch, look, plane)) shift.emplace(threads);
    const std::size_t planes = look.directed ? 9 : 3;
    scratch.planes.assign(2 * planes * plane, 0.0f);
    scratch.solid.assign(plane, 0);
    const Planes open = planes_at(scratch.planes.data(), plane, look.directed);
    const Planes shaded = planes_at(scratch.planes.data() + planes * plane, plane, look.directed);
    const Field field{grid.width, grid.height, grid.stride, scratch.solid, scratch.casters};
    const Rgb ambient = linear(look.ambient, look.strength);
    for (std::size_t i = 0; i < 3; ++i) std::fill_n(open.light[i], plane, ambient[i]);
    shade(scratch.blocks, std::span(scratch.open).first(scratch.open_count), field, open, threads,
          world.instruction_set);
    if (scratch.shaded_count > 0 || look.quality == Quality::high) {
        for (const Caster& caster : scratch.casters.rows)
            fill<std::uint8_t>(scratch.casters, caster, grid.width, grid.height, grid.stride, scratch.solid, 1,
                               Covers::middle);
        shade(scratch.blocks, std::span(scratch.shaded).first(scratch.shaded_count), field, shaded, threads,
              world.instruction_set);
        const float t = 1.0f / map.step;
        const Affine from_pixel{t, 0, 0, t, 0.5f - map.first.x * t, 0.5f - map.first.y * t};
        // What a lamp stands in is in its whole light, and small: it would send out rays that one sees one by one.
        for (const std::uint32_t body : scratch.housings)
            if (body < scratch.bounce.colours.size()) scratch.bounce.colours[body] = {};
        if (look.quality == Quality::high)
            add_bounced(scratch.bounce,
                        {grid.stride, grid.height, grid.stride, from_pixel, grid.left, grid.top, open.light[0],
                         shaded.light[0], shaded.across[0], shaded.down[0]},
                        {ambient, look.bounce, look.shade * grid.scale}, scratch.casters, threads,
                        world.instruction_set);
        const int reach = std::clamp(static_cast<int>(std::lround(look.depth * grid.scale)), 1, grid.width);
        add_shaded(scratch, grid, reach, open, shaded, look.directed, threads, world.instruction_set);
    }
    pack(map, grid, open, threads, world.instruction_set);
}

} // namespace evil::light
