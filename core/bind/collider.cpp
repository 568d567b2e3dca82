// A look into the collider for tests: what its fast ways find, and what the plain ones say of the same.
#include "bind/visit.hpp"
#include "collider/broad_phase.hpp"
#include "collider/contacts.hpp"
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

namespace evil::bind {
namespace {

using PieceBounds = std::tuple<std::uint32_t, float, float, float, float, int>;
using PiecePair = std::tuple<std::uint32_t, std::uint32_t>;
using PointRow = std::tuple<float, float, float, std::uint32_t>;
using ManifoldRow = std::tuple<std::uint32_t, std::uint32_t, int, float, float, std::vector<PointRow>>;

std::vector<PieceBounds> bounds(World& w, float dt) {
    place_pieces(w.placed, w.shapes, w.bodies, dt, w.instruction_set, w.threads);
    std::vector<PieceBounds> list;
    const Placements& p = w.placed;
    for (std::uint32_t i = 0; i < p.octaves.size(); ++i)
        if (p.octaves[i] != kNoOctave)
            list.emplace_back(w.shapes.pieces[i].body, p.low_x[i], p.low_y[i], p.high_x[i], p.high_y[i], p.octaves[i]);
    return list;
}

std::vector<PiecePair> pairs(World& w, float dt) {
    place_pieces(w.placed, w.shapes, w.bodies, dt, w.instruction_set, w.threads);
    BroadPhase broad; // the world's own goes with the list of its contacts
    std::vector<Pair> found;
    find_pairs(broad, w.placed, found, w.instruction_set, w.threads);
    std::vector<PiecePair> list;
    for (Pair p : found) list.emplace_back(p.a, p.b);
    return list;
}

ManifoldRow row_of(const Contact& c) {
    std::vector<PointRow> points;
    for (std::size_t i = 0; i < c.count; ++i) {
        const ManifoldPoint& p = c.points[i];
        points.emplace_back(p.anchor_a.x, p.anchor_a.y, p.separation, p.id);
    }
    int axis = c.axis.known ? (c.axis.of_b ? -1 : 1) * (c.axis.edge + 1) : 0;
    return {c.piece_a, c.piece_b, axis, c.normal.x, c.normal.y, points};
}

// Of the pairs of the last step, where their bodies are now; the world is left as it is.
std::vector<ManifoldRow> manifolds(World& w, float dt, bool wide) {
    Contacts now;
    now.rows = w.contacts.rows;
    for (Contact& c : now.rows) c.fresh = true;
    place_pieces(w.placed, w.shapes, w.bodies, dt, w.instruction_set, w.threads);
    if (wide)
        update_manifolds(now, w.placed, w.shapes, w.bodies, dt, w.instruction_set, w.threads);
    else
        update_manifolds_one_by_one(now, w.shapes, w.bodies, dt);
    std::vector<ManifoldRow> list;
    for (const Contact& c : now.rows) list.push_back(row_of(c));
    return list;
}

} // namespace

void register_collider(nb::module_& module) {
    module.def("bounds_of_pieces", &bounds, nb::arg("world"), nb::arg("dt"),
               "For tests: body, low x, low y, high x, high y and octave of size of each piece's bounds.");
    module.def("pairs_of_pieces", &pairs, nb::arg("world"), nb::arg("dt"),
               "For tests: the pairs of pieces that the broad phase finds.");
    module.def(
        "manifolds_of_pairs", &manifolds, nb::arg("world"), nb::arg("dt"), nb::arg("wide"),
        "For tests: pieces, axis, normal and points (anchor x and y, separation, id) of each contact, found eight "
        "at a time or one by one.");
}

} // namespace evil::bind
