#include "bind/values.hpp"
#include "bind/buffer.hpp"

namespace evil::bind {
namespace {

std::string name_of(const char* owner, const char* argument) { return std::string(owner) + ": " + argument; }

std::string place_of(const char* owner, const char* argument, std::size_t i) {
    return name_of(owner, argument) + "[" + std::to_string(i) + "]";
}

std::string text_of(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    return text;
}

std::string text_of(Vec2 value) {
    char text[64];
    std::snprintf(text, sizeof text, "(%.9g, %.9g)", double(value.x), double(value.y));
    return text;
}

[[noreturn]] void refuse(const char* owner, const char* argument, std::size_t i, const std::string& value,
                         Bounds bounds) {
    raise(ErrorKind::argument, place_of(owner, argument, i) + "=" + value + " must be " + bounds.said);
}

void check_kind(const Buffer& buffer, bool good, const char* owner, const char* argument, const char* wanted) {
    if (!good)
        raise(ErrorKind::argument_type,
              name_of(owner, argument) + " is a buffer of format '" + buffer.format() + "'; it must be of " + wanted);
}

Py_ssize_t length_of(nb::handle values, const char* owner, const char* argument, const char* wanted) {
    Py_ssize_t n = is_text(values) || !PySequence_Check(values.ptr()) ? -1 : PySequence_Size(values.ptr());
    PyErr_Clear();
    if (n < 0)
        raise(ErrorKind::argument_type,
              name_of(owner, argument) + " must be " + wanted + "; got " + nb::type_name(values.type()).c_str());
    return n;
}

nb::object item_of(nb::handle values, Py_ssize_t i, const char* owner, const char* argument) {
    nb::object item = nb::steal(PySequence_GetItem(values.ptr(), i));
    if (!item.is_valid()) {
        PyErr_Clear();
        raise(ErrorKind::argument, name_of(owner, argument) + " changed while it was read");
    }
    return item;
}

void check_point(Vec2 p, const char* owner, const char* argument, std::size_t i, Bounds bounds) {
    float most = static_cast<float>(bounds.most);
    if (!(bounds.round ? length(p) <= most : std::abs(p.x) <= most && std::abs(p.y) <= most))
        refuse(owner, argument, i, text_of(p), bounds);
}

void check_number(double value, const char* owner, const char* argument, std::size_t i, Bounds bounds) {
    if (!(std::abs(value) <= bounds.most)) refuse(owner, argument, i, text_of(value), bounds);
}

bool is_number(nb::handle value) { // of Python's own, or one of NumPy's
    if (PyFloat_Check(value.ptr()) || PyLong_Check(value.ptr())) return true;
    Buffer buffer(value);
    return buffer && buffer.dimensions() == 0 && (buffer.real() || buffer.whole());
}

bool is_point(nb::handle values) { // a pair of numbers, rather than two points
    bool pair = !is_text(values) && PySequence_Check(values.ptr()) && PySequence_Size(values.ptr()) == 2;
    nb::object first = nb::steal(pair ? PySequence_GetItem(values.ptr(), 0) : nullptr);
    PyErr_Clear();
    return first.is_valid() && is_number(first);
}

std::vector<Vec2> points_in(const Buffer& buffer, const char* owner, const char* argument) {
    check_kind(buffer, buffer.real() || buffer.whole(), owner, argument, "float32, float64 or whole numbers");
    bool flat = buffer.dimensions() == 1;
    if (!(flat ? buffer.rows() % 2 == 0 : buffer.dimensions() == 2 && buffer.columns() == 2))
        raise(ErrorKind::argument, name_of(owner, argument) + " must have two columns, x and y, or be x, y, x, y, ...");
    std::vector<Vec2> points(static_cast<std::size_t>(flat ? buffer.rows() / 2 : buffer.rows()));
    for (std::size_t i = 0; i < points.size(); ++i) {
        auto row = static_cast<Py_ssize_t>(i);
        points[i] = flat ? Vec2{static_cast<float>(buffer.number(2 * row, 0)),
                                static_cast<float>(buffer.number(2 * row + 1, 0))}
                         : Vec2{static_cast<float>(buffer.number(row, 0)), static_cast<float>(buffer.number(row, 1))};
    }
    return points;
}

std::vector<Vec2> points_of(nb::handle values, const char* owner, const char* argument) {
    Py_ssize_t n = length_of(values, owner, argument, "an array of points, or a list of them");
    std::vector<Vec2> points;
    points.reserve(static_cast<std::size_t>(n));
    for (Py_ssize_t i = 0; i < n; ++i) {
        nb::object item = item_of(values, i, owner, argument);
        std::string place = std::string(argument) + "[" + std::to_string(i) + "]";
        points.push_back(to_vec2(item, owner, place.c_str()));
    }
    return points;
}

} // namespace

std::vector<Vec2> to_points(nb::handle values, const char* owner, const char* argument, Bounds bounds) {
    Buffer buffer(values);
    std::vector<Vec2> points = buffer ? points_in(buffer, owner, argument) : points_of(values, owner, argument);
    for (std::size_t i = 0; i < points.size(); ++i) check_point(points[i], owner, argument, i, bounds);
    return points;
}

std::vector<double> to_numbers(nb::handle values, const char* owner, const char* argument, Bounds bounds) {
    std::vector<double> numbers;
    if (Buffer buffer(values); buffer) {
        check_kind(buffer, buffer.real() || buffer.whole(), owner, argument, "float32, float64 or whole numbers");
        if (buffer.dimensions() != 1)
            raise(ErrorKind::argument, name_of(owner, argument) + " must have one dimension, a number for each body");
        numbers.resize(static_cast<std::size_t>(buffer.rows()));
        for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = buffer.number(static_cast<Py_ssize_t>(i), 0);
    } else {
        Py_ssize_t n = length_of(values, owner, argument, "an array of numbers, or a list of them");
        numbers.reserve(static_cast<std::size_t>(n));
        for (Py_ssize_t i = 0; i < n; ++i) {
            nb::object item = item_of(values, i, owner, argument);
            std::string place = std::string(argument) + "[" + std::to_string(i) + "]";
            to_float(item, owner, place.c_str()); // refuses what is no finite number
            numbers.push_back(PyFloat_AsDouble(item.ptr()));
        }
    }
    for (std::size_t i = 0; i < numbers.size(); ++i) check_number(numbers[i], owner, argument, i, bounds);
    return numbers;
}

OneOrMany<Vec2> to_point_or_points(nb::handle values, const char* owner, const char* argument, Bounds bounds) {
    if (!is_point(values)) return {to_points(values, owner, argument, bounds)};
    Vec2 point = to_vec2(values, owner, argument);
    check_point(point, owner, argument, 0, bounds);
    return {{point}, true};
}

OneOrMany<double> to_number_or_numbers(nb::handle values, const char* owner, const char* argument, Bounds bounds) {
    if (!is_text(values) && !is_number(values) && PySequence_Check(values.ptr()))
        return {to_numbers(values, owner, argument, bounds)};
    to_float(values, owner, argument); // refuses what is no finite number
    double number = PyFloat_AsDouble(values.ptr());
    check_number(number, owner, argument, 0, bounds);
    return {{number}, true};
}

std::vector<std::uint32_t> to_indices(nb::handle values, const char* owner, const char* argument) {
    std::vector<std::uint32_t> indices;
    auto keep = [&](std::int64_t index) {
        if (index < 0 || index >= std::int64_t{0xffffffff})
            refuse(owner, argument, indices.size(), std::to_string(index), {0, "the slot of a body"});
        indices.push_back(static_cast<std::uint32_t>(index));
    };
    if (Buffer buffer(values); buffer) {
        check_kind(buffer, buffer.whole(), owner, argument, "whole numbers");
        if (buffer.dimensions() != 1)
            raise(ErrorKind::argument, name_of(owner, argument) + " must have one dimension, a slot for each value");
        for (Py_ssize_t i = 0; i < buffer.rows(); ++i) keep(buffer.index(i));
        return indices;
    }
    Py_ssize_t n = length_of(values, owner, argument, "an array of slots, or a list of them");
    for (Py_ssize_t i = 0; i < n; ++i) {
        nb::object item = item_of(values, i, owner, argument);
        bool whole = PyLong_Check(item.ptr()) && !PyBool_Check(item.ptr());
        std::int64_t index = whole ? static_cast<std::int64_t>(PyLong_AsLongLong(item.ptr())) : -1;
        if (PyErr_Occurred()) {
            PyErr_Clear();
            index = -1;
        }
        if (!whole)
            raise(ErrorKind::argument_type, place_of(owner, argument, static_cast<std::size_t>(i)) +
                                                " must be the slot of a body, a whole number; got " +
                                                nb::cast<std::string>(nb::repr(item)));
        keep(index);
    }
    return indices;
}

} // namespace evil::bind
