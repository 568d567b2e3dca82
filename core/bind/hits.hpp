#pragma once
// What queries find, for Python: one by one, or as columns of many.
#include "bind/handle.hpp"
#include <nanobind/ndarray.h>

namespace evil::bind {

struct Hit { // a RayHit, or a Nearest
    nb::object world;
    BodyRef body;
    ShapeRef shape;
    Vec2 point, normal;
    float value = 0.0f; // how far along the ray, or away
};
struct NearestHit : Hit {};

// Columns: a row for each question. A row without an answer has no body.
struct Hits {
    nb::object world;
    std::vector<BodyRef> body;
    std::vector<ShapeRef> shape;
    std::vector<std::int32_t> bodies, shapes; // slots, -1 for none
    std::vector<Vec2> points, normals;
    std::vector<float> values;

    explicit Hits(nb::object owner, std::size_t n);
    void set(const World& w, std::size_t row, std::uint32_t of_body, std::uint32_t of_shape, Vec2 point, Vec2 normal,
             float value);
};
struct NearestHits : Hits {
    using Hits::Hits;
};

// Bodies for each question: those of row i lie from starts[i] to starts[i + 1].
struct BodyLists {
    nb::object world;
    std::vector<BodyRef> body;
    std::vector<std::uint32_t> bodies, starts{0};
};

Hit hit_of(nb::handle owner, const World& w, std::uint32_t body, std::uint32_t shape, Vec2 point, Vec2 normal,
           float value);

} // namespace evil::bind
