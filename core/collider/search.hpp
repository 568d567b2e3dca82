#pragma once
// Questions to the whole world (SPEC C9): rays, points, overlaps and what is nearest. They change nothing.
#include "collider/queries.hpp"
#include "collider/tree.hpp"

namespace evil {

// What a query needs of a piece, in the order of the tree, so that neighbours lie side by side in memory too.
struct Target {
    Piece piece;
    Pose pose;
    BodyKind kind;
    bool alone; // the only piece of its shape
    bool sensor;
    std::uint32_t category;
};

// Where the pieces are, for queries alone: two trees, brought up to date when something is asked. What never asks, pays
// nothing.
struct Search {                     // Scratch
    Tree trees[2];                  // of static bodies, of others
    std::vector<Target> targets[2]; // by place in the tree
    struct Place {
        std::uint32_t tree = kNone, place = 0;
    };
    std::vector<Place> places; // by piece
    std::vector<TreeItem> items;

    std::uint64_t packed = 0; // Shapes::packed of the targets' pieces

    // What happened since:
    bool remade = true;                // more than can be told one by one
    bool moved = false;                // a step: all that moves
    std::vector<std::uint32_t> edited; // bodies that were added, changed, moved by hand or destroyed
};

inline void note_edit(Search& search, std::uint32_t body) {
    constexpr std::size_t kMost = 1u << 16; // nobody has asked for long
    if (search.remade || (!search.edited.empty() && search.edited.back() == body)) return;
    search.edited.push_back(body);
    search.remade = search.edited.size() > kMost;
}

struct Filter {                             // whom a query is about
    unsigned kinds = 7;                     // bit i: bodies of BodyKind i
    bool sensors = false;                   // sensors too
    std::uint32_t mask = 0xffffffffu;       // shapes with a category in it
    std::span<const std::uint32_t> ignored; // bodies, by slot
};

struct RayHit {
    std::uint32_t shape = kNone, body = kNone;
    Vec2 point, normal; // where the segment enters; the normal points out of the shape
    float fraction = 1.0f;
};

struct NearHit {
    std::uint32_t shape = kNone, body = kNone;
    Vec2 point;
    float distance = 0.0f;
};

// A world's tables and its index, up to date.
struct Scene {
    const Shapes& shapes;
    const Bodies& bodies;
    Search& search;
    InstructionSet set;
};
void refresh(Search& search, const Shapes& shapes, const Bodies& bodies);

// The first shape that the segment enters; of those at the same place, the one that was created first. A shape that it
// starts in does not count.
std::optional<RayHit> ray_cast(const Scene& scene, Vec2 start, Vec2 end, const Filter& filter);
// All shapes that it enters, from start to end, each once.
void ray_cast_all(const Scene& scene, Vec2 start, Vec2 end, const Filter& filter, std::vector<RayHit>& hits);

// The shape nearest to the point and not farther than `within`; of those as near, the one that was created first.
std::optional<NearHit> nearest(const Scene& scene, Vec2 point, float within, const Filter& filter);

// Bodies with a shape over the point, or overlapping any of the pieces of `probe` (placed in world coordinates), in
// creation order.
void bodies_at(const Scene& scene, Vec2 point, const Filter& filter, std::vector<std::uint32_t>& found);
void bodies_overlapping(const Scene& scene, const Shapes& probe, const Filter& filter,
                        std::vector<std::uint32_t>& found);

} // namespace evil
