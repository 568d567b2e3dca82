// _core.DrawList: geometry and instances, ready for a renderer. The scene fills one from C++; the methods here build small
// ones by hand, for tests and tools. Every index is checked on the way in, so that a renderer need not trust its caller.
#include "draw/draw_list.hpp"
#include "bind/convert.hpp"
#include "shapes/polygon.hpp"
#include <limits>

namespace evil::bind {
namespace {

using draw::DrawList;

constexpr std::size_t kMostCorners = 1u << 20;

[[noreturn]] void refuse(const char* method, const std::string& what) {
    raise(ErrorKind::argument, std::string("DrawList.") + method + ": " + what);
}

std::size_t length_of(nb::handle list, const char* method, const char* argument) {
    Py_ssize_t length = PySequence_Check(list.ptr()) ? PySequence_Size(list.ptr()) : -1;
    PyErr_Clear();
    if (length < 0)
        raise(ErrorKind::argument_type, std::string("DrawList.") + method + ": " + argument + " must be a sequence");
    return static_cast<std::size_t>(length);
}

nb::object item(nb::handle list, std::size_t index) {
    nb::object value = nb::steal(PySequence_GetItem(list.ptr(), static_cast<Py_ssize_t>(index)));
    if (!value.is_valid()) throw nb::python_error();
    return value;
}

template <class T> T to_unsigned(nb::handle value, const char* method, const char* argument) {
    unsigned long long number = PyLong_Check(value.ptr()) ? PyLong_AsUnsignedLongLong(value.ptr()) : 0;
    bool bad = !PyLong_Check(value.ptr()) || PyErr_Occurred() || number > std::numeric_limits<T>::max();
    PyErr_Clear();
    if (bad) refuse(method, std::string(argument) + " must be an integer from 0 to 2**32 - 1");
    return static_cast<T>(number);
}

// Six numbers a b c d tx ty. NaN and infinity may pass: a renderer has to bear whatever a scene computes.
Affine to_affine(nb::handle value, const char* argument) {
    if (value.is_none()) return {};
    if (length_of(value, "instance", argument) != 6)
        refuse("instance", std::string(argument) + " must hold six numbers: a b c d tx ty");
    float number[6];
    for (std::size_t i = 0; i < 6; ++i) {
        double each = PyFloat_AsDouble(item(value, i).ptr());
        if (PyErr_Occurred()) throw nb::python_error();
        number[i] = static_cast<float>(each);
    }
    return {number[0], number[1], number[2], number[3], number[4], number[5]};
}

// Texture coordinates that span the polygon's bounding box, v down.
void spread_uvs(std::vector<draw::Vertex>& corners) {
    Vec2 low = corners[0].at, high = low;
    for (const draw::Vertex& corner : corners) low = min(low, corner.at), high = max(high, corner.at);
    Vec2 size = high - low;
    for (draw::Vertex& corner : corners)
        corner.uv = {size.x > 0 ? (corner.at.x - low.x) / size.x : 0.0f,
                     size.y > 0 ? (high.y - corner.at.y) / size.y : 0.0f};
}

// Corner numbers of triangles as given, or found here. A polygon that crosses itself has none: it is drawn flat.
std::vector<std::uint32_t> to_triangles(nb::handle value, std::span<const draw::Vertex> corners) {
    std::vector<std::uint32_t> triangles;
    if (value.is_none()) {
        std::vector<Vec2> points;
        for (const draw::Vertex& corner : corners) points.push_back(corner.at);
        if (points.size() > kMaxCorners || !triangulate(points, triangles)) triangles.clear();
        return triangles;
    }
    std::size_t count = length_of(value, "polygon", "triangles");
    if (count % 3 != 0 || count > 3 * kMostCorners) refuse("polygon", "triangles must hold three indices each");
    for (std::size_t i = 0; i < count; ++i) {
        triangles.push_back(to_unsigned<std::uint32_t>(item(value, i), "polygon", "triangles"));
        if (triangles.back() >= corners.size()) refuse("polygon", "triangles must index the points");
    }
    return triangles;
}

std::uint32_t polygon(DrawList& list, nb::handle points, nb::handle uvs, nb::handle colours, nb::handle triangles) {
    std::size_t count = length_of(points, "polygon", "points");
    if (count < 3 || count > kMostCorners)
        refuse("polygon", "points must be at least 3 and at most 2**20, got " + std::to_string(count));
    std::vector<draw::Vertex> corners(count);
    for (std::size_t i = 0; i < count; ++i) corners[i].at = to_vec2(item(points, i), "DrawList.polygon", "points");
    spread_uvs(corners);
    if (!uvs.is_none()) {
        if (length_of(uvs, "polygon", "uvs") != count) refuse("polygon", "uvs must be as many as points");
        for (std::size_t i = 0; i < count; ++i) corners[i].uv = to_vec2(item(uvs, i), "DrawList.polygon", "uvs");
    }
    if (!colours.is_none()) {
        if (length_of(colours, "polygon", "colours") != count) refuse("polygon", "colours must be as many as points");
        for (std::size_t i = 0; i < count; ++i)
            corners[i].colour = to_unsigned<draw::Rgba8>(item(colours, i), "polygon", "colours");
    }
    return draw::add_polygon(list, corners, to_triangles(triangles, corners));
}

std::uint32_t circle(DrawList& list, nb::handle radius, nb::handle at, nb::handle colour) {
    draw::Vertex centre;
    centre.at = to_vec2(at, "DrawList.circle", "at");
    centre.colour = to_unsigned<draw::Rgba8>(colour, "circle", "colour");
    float size = to_float(radius, "DrawList.circle", "radius");
    if (size < 0.0f) refuse("circle", "radius must not be negative");
    return draw::add_circle(list, centre, size);
}

void instance(DrawList& list, nb::handle mesh, nb::handle to_pixel, nb::handle tint, nb::handle texture, double outline,
              nb::handle to_texture, std::uint32_t blend) {
    draw::Instance result;
    result.mesh = to_unsigned<std::uint32_t>(mesh, "instance", "mesh");
    if (result.mesh >= list.meshes.size())
        refuse("instance", "mesh must be an index that polygon() or circle() gave, since the last clear()");
    result.to_pixel = to_affine(to_pixel, "to_pixel");
    result.to_texture = to_affine(to_texture, "to_texture");
    result.tint = to_unsigned<draw::Rgba8>(tint, "instance", "tint");
    result.texture = to_unsigned<std::uint32_t>(texture, "instance", "texture");
    result.outline = static_cast<float>(outline);
    if (blend >= draw::kBlends) refuse("instance", "blend must be 0 (over), 1 (add), 2 (multiply) or 3 (screen)");
    result.blend = static_cast<draw::Blend>(blend);
    list.instances.push_back(result);
}

} // namespace

void register_draw_list(nb::module_& module) {
    nb::class_<DrawList>(module, "DrawList",
                         "Meshes and instances to draw, back to front; see core/draw/draw_list.hpp.")
        .def(nb::init<>())
        .def(
            "clear", [](DrawList& list) { draw::clear(list); }, "Forget every mesh and instance; keeps the memory.")
        .def("polygon", &polygon, nb::arg("points"), nb::kw_only(), nb::arg("uvs") = nb::none(),
             nb::arg("colours") = nb::none(), nb::arg("triangles") = nb::none(),
             "Add a polygon and return its mesh's index. uvs default to the bounding box; colours are 0xAABBGGRR.")
        .def("circle", &circle, nb::arg("radius"), nb::kw_only(), nb::arg("at") = nb::make_tuple(0.0, 0.0),
             nb::arg("colour") = 0xffffffffu, "Add a circle and return its mesh's index.")
        .def("instance", &instance, nb::arg("mesh"), nb::arg("to_pixel") = nb::none(), nb::kw_only(),
             nb::arg("tint") = 0xffffffffu, nb::arg("texture") = 0u, nb::arg("outline") = 0.0,
             nb::arg("to_texture") = nb::none(), nb::arg("blend") = 0u,
             "Draw a mesh once more, on top: matrices as a b c d tx ty, tint as 0xAABBGGRR, outline in pixels.")
        .def_prop_ro("vertex_count", [](const DrawList& list) { return list.vertices.size(); })
        .def_prop_ro("index_count", [](const DrawList& list) { return list.indices.size(); })
        .def_prop_ro("mesh_count", [](const DrawList& list) { return list.meshes.size(); })
        .def_prop_ro("instance_count", [](const DrawList& list) { return list.instances.size(); });
}

} // namespace evil::bind
