// Polygons for Python: what is wrong with one, its mass, its triangles and convex parts.
#include "bind/shapes.hpp"
#include "bind/convert.hpp"
#include "shapes/polygon.hpp"

namespace evil::bind {
namespace {

using Part = std::vector<std::uint32_t>;

[[noreturn]] void not_corners(nb::handle points, const char* owner, const char* argument) {
    raise(ErrorKind::argument_type, std::string(owner) + ": " + argument + " must be a sequence of points, such as " +
                                        "[(0, 0), (1, 0), (0, 1)]; got " + nb::type_name(points.type()).c_str());
}

float coordinate(nb::handle pair, Py_ssize_t index, bool& good) {
    nb::object item = nb::steal(PySequence_GetItem(pair.ptr(), index));
    double value = item.is_valid() ? PyFloat_AsDouble(item.ptr()) : -1.0;
    if (PyErr_Occurred()) {
        bool huge =
            PyErr_ExceptionMatches(PyExc_OverflowError); // an integer beyond double is too large, not the wrong type
        PyErr_Clear();
        good = good && huge;
        return HUGE_VALF;
    }
    return static_cast<float>(value);
}

nb::list to_list(const Part& numbers) {
    nb::list list;
    for (std::uint32_t number : numbers) list.append(number);
    return list;
}

OwnedRings read_rings(nb::handle points, nb::handle holes, const char* owner, const char* argument) {
    OwnedRings rings{to_corners(points, owner, argument), {}};
    Py_ssize_t count = !is_text(holes) && PySequence_Check(holes.ptr()) ? PySequence_Size(holes.ptr()) : -1;
    PyErr_Clear();
    if (count < 0)
        raise(ErrorKind::argument_type, std::string(owner) +
                                            ": holes must be a sequence, for each hole a sequence of " +
                                            "points; got " + nb::type_name(holes.type()).c_str());
    for (Py_ssize_t i = 0; i < count; ++i) {
        nb::object hole = nb::steal(PySequence_GetItem(holes.ptr(), i));
        if (!hole.is_valid()) throw nb::python_error();
        std::string name = "holes[" + std::to_string(i) + "]";
        std::vector<Vec2> corners = to_corners(hole, owner, name.c_str());
        rings.holes.push_back(static_cast<std::uint32_t>(rings.corners.size()));
        rings.corners.insert(rings.corners.end(), corners.begin(), corners.end());
    }
    return rings;
}

nb::object polygon_problem(nb::handle points, nb::handle holes) {
    OwnedRings rings = read_rings(points, holes, "polygon_problem", "points");
    PolygonProblem problem = check_polygon(rings);
    return problem.fault == PolygonFault::none ? nb::none() : nb::cast(describe(problem, rings));
}

nb::list triangulate_points(nb::handle points, nb::handle holes) {
    OwnedRings rings = to_rings(points, holes, "triangulate", "points");
    Part indices;
    triangulate(rings, indices);
    nb::list triangles;
    for (std::size_t i = 0; i < indices.size(); i += 3)
        triangles.append(nb::make_tuple(indices[i], indices[i + 1], indices[i + 2]));
    return triangles;
}

nb::list split_points(nb::handle points, nb::handle holes) {
    OwnedRings rings = to_rings(points, holes, "split_convex", "points");
    nb::list parts;
    for (const Part& part : split_convex(rings)) parts.append(to_list(part));
    return parts;
}

nb::tuple mass_tuple(const MassProperties& m) { return nb::make_tuple(m.mass, m.inertia, from_vec2(m.centre)); }

} // namespace

std::vector<Vec2> to_corners(nb::handle points, const char* owner, const char* argument) {
    Py_ssize_t count = !is_text(points) && PySequence_Check(points.ptr()) ? PySequence_Size(points.ptr()) : -1;
    PyErr_Clear();
    if (count < 0) not_corners(points, owner, argument);
    std::vector<Vec2> corners;
    corners.reserve(static_cast<std::size_t>(count));
    for (Py_ssize_t i = 0; i < count; ++i) {
        nb::object pair = nb::steal(PySequence_GetItem(points.ptr(), i));
        bool good =
            pair.is_valid() && !is_text(pair) && PySequence_Check(pair.ptr()) && PySequence_Size(pair.ptr()) == 2;
        PyErr_Clear();
        Vec2 corner;
        if (good) corner = {coordinate(pair, 0, good), coordinate(pair, 1, good)};
        if (!good)
            raise(ErrorKind::argument_type, std::string(owner) + ": " + argument + "[" + std::to_string(i) +
                                                "] must be a point, a pair of numbers such as (0, 1)");
        corners.push_back(corner);
    }
    return corners;
}

OwnedRings to_rings(nb::handle points, nb::handle holes, const char* owner, const char* argument) {
    OwnedRings rings = read_rings(points, holes, owner, argument);
    refuse_bad_polygon(rings, owner, argument);
    return rings;
}

void refuse_bad_polygon(const Rings& rings, const char* owner, const char* argument) {
    PolygonProblem problem = check_polygon(rings);
    if (problem.fault != PolygonFault::none)
        raise(ErrorKind::shape, std::string(owner) + ": " + argument + ": " + describe(problem, rings));
}

void register_shapes(nb::module_& module) {
    module.def("polygon_problem", &polygon_problem, nb::arg("points").none(), nb::arg("holes") = nb::make_tuple(),
               nb::sig("def polygon_problem(points: object, holes: object = ()) -> str | None"),
               "What is wrong with a polygon, in words, or None when it is simple and of a size that works.");
    module.def(
        "triangulate", &triangulate_points, nb::arg("points").none(), nb::arg("holes") = nb::make_tuple(),
        nb::sig("def triangulate(points: object, holes: object = ()) -> list[tuple[int, int, int]]"),
        "Counter-clockwise triangles of corner numbers that fill a simple polygon, without new corners. Those of "
        "holes are counted on from the outline's.");
    module.def(
        "split_convex", &split_points, nb::arg("points").none(), nb::arg("holes") = nb::make_tuple(),
        nb::sig("def split_convex(points: object, holes: object = ()) -> list[list[int]]"),
        "Few convex, counter-clockwise parts of corner numbers that fill a simple polygon, without new corners.");
    module.def(
        "convex_hull",
        [](nb::handle points) {
            std::vector<Vec2> corners = to_corners(points, "convex_hull", "points");
            for (Vec2 corner : corners)
                if (!is_finite(corner))
                    raise(ErrorKind::argument, "convex_hull: points must be finite; NaN or infinity came in");
            return to_list(convex_hull(corners));
        },
        nb::arg("points").none(), nb::sig("def convex_hull(points: object) -> list[int]"),
        "Numbers of the points on the convex hull, counter-clockwise from the leftmost.");
    module.def(
        "signed_area", [](nb::handle points) { return signed_area(to_corners(points, "signed_area", "points")); },
        nb::arg("points").none(), "Area in square metres, positive when the corners run counter-clockwise.");
    module.def(
        "is_convex",
        [](nb::handle points) {
            std::vector<Vec2> corners = to_corners(points, "is_convex", "points");
            make_counter_clockwise(corners);
            return is_convex(corners);
        },
        nb::arg("points").none(), "Does a simple polygon turn one way only? Straight corners are allowed.");
    module.def(
        "polygon_mass",
        [](nb::handle points, float density) {
            std::vector<Vec2> corners = to_corners(points, "polygon_mass", "points");
            return mass_tuple(polygon_mass(corners, density));
        },
        nb::arg("points").none(), nb::arg("density") = 1.0f,
        nb::sig("def polygon_mass(points: object, density: float = 1.0) -> tuple[float, float, tuple[float, float]]"),
        "(mass, second moment about the centre, centre) of a simple polygon.");
    module.def(
        "circle_mass", [](float radius, float density) { return mass_tuple(circle_mass(radius, density)); },
        nb::arg("radius"), nb::arg("density") = 1.0f,
        nb::sig("def circle_mass(radius: float, density: float = 1.0) -> tuple[float, float, tuple[float, float]]"),
        "(mass, second moment about the centre, centre) of a circle.");
}

} // namespace evil::bind
