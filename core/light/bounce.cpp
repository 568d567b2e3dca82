#include "light/bounce.hpp"
#include "draw/scene.hpp"
#include "light/light_map.hpp"
#include "math/functions.hpp"
#include <algorithm>

namespace evil::light {
namespace {

constexpr std::size_t kRows = 16; // of texels that a thread takes at a time

constexpr float kPlain =
    0.5f; // of a body that is not drawn, and of white pictures, whose colours the core does not know
constexpr float kWhitest = 0.9f; // what paint sends back at most: freshly plastered walls do

Rgb colour_of(const std::vector<float>& levels, const draw::Scene& scene, const draw::Drawing& drawing) {
    const draw::Mesh& mesh = scene.meshes.meshes()[drawing.mesh];
    const draw::Rgba8 corner = scene.meshes.vertices()[mesh.first_vertex].colour;
    const float share = drawing.texture != draw::kNoTexture || drawing.playing.clip != kNone ? kPlain : kWhitest;
    Rgb colour;
    for (int c = 0; c < 3; ++c)
        colour[c] = share * levels[drawing.tint >> 8 * c & 255u] * levels[corner >> 8 * c & 255u];
    return colour;
}

// Cascades begin at every eighth texel of the world: what they are off by then moves with the world, and does not shimmer
// when the camera does. All that lies further out shows in light that is too soft for it.
constexpr int kAnchor = 8;

int beyond(int texel) { return (texel % kAnchor + kAnchor) % kAnchor; }

void take_in(Bounce& bounce, const BounceMap& map, const BounceLook& look) {
    Cells& cells = bounce.cells;
    const int left = beyond(map.left), top = beyond(map.top);
    cells.resize(left + map.width + beyond(-map.left - map.width), top + map.height + beyond(-map.top - map.height),
                 !bounce.glowing.colours.empty());
    const std::size_t plane = static_cast<std::size_t>(map.stride) * map.height, count = bounce.colours.size();
    for (int y = 0; y < map.height; ++y) {
        const std::size_t at = static_cast<std::size_t>(y) * map.stride;
        const std::uint32_t* bodies = bounce.bodies.data() + at;
        float* solid = cells.row(Cells::solid, top + y) + left;
        for (int x = 0; x < map.width; ++x) solid[x] = bodies[x] == kNone ? 0.0f : 1.0f;
        for (int c = 0; c < 3; ++c) {
            float* colour = cells.row(Cells::colour + c, top + y) + left;
            const float *open = map.open + c * plane + at, *shaded = map.shaded + c * plane + at;
            for (int x = 0; x < map.width; ++x) {
                if (bodies[x] == kNone)
                    colour[x] = open[x] - look.ambient[c] + shaded[x];
                else if (bodies[x] < count)
                    colour[x] = look.strength * bounce.colours[bodies[x]][c];
                else
                    cells.row(Cells::glow + c, top + y)[left + x] = bounce.glowing.colours[bodies[x] - count][c];
            }
        }
    }
}

// What was found, less the ambient light, is added. A texel that a body covers some of is solid to rays, and may be seen
// beside the body: it takes the mean of the air's light round it.
void add_found(const Bounce& bounce, const BounceMap& map, const float* found, std::size_t row, float ambient,
               float* to, Threads& threads) {
    const auto in_air = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < map.width && y < map.height &&
               bounce.bodies[static_cast<std::size_t>(y) * map.stride + x] == kNone;
    };
    const auto add_row = [&](int y) {
        for (int x = 0; x < map.width; ++x) {
            const float* at = found + y * row + x;
            float sum = 0.0f, count = 0.0f;
            if (in_air(x, y)) {
                sum = *at, count = 1.0f;
            } else {
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx)
                        if (in_air(x + dx, y + dy)) sum += at[dy * static_cast<std::ptrdiff_t>(row) + dx], ++count;
            }
            if (count > 0.0f) to[static_cast<std::size_t>(y) * map.stride + x] += sum / count - ambient;
        }
    };
    parallel_for(threads, static_cast<std::size_t>(map.height), kRows, [&](std::size_t first, std::size_t last) {
        for (std::size_t y = first; y < last; ++y) add_row(static_cast<int>(y));
    });
}

} // namespace

void find_colours(Bounce& bounce, const draw::Scene& scene, const draw::DrawList& list, const World& world) {
    if (bounce.levels.empty())
        for (int level = 0; level < 256; ++level)
            bounce.levels.push_back(static_cast<float>(power(level / 255.0, 1.0 / kToScreen)));
    bounce.colours.assign(world.bodies.slots.size(), {kPlain, kPlain, kPlain});
    for (const draw::DrawingRef ref : scene.order) {
        const draw::Drawing& drawing = scene.drawings[ref.slot];
        if (!drawing.visible || drawing.body.slot == kNone || drawing.blend != draw::Blend::over) continue;
        bounce.colours[drawing.body.slot] = colour_of(bounce.levels, scene, drawing);
    }
    find_glowing(bounce.glowing, list, bounce.levels);
}

void add_bounced(Bounce& bounce, const BounceMap& map, const BounceLook& look, const Casters& casters, Threads& threads,
                 InstructionSet set) {
    const std::size_t plane = static_cast<std::size_t>(map.stride) * map.height;
    bounce.bodies.assign(plane, kNone);
    for (const Caster& caster : casters.rows)
        fill<std::uint32_t>(casters, caster, map.width, map.height, map.stride, bounce.bodies, caster.body,
                            Covers::any);
    move_to(bounce.glowing, map.from_pixel);
    for (const Caster& piece : bounce.glowing.pieces.rows)
        fill<std::uint32_t>(bounce.glowing.pieces, piece, map.width, map.height, map.stride, bounce.bodies,
                            static_cast<std::uint32_t>(bounce.colours.size()) + piece.body, Covers::any);
    take_in(bounce, map, look);
    const Sky sky{look.ambient, std::max(look.reach, 1.0f)};
    const std::size_t row = static_cast<std::size_t>(bounce.cells.width);
    const std::size_t found_plane = row * bounce.cells.height, start = beyond(map.top) * row + beyond(map.left);
    bounce.planes.resize((map.across ? 9 : 3) * found_plane);
    Found found{{}, {}, {}, bounce.cells.width};
    for (int c = 0; c < 3; ++c) {
        found.light[c] = bounce.planes.data() + c * found_plane;
        if (map.across)
            found.across[c] = found.light[c] + 3 * found_plane, found.down[c] = found.light[c] + 6 * found_plane;
    }
    spread(bounce.cascades, bounce.cells, sky, found, threads, set);
    for (int c = 0; c < 3; ++c) {
        add_found(bounce, map, found.light[c] + start, row, look.ambient[c], map.shaded + c * plane, threads);
        if (!map.across) continue;
        add_found(bounce, map, found.across[c] + start, row, 0.0f, map.across + c * plane, threads);
        add_found(bounce, map, found.down[c] + start, row, 0.0f, map.down + c * plane, threads);
    }
}

} // namespace evil::light
