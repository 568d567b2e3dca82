#include "bind/values.hpp"
#include <bit>
#include <cstring>

namespace evil::bind {
namespace {

class Buffer { // held while it lives
public:
    explicit Buffer(nb::handle object) {
        held_ = !is_text(object) && PyObject_GetBuffer(object.ptr(), &view_, PyBUF_STRIDES | PyBUF_FORMAT) == 0;
        if (!held_) PyErr_Clear();
    }
    ~Buffer() {
        if (held_) PyBuffer_Release(&view_);
    }
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;

    explicit operator bool() const { return held_; }
    int columns() const { return view_.ndim == 2 ? static_cast<int>(view_.shape[1]) : 1; }
    int dimensions() const { return view_.ndim; }
    Py_ssize_t rows() const { return view_.shape[0]; }
    char letter() const { // of its format; 0 for one that is not native, or more than a letter
        const char* f = view_.format ? view_.format : "B";
        if (*f == '@' || *f == '=' || *f == (std::endian::native == std::endian::little ? '<' : '>')) ++f;
        return f[1] == '\0' ? f[0] : '\0';
    }
    bool whole() const { return std::strchr("bBhHiIlLqQnN", letter()) != nullptr && letter() != '\0'; }
    bool real() const { return letter() == 'f' || letter() == 'd'; }
    std::string format() const { return view_.format ? view_.format : "B"; }

    double number(Py_ssize_t row, Py_ssize_t column) const {
        const char* at = static_cast<const char*>(view_.buf) + row * view_.strides[0];
        if (view_.ndim == 2) at += column * view_.strides[1];
        if (letter() == 'f') return double(read<float>(at));
        if (letter() == 'd') return read<double>(at);
        return static_cast<double>(integer(at));
    }
    std::int64_t index(Py_ssize_t row) const {
        return integer(static_cast<const char*>(view_.buf) + row * view_.strides[0]);
    }

private:
    template <class T> static T read(const char* at) {
        T value;
        std::memcpy(&value, at, sizeof value);
        return value;
    }
    std::int64_t integer(const char* at) const { // by its size: what letters mean differs between systems
        bool has_sign = std::strchr("bhilqn", letter()) != nullptr;
        switch (view_.itemsize) {
        case 1:
            return has_sign ? read<std::int8_t>(at) : read<std::uint8_t>(at);
        case 2:
            return has_sign ? read<std::int16_t>(at) : read<std::uint16_t>(at);
        case 4:
            return has_sign ? std::int64_t{read<std::int32_t>(at)} : std::int64_t{read<std::uint32_t>(at)};
        default:
            return read<std::int64_t>(at);
        }
    }

    Py_buffer view_{};
    bool held_ = false;
};

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
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (!(std::abs(numbers[i]) <= bounds.most)) refuse(owner, argument, i, text_of(numbers[i]), bounds);
    return numbers;
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
