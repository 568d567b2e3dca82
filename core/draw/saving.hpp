#pragma once
// What is drawn as bytes: every drawing and the shapes they share, little-endian, by slot. The container that holds them
// has the checksum; here, bytes are believed only when everything they name is there.
#include "draw/scene.hpp"
#include "world.hpp"
#include <memory>

namespace evil::draw {

struct SceneBytes {
    std::vector<std::uint8_t> bytes;
    std::vector<std::uint32_t> textures; // the ids in use; `bytes` counts them 1, 2, ... as they stand here
    std::vector<std::uint32_t> clips;    // likewise
};
SceneBytes snapshot(const Scene& scene, const World& world); // without drawings whose body or shape is gone

struct SavedMesh {
    float radius = 0.0f; // of a circle; a polygon has corners
    std::vector<Vertex> corners;
    bool sliced = false;
    std::vector<std::uint32_t> holes; // the first corner of each
};

struct SavedScene {
    std::vector<SavedMesh> meshes;
    std::vector<std::uint32_t> slots; // rising
    std::vector<Drawing> drawings;    // as `slots`; generations are not known yet
    std::uint64_t next_serial = 0;
    std::uint32_t textures = 0, clips = 0; // how many there must be
};
std::shared_ptr<const SavedScene> read_scene(std::span<const std::uint8_t> bytes); // null when they are no whole scene

// Become what was saved, for a world that has been restored already: false, and nothing changes, when a body or a shape
// that a drawing is on is not there. Drawings that are the same before and after keep their references.
bool restore(Scene& scene, const SavedScene& saved, const World& world, std::span<const std::uint32_t> textures,
             std::span<const std::uint32_t> clips);

} // namespace evil::draw
