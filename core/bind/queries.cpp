// Queries for Python, one at a time and in batches.
#include "bind/hits.hpp"
#include "bind/values.hpp"
#include "collider/shape_casts.hpp"

namespace evil::bind {

NewShape used(const NewShape& spec, nb::handle offset, double angle, float density, float friction, float restitution);
void register_hits(nb::module_& module);

namespace {

// Whom to ask about, as the face gives it: kinds as bits, the next one for sensors; categories; and a tuple of slots.
struct Asked {
    Asked(unsigned kinds, std::uint32_t mask, nb::handle ignored)
        : slots(nb::cast<std::vector<std::uint32_t>>(ignored)) {
        filter = {kinds & 7u, (kinds & 8u) != 0, mask, slots};
    }
    Asked(const Asked&) = delete;
    Asked& operator=(const Asked&) = delete;
    std::vector<std::uint32_t> slots;
    Filter filter;
};

Vec2 to_place(nb::handle value, const char* owner, const char* argument) {
    Vec2 at = to_vec2(value, owner, argument);
    if (!(length(at) <= kWorldEdge))
        raise(ErrorKind::argument, std::string(owner) + ": " + argument + "=" + nb::cast<std::string>(nb::repr(value)) +
                                       " must be within 1e+07 metres of the origin");
    return at;
}

OneOrMany<Vec2> to_places(nb::handle source, const char* owner, const char* argument) {
    return to_point_or_points(source, owner, argument, kPlaces);
}

// How many questions two lists ask together: as many as either, one that is single stands for all.
std::size_t rows_of(std::size_t n, bool n_single, std::size_t m, bool m_single, const char* owner, const char* words) {
    if (n_single) return m;
    if (!m_single && n != m)
        raise(ErrorKind::argument, std::string(owner) + ": " + words + " must be as many; got " + std::to_string(n) +
                                       " and " + std::to_string(m));
    return n;
}

struct Probe { // a shape that is asked with, in world coordinates
    Shapes shapes;
    std::uint32_t slot;
    explicit Probe(const NewShape& spec) : slot(add_shape_row(shapes, spec.shape, spec.rings, spec.parts)) {}
    void put(Vec2 at, double angle) {
        shapes.rows[slot].local = affine(Pose{at, rotation(angle)});
        bake(shapes, slot, {1, 1});
    }
};

Hit to_hit(nb::handle owner, const World& w, const RayHit& hit) {
    return hit_of(owner, w, hit.body, hit.shape, hit.point, hit.normal, hit.fraction);
}

nb::object cast_ray(World& w, nb::handle owner, nb::handle start, nb::handle end, unsigned kinds, std::uint32_t mask,
                    nb::handle ignored) {
    Vec2 s = to_place(start, "World.ray_cast", "start"), e = to_place(end, "World.ray_cast", "end");
    Asked asked(kinds, mask, ignored);
    std::optional<RayHit> hit = ray_cast(w.scene(), s, e, asked.filter);
    return hit ? nb::cast(to_hit(owner, w, *hit)) : nb::none();
}

nb::object cast_ray_all(World& w, nb::handle owner, nb::handle start, nb::handle end, unsigned kinds,
                        std::uint32_t mask, nb::handle ignored) {
    Vec2 s = to_place(start, "World.ray_cast_all", "start"), e = to_place(end, "World.ray_cast_all", "end");
    Asked asked(kinds, mask, ignored);
    std::vector<RayHit> hits;
    ray_cast_all(w.scene(), s, e, asked.filter, hits);
    nb::list list;
    for (const RayHit& hit : hits) list.append(to_hit(owner, w, hit));
    return nb::tuple(list);
}

Hits* cast_rays(World& w, nb::handle owner, nb::handle starts, nb::handle ends, unsigned kinds, std::uint32_t mask,
                nb::handle ignored) {
    auto s = to_places(starts, "World.ray_casts", "starts"), e = to_places(ends, "World.ray_casts", "ends");
    std::size_t n = rows_of(s.rows.size(), s.one, e.rows.size(), e.one, "World.ray_casts", "starts and ends");
    Asked asked(kinds, mask, ignored);
    auto hits = std::make_unique<Hits>(nb::borrow(owner), n);
    Meanwhile others(n >= kManyQuestions);
    Scene scene = w.scene();
    std::optional<Threads::Shift> shift;
    if (n >= kManyQuestions) shift.emplace(w.threads);
    parallel_for(w.threads, n, 256, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            std::optional<RayHit> hit = ray_cast(scene, s.at(i), e.at(i), asked.filter);
            if (hit)
                hits->set(w, i, hit->body, hit->shape, hit->point, hit->normal, hit->fraction);
            else
                hits->points[i] = e.at(i), hits->values[i] = 1.0f;
        }
    });
    return hits.release();
}

nb::object cast_shape(World& w, nb::handle owner, const NewShape& spec, nb::handle start, nb::handle end, double angle,
                      unsigned kinds, std::uint32_t mask, nb::handle ignored) {
    Vec2 s = to_place(start, "World.shape_cast", "start"), e = to_place(end, "World.shape_cast", "end");
    Asked asked(kinds, mask, ignored);
    Probe probe(spec);
    probe.put(s, angle);
    std::optional<RayHit> hit = shape_cast(w.scene(), probe.shapes, e - s, asked.filter);
    return hit ? nb::cast(to_hit(owner, w, *hit)) : nb::none();
}

nb::object cast_shape_all(World& w, nb::handle owner, const NewShape& spec, nb::handle start, nb::handle end,
                          double angle, unsigned kinds, std::uint32_t mask, nb::handle ignored) {
    Vec2 s = to_place(start, "World.shape_cast_all", "start"), e = to_place(end, "World.shape_cast_all", "end");
    Asked asked(kinds, mask, ignored);
    Probe probe(spec);
    probe.put(s, angle);
    std::vector<RayHit> hits;
    shape_cast_all(w.scene(), probe.shapes, e - s, asked.filter, hits);
    nb::list list;
    for (const RayHit& hit : hits) list.append(to_hit(owner, w, hit));
    return nb::tuple(list);
}

Hits* cast_shapes(World& w, nb::handle owner, const NewShape& spec, nb::handle starts, nb::handle ends,
                  nb::handle angles, unsigned kinds, std::uint32_t mask, nb::handle ignored) {
    const char* me = "World.shape_casts";
    auto s = to_places(starts, me, "starts"), e = to_places(ends, me, "ends");
    auto a = to_number_or_numbers(angles, me, "angle", kFinite);
    std::size_t n = rows_of(s.rows.size(), s.one, e.rows.size(), e.one, me, "starts and ends");
    n = rows_of(n, s.one && e.one, a.rows.size(), a.one, me, "ways and angles");
    Asked asked(kinds, mask, ignored);
    Probe probe(spec);
    auto hits = std::make_unique<Hits>(nb::borrow(owner), n);
    Meanwhile others(n >= kManyQuestions);
    Scene scene = w.scene();
    for (std::size_t i = 0; i < n; ++i) {
        probe.put(s.at(i), a.at(i));
        std::optional<RayHit> hit = shape_cast(scene, probe.shapes, e.at(i) - s.at(i), asked.filter);
        if (hit)
            hits->set(w, i, hit->body, hit->shape, hit->point, hit->normal, hit->fraction);
        else
            hits->points[i] = e.at(i), hits->values[i] = 1.0f;
    }
    return hits.release();
}

nb::object find_nearest(World& w, nb::handle owner, nb::handle point, float within, unsigned kinds, std::uint32_t mask,
                        nb::handle ignored) {
    Vec2 p = to_place(point, "World.nearest", "point");
    Asked asked(kinds, mask, ignored);
    std::optional<NearHit> near = nearest(w.scene(), p, within, asked.filter);
    if (!near) return nb::none();
    return nb::cast(NearestHit{hit_of(owner, w, near->body, near->shape, near->point, {}, near->distance)});
}

NearestHits* find_nearest_each(World& w, nb::handle owner, nb::handle points, float within, unsigned kinds,
                               std::uint32_t mask, nb::handle ignored) {
    auto p = to_places(points, "World.nearest_each", "points");
    Asked asked(kinds, mask, ignored);
    auto hits = std::make_unique<NearestHits>(nb::borrow(owner), p.rows.size());
    Meanwhile others(p.rows.size() >= kManyQuestions);
    Scene scene = w.scene();
    for (std::size_t i = 0; i < p.rows.size(); ++i) {
        std::optional<NearHit> near = nearest(scene, p.rows[i], within, asked.filter);
        if (near)
            hits->set(w, i, near->body, near->shape, near->point, {}, near->distance);
        else
            hits->points[i] = p.rows[i], hits->values[i] = HUGE_VALF;
    }
    return hits.release();
}

std::vector<std::uint32_t> find_at(World& w, nb::handle point, unsigned kinds, std::uint32_t mask, nb::handle ignored) {
    Vec2 p = to_vec2(point, "World.bodies_at", "point");
    Asked asked(kinds, mask, ignored);
    std::vector<std::uint32_t> found;
    bodies_at(w.scene(), p, asked.filter, found);
    return found;
}

std::vector<std::uint32_t> find_overlapping(World& w, const NewShape& spec, nb::handle at, double angle, unsigned kinds,
                                            std::uint32_t mask, nb::handle ignored) {
    Vec2 p = to_place(at, "World.overlapping", "at");
    Asked asked(kinds, mask, ignored);
    Probe probe(spec);
    probe.put(p, angle);
    std::vector<std::uint32_t> found;
    bodies_overlapping(w.scene(), probe.shapes, asked.filter, found);
    return found;
}

void add_list(BodyLists& lists, const World& w, const std::vector<std::uint32_t>& found) {
    for (std::uint32_t body : found) {
        lists.body.push_back({body, w.bodies.slots.generation(body)});
        lists.bodies.push_back(body);
    }
    lists.starts.push_back(static_cast<std::uint32_t>(lists.bodies.size()));
}

BodyLists* find_at_each(World& w, nb::handle owner, nb::handle points, unsigned kinds, std::uint32_t mask,
                        nb::handle ignored) {
    auto p = to_point_or_points(points, "World.bodies_at_each", "points", kFinite);
    Asked asked(kinds, mask, ignored);
    auto lists = std::make_unique<BodyLists>(BodyLists{nb::borrow(owner), {}, {}});
    std::vector<std::uint32_t> found;
    Meanwhile others(p.rows.size() >= kManyQuestions);
    Scene scene = w.scene();
    for (Vec2 point : p.rows) {
        bodies_at(scene, point, asked.filter, found);
        add_list(*lists, w, found);
    }
    return lists.release();
}

BodyLists* find_overlapping_each(World& w, nb::handle owner, const NewShape& spec, nb::handle at, nb::handle angles,
                                 unsigned kinds, std::uint32_t mask, nb::handle ignored) {
    const char* me = "World.overlapping_each";
    auto p = to_places(at, me, "at");
    auto a = to_number_or_numbers(angles, me, "angle", kFinite);
    std::size_t n = rows_of(p.rows.size(), p.one, a.rows.size(), a.one, me, "points and angles");
    Asked asked(kinds, mask, ignored);
    auto lists = std::make_unique<BodyLists>(BodyLists{nb::borrow(owner), {}, {}});
    Probe probe(spec);
    std::vector<std::uint32_t> found;
    Meanwhile others(n >= kManyQuestions);
    Scene scene = w.scene();
    for (std::size_t i = 0; i < n; ++i) {
        probe.put(p.at(i), a.at(i));
        bodies_overlapping(scene, probe.shapes, asked.filter, found);
        add_list(*lists, w, found);
    }
    return lists.release();
}

} // namespace

void bind_queries(nb::module_& module, nb::class_<World>& c) {
    register_hits(module);
    c.def("ray_cast", cast_ray, nb::arg("owner"), nb::arg("start").none(), nb::arg("end").none(), nb::arg("kinds"),
          nb::arg("mask"), nb::arg("ignored"),
          nb::sig("def ray_cast(self, owner: object, start: object, end: object, kinds: int, mask: int, ignored: "
                  "tuple[int, ...]) "
                  "-> RayHit | None"));
    c.def("ray_cast_all", cast_ray_all, nb::arg("owner"), nb::arg("start").none(), nb::arg("end").none(),
          nb::arg("kinds"), nb::arg("mask"), nb::arg("ignored"),
          nb::sig("def ray_cast_all(self, owner: object, start: object, end: object, kinds: int, mask: int, ignored: "
                  "tuple[int, "
                  "...]) -> tuple[RayHit, ...]"));
    c.def("ray_casts", cast_rays, nb::arg("owner"), nb::arg("starts").none(), nb::arg("ends").none(), nb::arg("kinds"),
          nb::arg("mask"), nb::arg("ignored"));
    c.def("shape_cast", cast_shape, nb::arg("owner"), nb::arg("shape"), nb::arg("start").none(), nb::arg("end").none(),
          nb::arg("angle"), nb::arg("kinds"), nb::arg("mask"), nb::arg("ignored"),
          nb::sig("def shape_cast(self, owner: object, shape: ShapeSpec, start: object, end: object, angle: float, "
                  "kinds: int, mask: int, ignored: tuple[int, ...]) -> RayHit | None"));
    c.def("shape_cast_all", cast_shape_all, nb::arg("owner"), nb::arg("shape"), nb::arg("start").none(),
          nb::arg("end").none(), nb::arg("angle"), nb::arg("kinds"), nb::arg("mask"), nb::arg("ignored"),
          nb::sig("def shape_cast_all(self, owner: object, shape: ShapeSpec, start: object, end: object, angle: float, "
                  "kinds: int, mask: int, ignored: tuple[int, ...]) -> tuple[RayHit, ...]"));
    c.def("shape_casts", cast_shapes, nb::arg("owner"), nb::arg("shape"), nb::arg("starts").none(),
          nb::arg("ends").none(), nb::arg("angle").none(), nb::arg("kinds"), nb::arg("mask"), nb::arg("ignored"));
    c.def(
        "nearest", find_nearest, nb::arg("owner"), nb::arg("point").none(), nb::arg("within"), nb::arg("kinds"),
        nb::arg("mask"), nb::arg("ignored"),
        nb::sig(
            "def nearest(self, owner: object, point: object, within: float, kinds: int, mask: int, ignored: tuple[int, "
            "...]) -> Nearest | None"));
    c.def("nearest_each", find_nearest_each, nb::arg("owner"), nb::arg("points").none(), nb::arg("within"),
          nb::arg("kinds"), nb::arg("mask"), nb::arg("ignored"));
    c.def("bodies_at", find_at, nb::arg("point").none(), nb::arg("kinds"), nb::arg("mask"), nb::arg("ignored"));
    c.def("bodies_at_each", find_at_each, nb::arg("owner"), nb::arg("points").none(), nb::arg("kinds"), nb::arg("mask"),
          nb::arg("ignored"));
    c.def("overlapping", find_overlapping, nb::arg("shape"), nb::arg("at").none(), nb::arg("angle"), nb::arg("kinds"),
          nb::arg("mask"), nb::arg("ignored"));
    c.def("overlapping_each", find_overlapping_each, nb::arg("owner"), nb::arg("shape"), nb::arg("at").none(),
          nb::arg("angle").none(), nb::arg("kinds"), nb::arg("mask"), nb::arg("ignored"));
}

} // namespace evil::bind
