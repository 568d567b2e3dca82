#include "gpu/batches.hpp"
#include "gpu/instances.hpp"
#include <algorithm>

namespace evil::gpu {
namespace {

constexpr std::uint32_t kFewSprites = 16; // fewer in a row are not worth a draw call of their own

struct Run { // sprites that one draw call could take, of instances from `first` on
    std::uint32_t first_sprite = 0, first = 0, page = 0;
    Fringe fringe = Fringe::none;
    draw::Blend blend = draw::Blend::over;
    bool lit = false;
};

std::uint32_t length_of(const Context& context, const Run& run) {
    return static_cast<std::uint32_t>(context.frame.sprites.size()) - run.first_sprite;
}

// Makes a draw call of the run, or quads where it is too short for one. Instances from `end` on are not in it.
void finish(Context& context, Run& run, std::uint32_t end) {
    Frame& frame = context.frame;
    const std::uint32_t count = length_of(context, run);
    if (count >= kFewSprites) {
        Batch batch;
        batch.first = run.first_sprite, batch.count = count;
        batch.sprites = true, batch.lit = run.lit, batch.fringe = run.fringe, batch.blend = run.blend;
        batch.textures[0] = run.page;
        frame.batches.push_back(batch);
    } else if (count > 0) {
        frame.sprites.resize(run.first_sprite);
        for (std::uint32_t i = run.first; i < end; ++i) put_instance(context, context.list.instances[i]);
    }
    run.first_sprite = static_cast<std::uint32_t>(frame.sprites.size());
}

void put_next(Context& context, Run& run, std::uint32_t number) {
    const draw::Instance& instance = context.list.instances[number];
    if (instance.mesh >= context.list.meshes.size()) return;
    const Bounds& t = context.target;
    const Rect target{0, 0, static_cast<float>(t.right), static_cast<float>(t.bottom)};
    const light::LightMap& light = context.list.light;
    const bool lit = instance.lit && light.on;
    const bool has_surface = instance.glow > 0.0f || (lit && light.directed && instance.normals != draw::kNoTexture);
    const draw::Blend blend = instance.blend == draw::Blend::add ? draw::Blend::over : instance.blend;
    std::vector<Sprite>& sprites = context.frame.sprites;
    Sprite& sprite = sprites.emplace_back(); // filled where it lies
    Way way;
    const Fit how = has_surface ? Fit::other
                                : fit(sprite, way, instance, context.shapes.shapes[instance.mesh].box,
                                      context.pictures.places, held(context, instance.texture), lit, target);
    if (how != Fit::sprite) {
        sprites.pop_back();
        if (how == Fit::nothing) return;
        finish(context, run, number);
        return put_instance(context, instance);
    }
    bool begins = length_of(context, run) == 1;
    if (!begins && (way.page != run.page || blend != run.blend)) {
        const Sprite first = sprite;
        sprites.pop_back();
        finish(context, run, number);
        sprites.push_back(first);
        begins = true;
    }
    if (begins) run.first = number, run.page = way.page, run.blend = blend, run.lit = false, run.fringe = Fringe::none;
    run.lit |= lit, run.fringe = std::max(run.fringe, way.fringe);
}

// Something of its own, in the midst of the draw calls.
void put_interlude(Frame& frame, const draw::Interlude& interlude) {
    Batch batch;
    batch.interlude = interlude;
    frame.batches.push_back(batch);
}

} // namespace

void collect(Frame& frame, Shapes& shapes, Scratch& scratch, const draw::DrawList& list, const Pictures& pictures,
             int width, int height) {
    update(shapes, list);
    frame.quads.clear(), frame.sprites.clear(), frame.edges.clear();
    frame.specks = list.interludes.specks;
    frame.batches.clear();
    const std::uint32_t liquids = list.interludes.liquid_count;
    if (frame.liquids.size() < liquids) frame.liquids.resize(liquids);
    for (std::uint32_t i = 0; i < liquids; ++i) pack_liquid(list.interludes.liquids[i], frame.liquids[i]);
    Context context{frame, shapes, scratch, list, pictures, {0, 0, width, height}};
    Run run;
    auto interlude = list.interludes.rows.begin();
    const auto put_interludes = [&](std::uint32_t before) {
        for (; interlude != list.interludes.rows.end() && interlude->before <= before; ++interlude) {
            finish(context, run, before);
            put_interlude(frame, *interlude);
        }
    };
    const auto count = static_cast<std::uint32_t>(list.instances.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        put_interludes(i);
        put_next(context, run, i);
    }
    finish(context, run, count);
    put_interludes(count);
}

} // namespace evil::gpu
