#include "draw/scene.hpp"
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <tuple>

namespace evil::draw {
namespace {

bool is_finite(const Affine& m) {
    return std::isfinite(m.a) && std::isfinite(m.b) && std::isfinite(m.c) && std::isfinite(m.d) &&
           std::isfinite(m.tx) && std::isfinite(m.ty);
}

bool is_there(const Drawing& drawing, const Poses& poses, const Shapes& shapes) { // what it follows, if anything
    const BodyRef body = drawing.body;
    if (body.slot == kNone) return true;
    if (body.slot >= poses.generation.size() || poses.generation[body.slot] != body.generation) return false;
    return drawing.shape.slot == kNone || shapes.slots.alive(drawing.shape);
}

auto depth(const Drawing& drawing) { return std::tuple(drawing.layer, drawing.serial); }

void drop(Scene& scene, std::uint32_t slot) {
    scene.meshes.release(scene.drawings[slot].mesh);
    scene.slots.release(slot);
    scene.drawings[slot] = Drawing{};
}

// Mesh to world at `alpha`: drawing to shape, shape to body, body to world.
Affine placed(const Drawing& drawing, const Poses& poses, const Shapes& shapes, float alpha) {
    const std::uint32_t body = drawing.body.slot;
    if (body == kNone) return drawing.local;
    const Vec2 scale = poses.scale[body];
    Affine to_body{scale.x, 0, 0, scale.y, 0, 0};
    if (drawing.shape.slot != kNone) to_body = definition_to_body(shapes.rows[drawing.shape.slot], scale);
    return compose(affine(between(poses.previous[body], poses.present[body], alpha)), compose(to_body, drawing.local));
}

// How a drawing is seen from the front; nothing for what is too far away for a float: none of it would be on the picture.
std::optional<Instance> face_of(const Scene& scene, const Drawing& drawing, const Poses& poses, const Shapes& shapes,
                                const LayerCursor& layer, float alpha, double now) {
    Affine to_pixel = compose(layer.view, placed(drawing, poses, shapes, alpha));
    if (scene.perspective.on && drawing.behind != 0.0f)
        to_pixel = farther(to_pixel, scene.perspective, layer.size, drawing.behind);
    if (!is_finite(to_pixel)) return std::nullopt;
    const std::uint32_t shown = shown_texture(scene, drawing, now);
    const Surface surface = surface_of(scene, drawing, shown);
    return Instance{to_pixel,
                    texture_place(drawing),
                    drawing.mesh,
                    shown,
                    multiplied(drawing.tint, layer.tint),
                    0.0f,
                    drawing.blend,
                    drawing.lit,
                    drawing.lit ? surface.normals : kNoTexture,
                    surface.glows,
                    glow_of(drawing, surface)};
}

// The sides of all things of the layer that begins at `first` of the order, behind the faces of all of them.
void add_sides(Scene& scene, std::size_t first, const Poses& poses, const Shapes& shapes, const LayerCursor& layer,
               float alpha, double now, DrawList& out) {
    scene.slices.clear();
    for (std::size_t i = first; i < scene.order.size(); ++i) {
        const Drawing& drawing = scene.drawings[scene.order[i].slot];
        if (drawing.layer != scene.drawings[scene.order[first].slot].layer) break;
        if (!drawing.visible || !(drawing.depth > 0.0f)) continue;
        if (const std::optional<Instance> face = face_of(scene, drawing, poses, shapes, layer, alpha, now))
            add_slices(scene.slices, out, *face, scene.perspective, layer.size, drawing.behind, drawing.depth);
    }
    std::ranges::stable_sort(scene.slices, std::ranges::greater{}, &Slice::behind);
    for (const Slice& slice : scene.slices) out.instances.push_back(slice.instance);
}

} // namespace

Pose between(const Pose& a, const Pose& b, float part) {
    const float cosine = a.q.c * b.q.c + a.q.s * b.q.s, sine = a.q.c * b.q.s - a.q.s * b.q.c;
    Rot q;
    if (cosine > 0.9f) { // nearly the same way: the chord is the arc, to 1%
        const Vec2 chord = normalised(lerp({a.q.c, a.q.s}, {b.q.c, b.q.s}, part));
        q = {chord.x, chord.y};
    } else {
        const Rot turn = rotation(part * atan2(sine, cosine));
        q = {a.q.c * turn.c - a.q.s * turn.s, a.q.s * turn.c + a.q.c * turn.s};
    }
    return {lerp(a.p, b.p, part), q};
}

DrawingRef add(Scene& scene, const Drawing& drawing) {
    const std::uint32_t slot = scene.slots.take();
    if (slot == scene.drawings.size()) scene.drawings.emplace_back();
    Drawing& row = scene.drawings[slot] = drawing;
    row.serial = scene.next_serial++;
    const DrawingRef ref{slot, scene.slots.generation(slot)};
    if (!scene.order.empty()) {
        const DrawingRef last = scene.order.back();
        if (!scene.slots.alive(last) || depth(scene.drawings[last.slot]) > depth(row)) scene.sorted = false;
    }
    scene.order.push_back(ref);
    return ref;
}

void remove(Scene& scene, DrawingRef drawing) { drop(scene, drawing.slot); }

void set_layer(Scene& scene, DrawingRef drawing, std::int32_t layer) {
    Drawing& row = scene.drawings[drawing.slot];
    if (row.layer == layer) return;
    row.layer = layer;
    scene.sorted = false;
}

std::uint32_t shown_texture(const Scene& scene, const Drawing& drawing, double now) {
    if (drawing.playing.clip == kNone) return drawing.texture;
    const Clip& clip = scene.clips[drawing.playing.clip];
    return clip.textures[frame_at(clip, now - static_cast<double>(drawing.playing.began))];
}

Affine texture_place(const Drawing& drawing) {
    if (!drawing.flip_x && !drawing.flip_y) return drawing.texture_matrix;
    const float x = drawing.flip_x ? 1.0f : 0.0f, y = drawing.flip_y ? 1.0f : 0.0f;
    return compose(drawing.texture_matrix, {1 - 2 * x, 0, 0, 1 - 2 * y, x, y});
}

Surface surface_of(const Scene& scene, const Drawing& drawing, std::uint32_t shown) {
    Surface surface = shown < scene.surfaces.size() ? scene.surfaces[shown] : Surface{};
    if (drawing.surface.normals != kNoTexture) surface.normals = drawing.surface.normals;
    if (drawing.surface.glows != kNoTexture) surface.glows = drawing.surface.glows;
    return surface;
}

float glow_of(const Drawing& drawing, const Surface& surface) {
    if (drawing.glow >= 0.0f) return drawing.glow;
    return surface.glows != kNoTexture ? 1.0f : 0.0f;
}

void collect(Scene& scene, const Poses& poses, const Shapes& shapes, const Affine& view, float alpha, double now,
             float points, DrawList& out) {
    std::erase_if(scene.order, [&](DrawingRef ref) {
        if (!scene.slots.alive(ref)) return true;
        if (is_there(scene.drawings[ref.slot], poses, shapes)) return false;
        drop(scene, ref.slot);
        return true;
    });
    if (!scene.sorted)
        std::ranges::sort(scene.order, {}, [&](DrawingRef ref) { return depth(scene.drawings[ref.slot]); });
    scene.sorted = true;

    if (out.copied_meshes != scene.meshes.revision()) {
        out.vertices = scene.meshes.vertices();
        out.indices = scene.meshes.indices();
        out.holes = scene.meshes.holes();
        out.meshes = scene.meshes.meshes();
        out.copied_meshes = scene.meshes.revision();
    }
    out.vertices.resize(scene.meshes.vertices().size()); // what an overlay added last frame goes
    out.indices.resize(scene.meshes.indices().size());
    out.holes.resize(scene.meshes.holes().size());
    out.meshes.resize(scene.meshes.meshes().size());
    out.instances.clear();
    out.layers.clear();
    out.interludes.clear();
    out.light.on = out.light.directed = false;

    LayerCursor layer{scene.looks, view};
    for (std::size_t i = 0; i < scene.order.size(); ++i) {
        const Drawing& drawing = scene.drawings[scene.order[i].slot];
        if (!drawing.visible || !layer.go_to(drawing.layer)) continue;
        const std::optional<Instance> face = face_of(scene, drawing, poses, shapes, layer, alpha, now);
        if (!face) continue;
        if (out.layers.empty() || out.layers.back().layer != drawing.layer) {
            out.layers.push_back({drawing.layer, static_cast<std::uint32_t>(out.instances.size())});
            if (scene.perspective.on) add_sides(scene, i, poses, shapes, layer, alpha, now, out);
        }
        out.instances.push_back(*face);
        if (drawing.edge_width > 0.0f) {
            Instance edge = *face;
            edge.to_texture = {}, edge.texture = edge.normals = edge.glows = kNoTexture;
            edge.glow = 0.0f;
            edge.tint = multiplied(drawing.edge, layer.tint);
            edge.outline = drawing.edge_width * points;
            out.instances.push_back(edge);
        }
    }
}

} // namespace evil::draw
