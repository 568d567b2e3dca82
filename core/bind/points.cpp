#include "bind/points.hpp"
#include "bind/shapes.hpp"
#include <cstring>

namespace evil::bind {
namespace {

std::string in(const char* owner, const char* argument) { return std::string(owner) + ": " + argument; }

[[noreturn]] void raise_row(std::size_t row, const char* owner, const char* argument) {
    raise(ErrorKind::argument,
          in(owner, argument) + " must be finite and below 1e38; NaN or infinity is in row " + std::to_string(row));
}

// A buffer of floats of either size with strides, held as long as it is read.
class Buffer {
public:
    Buffer(nb::handle source, int dimensions, const char* owner, const char* argument) {
        if (PyObject_GetBuffer(source.ptr(), &view_, PyBUF_STRIDED_RO | PyBUF_FORMAT) != 0) throw nb::python_error();
        const char* format = view_.format ? view_.format : "B";
        if (*format == '@' || *format == '=' || *format == '<') ++format;
        wide_ = std::strcmp(format, "d") == 0;
        bool right = view_.ndim == dimensions && (dimensions == 1 || view_.shape[1] == 2);
        if (right && (wide_ || std::strcmp(format, "f") == 0)) return;
        std::string shape = dimensions == 1 ? "(n,)" : "(n, 2)", got;
        for (int i = 0; i < view_.ndim; ++i) got += (i ? ", " : "") + std::to_string(view_.shape[i]);
        std::string text = in(owner, argument) + " must be a buffer of 32- or 64-bit floats of shape " + shape +
                           "; its format is '" + (view_.format ? view_.format : "B") + "', its shape (" + got +
                           (view_.ndim == 1 ? ",)" : ")");
        PyBuffer_Release(&view_);
        raise(right ? ErrorKind::argument_type : ErrorKind::argument, text);
    }
    ~Buffer() { PyBuffer_Release(&view_); }
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;

    std::size_t rows() const { return static_cast<std::size_t>(view_.shape[0]); }
    float at(std::size_t row, int column) const {
        const char* from = static_cast<const char*>(view_.buf) + static_cast<Py_ssize_t>(row) * view_.strides[0];
        if (column > 0) from += column * view_.strides[1];
        if (!wide_) {
            float value;
            std::memcpy(&value, from, sizeof value);
            return value;
        }
        double value;
        std::memcpy(&value, from, sizeof value);
        return static_cast<float>(value);
    }

private:
    Py_buffer view_{};
    bool wide_ = false;
};

bool is_buffer(nb::handle source) { return !is_text(source) && PyObject_CheckBuffer(source.ptr()); }

bool is_number(nb::handle value) { return PyFloat_Check(value.ptr()) || PyLong_Check(value.ptr()); }

bool is_point(nb::handle source) { // a pair of numbers, rather than a list of two points
    if (is_text(source) || !PySequence_Check(source.ptr()) || PySequence_Size(source.ptr()) != 2) return false;
    nb::object first = nb::steal(PySequence_GetItem(source.ptr(), 0));
    return first.is_valid() && is_number(first);
}

} // namespace

Points to_points(nb::handle source, const char* owner, const char* argument) {
    Points points;
    if (is_buffer(source)) {
        Buffer buffer(source, 2, owner, argument);
        points.rows.resize(buffer.rows());
        for (std::size_t i = 0; i < points.rows.size(); ++i) points.rows[i] = {buffer.at(i, 0), buffer.at(i, 1)};
    } else if (is_point(source)) {
        points.rows.push_back(to_vec2(source, owner, argument));
        points.one = true;
    } else {
        PyErr_Clear();
        points.rows = to_corners(source, owner, argument);
    }
    for (std::size_t i = 0; i < points.rows.size(); ++i)
        if (!is_finite(points.rows[i])) raise_row(i, owner, argument);
    return points;
}

Numbers to_numbers(nb::handle source, const char* owner, const char* argument) {
    Numbers numbers;
    if (is_number(source)) {
        numbers.rows.push_back(to_float(source, owner, argument));
        numbers.one = true;
    } else if (is_buffer(source)) {
        Buffer buffer(source, 1, owner, argument);
        numbers.rows.resize(buffer.rows());
        for (std::size_t i = 0; i < numbers.rows.size(); ++i) numbers.rows[i] = buffer.at(i, 0);
    } else if (!is_text(source) && PySequence_Check(source.ptr())) {
        Py_ssize_t count = PySequence_Size(source.ptr());
        for (Py_ssize_t i = 0; i < count; ++i) {
            nb::object item = nb::steal(PySequence_GetItem(source.ptr(), i));
            if (!item.is_valid()) throw nb::python_error();
            numbers.rows.push_back(to_float(item, owner, argument));
        }
    } else {
        raise(ErrorKind::argument_type, in(owner, argument) + "=" + nb::cast<std::string>(nb::repr(source)) +
                                            " must be a number, or a list or buffer of numbers");
    }
    for (std::size_t i = 0; i < numbers.rows.size(); ++i)
        if (!std::isfinite(numbers.rows[i])) raise_row(i, owner, argument);
    return numbers;
}

} // namespace evil::bind
