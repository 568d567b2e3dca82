#include "draw/scene.hpp"
#include <algorithm>
#include <cmath>
#include <functional>
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

void drop_what_is_gone(Scene& scene, const Poses& poses, const Shapes& shapes) {
    std::erase_if(scene.order, [&](DrawingRef ref) {
        if (!scene.slots.alive(ref)) return true;
        if (is_there(scene.drawings[ref.slot], poses, shapes)) return false;
        drop(scene, ref.slot);
        return true;
    });
}

// A frame does this for each thing: as a part of its loop, not as a call.
inline Pose mixed(const Pose& a, const Pose& b, float part) {
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

// Mesh to world at `alpha`: drawing to shape, shape to body, body to world.
Affine placed(const Drawing& drawing, const Poses& poses, const Shapes& shapes, float alpha) {
    const std::uint32_t body = drawing.body.slot;
    if (body == kNone) return drawing.local;
    const Vec2 scale = poses.scale[body];
    Affine to_body{scale.x, 0, 0, scale.y, 0, 0};
    if (drawing.shape.slot != kNone) to_body = definition_to_body(shapes.rows[drawing.shape.slot], scale);
    return compose(affine(mixed(poses.previous[body], poses.present[body], alpha)), compose(to_body, drawing.local));
}

// How a drawing is seen from the front, written where it lies. False for what is too far away for a float: none of it would
// be on the picture.
bool face_of(Instance& face, const Scene& scene, const Drawing& drawing, const Poses& poses, const Shapes& shapes,
             const LayerCursor& layer, float alpha, double now) {
    face.to_pixel = compose(layer.view, placed(drawing, poses, shapes, alpha));
    if (scene.perspective.on && drawing.behind != 0.0f)
        face.to_pixel = farther(face.to_pixel, scene.perspective, layer.size, drawing.behind);
    if (!is_finite(face.to_pixel)) return false;
    face.to_texture = texture_place(drawing);
    face.mesh = drawing.mesh;
    face.texture = shown_texture(scene, drawing, now);
    face.tint = multiplied(drawing.tint, layer.tint);
    face.blend = drawing.blend, face.lit = drawing.lit;
    const Surface surface = surface_of(scene, drawing, face.texture);
    if (drawing.lit) face.normals = surface.normals;
    face.glows = surface.glows, face.glow = glow_of(drawing, surface);
    return true;
}

// The sides of all things of the layer that begins at `first` of the order, behind the faces of all of them.
void add_sides(Scene& scene, std::size_t first, const Poses& poses, const Shapes& shapes, const LayerCursor& layer,
               float alpha, double now, DrawList& out) {
    scene.slices.clear();
    for (std::size_t i = first; i < scene.order.size(); ++i) {
        const Drawing& drawing = scene.drawings[scene.order[i].slot];
        if (drawing.layer != scene.drawings[scene.order[first].slot].layer) break;
        if (!drawing.visible || !(drawing.depth > 0.0f)) continue;
        if (Instance face; face_of(face, scene, drawing, poses, shapes, layer, alpha, now))
            add_slices(scene.slices, out, face, scene.perspective, layer.size, drawing.behind, drawing.depth);
    }
    std::ranges::stable_sort(scene.slices, std::ranges::greater{}, &Slice::behind);
    for (const Slice& slice : scene.slices) out.instances.push_back(slice.instance);
}

} // namespace

Pose between(const Pose& a, const Pose& b, float part) { return mixed(a, b, part); }

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
    if (!scene.sorted || scene.perspective.on) drop_what_is_gone(scene, poses, shapes);
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
    bool all_there = true; // seen in passing: another walk over all drawings would cost as much as this one
    for (std::size_t i = 0; i < scene.order.size(); ++i) {
        const DrawingRef ref = scene.order[i];
        const Drawing& drawing = scene.drawings[ref.slot];
        if (!scene.slots.alive(ref) || !is_there(drawing, poses, shapes)) {
            all_there = false;
            continue;
        }
        if (!drawing.visible || !layer.go_to(drawing.layer)) continue;
        if (!face_of(out.instances.emplace_back(), scene, drawing, poses, shapes, layer, alpha, now)) {
            out.instances.pop_back();
            continue;
        }
        if (out.layers.empty() || out.layers.back().layer != drawing.layer) {
            out.layers.push_back({drawing.layer, static_cast<std::uint32_t>(out.instances.size() - 1)});
            if (scene.perspective.on) {
                const Instance face = out.instances.back();
                out.instances.pop_back();
                add_sides(scene, i, poses, shapes, layer, alpha, now, out);
                out.instances.push_back(face);
            }
        }
        if (drawing.edge_width > 0.0f) {
            Instance edge = out.instances.back();
            edge.to_texture = {}, edge.texture = edge.normals = edge.glows = kNoTexture;
            edge.glow = 0.0f;
            edge.tint = multiplied(drawing.edge, layer.tint);
            edge.outline = drawing.edge_width * points;
            out.instances.push_back(edge);
        }
    }
    if (!all_there) drop_what_is_gone(scene, poses, shapes);
}

} // namespace evil::draw
