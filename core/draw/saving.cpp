#include "draw/saving.hpp"
#include "archive.hpp"
#include "shapes/polygon.hpp"
#include <algorithm>
#include <array>
#include <cmath>

namespace evil::draw {
namespace {

constexpr std::uint32_t kMostSlots = 1u << 20; // drawings; a forged file may not ask for all memory

template <class A, Like<Vertex> V> void fields(A& ar, V& v) { visit(ar, v.at, v.uv, v.colour); }

// What a drawing keeps; the generations of what it is on are a process's own.
template <class A, Like<Drawing> V> void fields(A& ar, V& d) {
    visit(ar, d.body.slot, d.shape.slot, d.local, d.texture_matrix, d.mesh, d.texture, d.tint, d.edge, d.edge_width,
          d.layer, d.visible, d.lit, d.serial, d.flip_x, d.flip_y, d.blend, d.behind, d.depth, d.playing.clip,
          d.playing.began, d.surface.normals, d.surface.glows, d.glow);
}

bool is_there(const Drawing& d, const World& world) {
    if (d.body.slot == kNone) return true;
    if (!world.bodies.slots.alive(d.body)) return false;
    return d.shape.slot == kNone || world.shapes.slots.alive(d.shape);
}

std::array<std::uint32_t*, 3> textures_of(Drawing& d) { return {&d.texture, &d.surface.normals, &d.surface.glows}; }

// 1, 2, ... for values as they are first met; `of` remembers by value.
std::uint32_t number_of(std::uint32_t value, std::vector<std::uint32_t>& of, std::vector<std::uint32_t>& met) {
    if (value >= of.size()) of.resize(value + 1, 0);
    if (of[value] == 0) {
        met.push_back(value);
        of[value] = static_cast<std::uint32_t>(met.size());
    }
    return of[value];
}

bool is_sound(const SavedMesh& mesh) {
    if (mesh.corners.empty()) return mesh.radius > 0.0f && mesh.holes.empty() && !mesh.sliced;
    if (mesh.sliced) return mesh.radius == 0.0f && mesh.corners.size() == kSliced && mesh.holes.empty();
    std::size_t first = 0; // of a ring
    for (const std::uint32_t hole : mesh.holes) {
        if (hole < first + 3) return false;
        first = hole;
    }
    // A chain's outline may cross itself; numbers are finite.
    return mesh.radius == 0.0f && mesh.corners.size() >= first + 3;
}

bool hold_together(const SavedScene& s) {
    std::vector<std::uint64_t> serials;
    for (const Drawing& d : s.drawings) {
        if (d.mesh >= s.meshes.size() || d.serial >= s.next_serial) return false;
        if (std::max({d.texture, d.surface.normals, d.surface.glows}) > s.textures) return false;
        if (!(d.glow == kGlowAsShown || (d.glow >= 0.0f && d.glow <= kMostGlow))) return false;
        if (static_cast<int>(d.blend) >= kBlends) return false;
        if (!(std::fabs(d.behind) <= kDeepest && d.depth >= 0.0f && d.depth <= kDeepest)) return false;
        if (d.playing.clip != kNone && d.playing.clip >= s.clips) return false;
        if (d.body.slot == kNone && d.shape.slot != kNone) return false;
        serials.push_back(d.serial);
    }
    std::ranges::sort(serials);
    return std::ranges::adjacent_find(serials) == serials.end() && std::ranges::all_of(s.meshes, is_sound);
}

bool same_place(const Drawing& a, const Drawing& b) { // references of one process: equal only for the same things
    return a.serial == b.serial && a.body == b.body && a.shape == b.shape;
}

} // namespace

SceneBytes snapshot(const Scene& scene, const World& world) {
    SceneBytes result;
    std::vector<std::uint32_t> slots, meshes, mesh_number, texture_number, clip_number;
    for (std::uint32_t slot = 0; slot < scene.drawings.size(); ++slot)
        if (scene.slots.taken(slot) && is_there(scene.drawings[slot], world)) slots.push_back(slot);

    BytesWriter ar;
    ar.value(scene.next_serial);
    ar.count(slots.size());
    for (const std::uint32_t slot : slots) {
        Drawing d = scene.drawings[slot];
        d.mesh = number_of(d.mesh, mesh_number, meshes) - 1;
        for (std::uint32_t* texture : textures_of(d))
            if (*texture != kNoTexture) *texture = number_of(*texture, texture_number, result.textures);
        if (d.playing.clip != kNone) d.playing.clip = number_of(d.playing.clip, clip_number, result.clips) - 1;
        ar.value(slot);
        fields(ar, d);
    }
    ar.count(meshes.size());
    for (const std::uint32_t slot : meshes) {
        const Mesh& mesh = scene.meshes.meshes()[slot];
        const bool round = mesh.kind == MeshKind::circle;
        ar.value(mesh.radius);
        const std::uint32_t corners = round ? 0 : mesh.vertex_count + mesh.inside;
        ar.value(mesh.inside > 0);
        ar.count(corners);
        for (std::uint32_t i = 0; i < corners; ++i) fields(ar, scene.meshes.vertices()[mesh.first_vertex + i]);
        ar.count(mesh.hole_count);
        for (const std::uint32_t hole : scene.meshes.holes_of(mesh)) ar.value(hole);
    }
    ar.value(static_cast<std::uint32_t>(result.textures.size()));
    ar.value(static_cast<std::uint32_t>(result.clips.size()));
    result.bytes = ar.take();
    return result;
}

std::shared_ptr<const SavedScene> read_scene(std::span<const std::uint8_t> bytes) {
    Reader ar(bytes);
    auto saved = std::make_shared<SavedScene>();
    ar.value(saved->next_serial);
    for (std::size_t n = ar.count(); n > 0 && ar.ok; --n) {
        std::uint32_t slot = 0;
        ar.value(slot);
        if (slot >= kMostSlots || (!saved->slots.empty() && slot <= saved->slots.back())) ar.ok = false;
        saved->slots.push_back(slot);
        fields(ar, saved->drawings.emplace_back());
    }
    for (std::size_t n = ar.count(); n > 0 && ar.ok; --n) {
        SavedMesh& mesh = saved->meshes.emplace_back();
        ar.value(mesh.radius);
        ar.value(mesh.sliced);
        for (std::size_t corners = ar.count(); corners > 0 && ar.ok; --corners) fields(ar, mesh.corners.emplace_back());
        for (std::size_t holes = ar.count(); holes > 0 && ar.ok; --holes) ar.value(mesh.holes.emplace_back());
    }
    ar.value(saved->textures);
    ar.value(saved->clips);
    if (!ar.ok || !ar.at_end() || !hold_together(*saved)) return nullptr;
    return saved;
}

bool restore(Scene& scene, const SavedScene& saved, const World& world, std::span<const std::uint32_t> textures,
             std::span<const std::uint32_t> clips) {
    std::vector<Drawing> rows;
    std::vector<bool> taken, same;
    for (std::size_t i = 0; i < saved.slots.size(); ++i) {
        const std::uint32_t slot = saved.slots[i];
        Drawing d = saved.drawings[i];
        if (d.body.slot != kNone) {
            if (!world.bodies.slots.taken(d.body.slot)) return false;
            d.body.generation = world.bodies.slots.generation(d.body.slot);
        }
        if (d.shape.slot != kNone) {
            const bool on_it =
                world.shapes.slots.taken(d.shape.slot) && world.shapes.rows[d.shape.slot].body == d.body.slot;
            if (!on_it) return false;
            d.shape.generation = world.shapes.slots.generation(d.shape.slot);
        }
        for (std::uint32_t* texture : textures_of(d))
            if (*texture != kNoTexture) *texture = textures[*texture - 1];
        if (d.playing.clip != kNone) d.playing.clip = clips[d.playing.clip];
        rows.resize(slot + 1);
        taken.resize(slot + 1, false);
        same.resize(slot + 1, false);
        rows[slot] = d;
        taken[slot] = true;
        same[slot] = scene.slots.taken(slot) && same_place(scene.drawings[slot], d);
    }

    for (std::uint32_t slot = 0; slot < scene.drawings.size(); ++slot)
        if (scene.slots.taken(slot)) scene.meshes.release(scene.drawings[slot].mesh);
    scene.slots.restore(taken, same);
    rows.resize(scene.slots.size());
    scene.drawings = std::move(rows);
    scene.order.clear();
    for (const std::uint32_t slot : saved.slots) {
        Drawing& d = scene.drawings[slot];
        const SavedMesh& mesh = saved.meshes[d.mesh];
        d.mesh = mesh.sliced            ? scene.meshes.take_sliced(mesh.corners)
                 : mesh.corners.empty() ? scene.meshes.take_circle(mesh.radius)
                                        : scene.meshes.take_polygon(mesh.corners, mesh.holes);
        scene.order.push_back({slot, scene.slots.generation(slot)});
    }
    scene.sorted = false;
    scene.next_serial = saved.next_serial;
    return true;
}

} // namespace evil::draw
