// Manifolds of all contacts: those of common kinds eight at a time, the others one by one.
#include "collider/contacts.hpp"
#include "collider/manifolds_wide.hpp"
#include "collider/narrow_phase.hpp"
#include "collider/one_way.hpp"

namespace evil {
namespace {

// A switch of reference edge costs warm starting, so the other one must be better by this much (metres).
constexpr float kReferenceBias = 0.1f * kSlop;
constexpr std::size_t kGrain = 1024; // contacts a chunk: their rows stay in the cache from the first look to the last

enum Way { boxes, circles, box_circle, circle_box, polygons, polygon_circle, circle_polygon, one_by_one, kWays };

Way way_of(unsigned a, unsigned b) {
    constexpr Way kTable[4][4] = {
        {circles, circle_box, circle_polygon, one_by_one},
        {box_circle, boxes, polygons, one_by_one},
        {polygon_circle, polygons, polygons, one_by_one},
        {one_by_one, one_by_one, one_by_one, one_by_one},
    };
    return kTable[a][b];
}

using Kernel = void (*)(const FormTables&, const EightPairs&, EightManifolds&) noexcept;
Kernel kernel_for(std::size_t way, InstructionSet set) {
    switch (way) {
    case boxes:
        return EVIL_PICK(set, collide_boxes);
    case circles:
        return EVIL_PICK(set, collide_circles);
    case box_circle:
        return EVIL_PICK(set, collide_box_circle);
    case circle_box:
        return EVIL_PICK(set, collide_circle_box);
    case polygons:
        return EVIL_PICK(set, collide_polygons);
    case polygon_circle:
        return EVIL_PICK(set, collide_polygon_circle);
    default:
        return EVIL_PICK(set, collide_circle_polygon);
    }
}

void mix_materials(Contact& c, const Shapes& shapes) { // SPEC C5
    const Material &m = shapes.rows[shape_a(c, shapes)].material, &n = shapes.rows[shape_b(c, shapes)].material;
    c.friction = std::sqrt(m.friction * n.friction);
    c.restitution = std::max(m.restitution, n.restitution);
}

struct Sorted { // a chunk's contacts by the way their manifolds are found, as numbers from its first on
    std::uint16_t count[kWays] = {};
    std::uint16_t rows[kWays][kGrain];
    std::uint16_t one_ways = 0;
    std::uint16_t one_way[kGrain]; // whose passage is to be decided
};

// Some contacts and what is noted of them.
struct Chunk {
    std::span<Contact> rows;
    std::uint8_t* marks;
    Pair* bodies;
    void note(std::size_t row) const { marks[row] = (marks[row] & kSeamed) | marks_of(rows[row]); }
};

// Contacts of bodies at rest stay as they are, unless they are new: nothing has changed between them.
void sort_by_way(Sorted& sorted, const Chunk& chunk, const Placements& placed, const Shapes& shapes, bool mix) {
    const std::uint8_t* kinds = placed.kinds.data();
    auto [rows, marks, pairs] = chunk; // copies: bytes that are written might be anyone's
    for (std::size_t row = 0; row < rows.size(); ++row) {
        Contact& c = rows[row];
        __builtin_prefetch(&c + 8);
        __builtin_prefetch(reinterpret_cast<const char*>(&c + 8) + 64);
        unsigned a = kinds[c.piece_a], b = kinds[c.piece_b];
        marks[row] = (a | b) & kNeighboured ? kSeamed : 0;
        pairs[row] = {c.body_a, c.body_b};
        if (mix || c.fresh) mix_materials(c, shapes);
        bool stays = !c.fresh && (a & b & kResting);
        if (c.fresh) c.fresh = false;
        if (stays || c.sensor()) { // sensors are looked at after the step: collider/events.cpp
            chunk.note(row);
            continue;
        }
        Way way = way_of(a & kFormKind, b & kFormKind);
        sorted.rows[way][sorted.count[way]++] = static_cast<std::uint16_t>(row);
        if (c.terms == Terms::one_way) sorted.one_way[sorted.one_ways++] = static_cast<std::uint16_t>(row);
    }
}

// What the points of the last step leave to those with their ids; without branches, which no one could foretell.
struct Impulses {
    std::uint32_t id[2];
    float normal[2], tangent[2];
    bool there[2];
    explicit Impulses(const Contact& c) : there{c.count > 0, c.count > 1} {
        for (int i = 0; i < 2; ++i) {
            id[i] = c.points[i].id;
            normal[i] = c.points[i].normal_impulse;
            tangent[i] = c.points[i].tangent_impulse;
        }
    }
    void give(ManifoldPoint& point) const {
        bool first = there[0] & (id[0] == point.id), second = there[1] & (id[1] == point.id);
        point.normal_impulse = second ? normal[1] : first ? normal[0] : 0.0f;
        point.tangent_impulse = second ? tangent[1] : first ? tangent[0] : 0.0f;
    }
};

std::int32_t packed(Axis axis) { return axis.known ? axis.edge | (axis.of_b ? kAxisOfB : 0) : kNoAxis; }

// The manifold of bodies that have parted stays as it was last: it says where they touched.
void take_over(Contact& c, const ManifoldSketch& sketch, const Body& a, const Body& b) {
    if (sketch.count == 0) {
        c.count = 0;
        return;
    }
    Impulses last(c);
    c.count = sketch.count;
    c.normal = sketch.normal;
    for (std::size_t i = 0; i < 2; ++i) {
        ManifoldPoint& point = c.points[i] = {};
        if (i >= c.count) continue;
        point.anchor_a = sketch.points[i].at - a.centre;
        point.anchor_b = sketch.points[i].at - b.centre;
        point.separation = sketch.points[i].separation;
        point.id = sketch.points[i].id;
        last.give(point);
    }
}

// A last eight that is not full repeats its last pair.
void update_eight(const Chunk& chunk, const Shapes& shapes, const FormTables& tables, std::size_t way,
                  std::span<const std::uint16_t> rows, InstructionSet set) {
    EightPairs pairs;
    EightManifolds manifolds;
    Contact* contacts[8];
    std::uint8_t marks[8];
    for (std::size_t i = 0; i < 8; ++i) {
        Contact& c = chunk.rows[rows[std::min(i, rows.size() - 1)]];
        contacts[i] = &c;
        pairs.a[i] = c.piece_a;
        pairs.b[i] = c.piece_b;
        pairs.axis[i] = packed(c.axis);
    }
    for (std::size_t i = 0; way >= polygons && i < 8; ++i) { // the others need none
        pairs.corners_a[i] = shapes.pieces[pairs.a[i]].count;
        pairs.corners_b[i] = shapes.pieces[pairs.b[i]].count;
    }
    kernel_for(way, set)(tables, pairs, manifolds);
    EVIL_PICK(set, take_over)(manifolds, contacts, marks);
    for (std::size_t i = 0; i < rows.size(); ++i) chunk.marks[rows[i]] |= marks[i];
}

// Contacts in advance of touching, so that a fast body is slowed just enough (SPEC C8); no further than half the smaller
// piece, since beyond that a face's plane says little about where the other will be.
float margin_of(const Piece& p, const Piece& q, const Body& a, const Body& b, float dt) {
    float arms = std::abs(a.spin) * p.reach + std::abs(b.spin) * q.reach;
    float path = dt * (length(b.velocity - a.velocity) + arms);
    return kMargin + std::min(path, 0.5f * std::min(p.reach, q.reach));
}

void update_one(Contact& c, const Shapes& shapes, const Bodies& bodies, float dt) {
    const Body &a = bodies.rows[c.body_a], &b = bodies.rows[c.body_b];
    const Piece &p = shapes.pieces[c.piece_a], &q = shapes.pieces[c.piece_b];
    float margin = margin_of(p, q, a, b, dt);
    take_over(c, collide(place(shapes, p, a.pose), place(shapes, q, b.pose), margin, c.axis), a, b);
}

} // namespace

void update_manifolds(Contacts& contacts, const Placements& placed, const Shapes& shapes, const Bodies& bodies,
                      float dt, InstructionSet set, Threads& threads) {
    bool mix = contacts.scratch.material_changes != shapes.material_changes;
    contacts.scratch.material_changes = shapes.material_changes;
    FormTables tables{reinterpret_cast<const float*>(placed.forms.data()),
                      reinterpret_cast<const float*>(shapes.few_corners.data()), kMargin, kReferenceBias};
    auto& s = contacts.scratch;
    s.marks.resize(contacts.rows.size());
    s.bodies.resize(contacts.rows.size());
    parallel_for(threads, contacts.rows.size(), kGrain, [&](std::size_t first, std::size_t last) {
        Chunk chunk{{&contacts.rows[first], last - first}, &s.marks[first], &s.bodies[first]};
        Sorted sorted;
        sort_by_way(sorted, chunk, placed, shapes, mix);
        for (std::size_t way = 0; way < one_by_one; ++way) {
            std::span<const std::uint16_t> rows(sorted.rows[way], sorted.count[way]);
            for (std::size_t i = 0; i < rows.size(); i += 8)
                update_eight(chunk, shapes, tables, way, rows.subspan(i, std::min<std::size_t>(8, rows.size() - i)),
                             set);
        }
        for (std::size_t i = 0; i < sorted.count[one_by_one]; ++i) {
            update_one(chunk.rows[sorted.rows[one_by_one][i]], shapes, bodies, dt);
            chunk.note(sorted.rows[one_by_one][i]);
        }
        for (std::size_t i = 0; i < sorted.one_ways; ++i) {
            decide_passage(chunk.rows[sorted.one_way[i]], shapes, bodies, dt);
            chunk.note(sorted.one_way[i]);
        }
    });
}

void update_manifolds_one_by_one(Contacts& contacts, const Shapes& shapes, const Bodies& bodies, float dt) {
    for (Contact& c : contacts.rows) update_one(c, shapes, bodies, dt);
}

} // namespace evil
