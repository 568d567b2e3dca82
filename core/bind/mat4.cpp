// 4x4 matrices for Python: what evilengine.math is made of.
#include "math/mat4.hpp"
#include "bind/convert.hpp"
#include "bind/shapes.hpp"
#include <cstring>
#include <memory>
#include <nanobind/ndarray.h>

namespace evil::bind {
namespace {

using Rows = nb::ndarray<nb::memview, float, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

constexpr std::size_t kBusyRows = 4096; // from here on the work takes longer than letting other threads run meanwhile

std::string in(const char* owner, const char* argument) { return std::string(owner) + ": " + argument; }

// A C-contiguous buffer of 32-bit floats, held as long as it is read. Empty (rows() is 0, held() is false) for other things.
class FloatBuffer {
public:
    FloatBuffer(nb::handle source, const char* owner, const char* argument) {
        if (PyBytes_Check(source.ptr()) || !PyObject_CheckBuffer(source.ptr())) return;
        if (PyObject_GetBuffer(source.ptr(), &view_, PyBUF_ND | PyBUF_FORMAT) != 0) {
            PyErr_Clear();
            raise(ErrorKind::argument_type,
                  in(owner, argument) + " must lie in memory row after row (C-contiguous); copy it first");
        }
        const char* format = view_.format ? view_.format : "B";
        if (*format == '@' || *format == '=' || *format == '<') ++format;
        if (std::strcmp(format, "f") == 0) return;
        std::string got = view_.format ? view_.format : "B";
        PyBuffer_Release(&view_);
        raise(ErrorKind::argument_type, in(owner, argument) +
                                            " must be a buffer of 32-bit floats (format 'f'); its format is '" + got +
                                            "'; NumPy's astype('float32') converts");
    }
    ~FloatBuffer() {
        if (view_.obj) PyBuffer_Release(&view_);
    }
    FloatBuffer(const FloatBuffer&) = delete;
    FloatBuffer& operator=(const FloatBuffer&) = delete;

    bool held() const { return view_.obj != nullptr; }
    const float* data() const { return static_cast<const float*>(view_.buf); }
    std::size_t width() const { return view_.ndim == 0 ? 0 : static_cast<std::size_t>(view_.shape[view_.ndim - 1]); }
    bool is_rows_of(std::size_t wanted) const { return view_.ndim == 2 && width() == wanted; }
    std::size_t rows() const { return static_cast<std::size_t>(view_.shape[0]); }
    std::string shape() const {
        std::string text = "(";
        for (int i = 0; i < view_.ndim; ++i) text += (i ? ", " : "") + std::to_string(view_.shape[i]);
        return text + ")";
    }

private:
    Py_buffer view_{};
};

void require_finite(const float* data, std::size_t rows, std::size_t width, const char* owner, const char* argument) {
    if (all_finite({data, rows * width})) return;
    std::size_t bad = 0;
    while (std::isfinite(data[bad])) ++bad;
    raise(ErrorKind::argument,
          in(owner, argument) + " must be finite; NaN or infinity is in row " + std::to_string(bad / width));
}

// The quick way: a tuple of 16 floats, which a Mat4 always is. False for anything else.
bool read_tuple(nb::handle values, Mat4& result) {
    if (!PyTuple_Check(values.ptr()) || PyTuple_Size(values.ptr()) != 16) return false;
    for (std::size_t i = 0; i < 16; ++i) {
        PyObject* item = PyTuple_GetItem(values.ptr(), static_cast<Py_ssize_t>(i));
        if (!PyFloat_Check(item)) return false;
        result.m[i] = static_cast<float>(PyFloat_AsDouble(item));
    }
    return all_finite(result.m);
}

Mat4 to_mat4(nb::handle values, const char* owner, const char* argument) {
    Mat4 result;
    if (read_tuple(values, result)) return result;
    Py_ssize_t size = -1;
    if (PyBytes_Check(values.ptr())) {
        size = PyBytes_Size(values.ptr());
        if (size == sizeof result) std::memcpy(&result, PyBytes_AsString(values.ptr()), sizeof result);
        size /= static_cast<Py_ssize_t>(sizeof(float));
    } else if (PySequence_Check(values.ptr()) && !PyUnicode_Check(values.ptr())) {
        size = PySequence_Size(values.ptr());
        for (Py_ssize_t i = 0; i < 16 && size == 16; ++i) {
            nb::object item = nb::steal(PySequence_GetItem(values.ptr(), i));
            if (!item.is_valid()) throw nb::python_error();
            result.m[static_cast<std::size_t>(i)] = to_float(item, owner, argument);
        }
    }
    PyErr_Clear();
    if (size < 0)
        raise(ErrorKind::argument_type, in(owner, argument) +
                                            " must be a Mat4 or 16 numbers, column after column; got " +
                                            nb::type_name(values.type()).c_str());
    if (size != 16)
        raise(ErrorKind::argument,
              in(owner, argument) + " must have 16 numbers, column after column; got " + std::to_string(size));
    require_finite(result.m.data(), 1, 16, owner, argument);
    return result;
}

nb::tuple from_mat4(const Mat4& matrix, const char* owner) {
    PyObject* tuple = PyTuple_New(16);
    if (!tuple) throw nb::python_error();
    for (std::size_t i = 0; i < 16; ++i)
        PyTuple_SetItem(tuple, static_cast<Py_ssize_t>(i), PyFloat_FromDouble(matrix.m[i]));
    nb::tuple result = nb::steal<nb::tuple>(tuple);
    if (!all_finite(matrix.m))
        raise(ErrorKind::argument, std::string(owner) + ": the result lies beyond the range of 32-bit floats");
    return result;
}

// One matrix or many: a Mat4, 16 numbers, or a float32 buffer of shape (n, 16).
class Matrices {
public:
    Matrices(nb::handle source, const char* owner, const char* argument) : buffer_(source, owner, argument) {
        if (!buffer_.is_rows_of(16)) {
            if (buffer_.held() && buffer_.width() != 16)
                raise(ErrorKind::argument, in(owner, argument) +
                                               " must be 16 floats or have the shape (n, 16); its shape is " +
                                               buffer_.shape());
            one_ = to_mat4(source, owner, argument);
            return;
        }
        require_finite(buffer_.data(), buffer_.rows(), 16, owner, argument);
        all_ = {reinterpret_cast<const Mat4*>(buffer_.data()), buffer_.rows()};
    }
    bool many() const { return all_.data() != nullptr && all_.size() != 1; }
    std::span<const Mat4> all() const { return all_.data() ? all_ : std::span<const Mat4>(&one_, 1); }

private:
    FloatBuffer buffer_;
    Mat4 one_;
    std::span<const Mat4> all_;
};

InstructionSet to_instruction_set(const std::string& wanted) {
    if (wanted.empty()) return best_instruction_set();
    for (InstructionSet set : runnable_instruction_sets())
        if (wanted == name(set)) return set;
    raise(ErrorKind::argument, "instruction_set='" + wanted + "' is not one of _core.instruction_sets()");
}

// Runs `fill` on fresh rows, without the interpreter's lock when there are many.
template <class Fill> Rows make_rows(std::size_t rows, std::size_t width, Fill fill) {
    auto data = std::make_unique_for_overwrite<float[]>(rows * width + 1);
    float* first = data.get();
    if (rows < kBusyRows) {
        fill(first);
    } else {
        nb::gil_scoped_release free;
        fill(first);
    }
    nb::capsule owner(first, [](void* p) noexcept { delete[] static_cast<float*>(p); });
    data.release();
    return Rows(first, {rows, width}, owner);
}

template <class Vector>
Rows transform_rows(const Matrices& matrices, const float* points, std::size_t rows, InstructionSet set) {
    std::span<const Vector> in(reinterpret_cast<const Vector*>(points), rows);
    if (matrices.many() && matrices.all().size() != rows)
        raise(ErrorKind::argument, "transform: matrix holds " + std::to_string(matrices.all().size()) +
                                       " matrices for " + std::to_string(rows) +
                                       " points; give one matrix, or one for each point");
    return make_rows(rows, sizeof(Vector) / sizeof(float), [&](float* to) {
        std::span<Vector> out(reinterpret_cast<Vector*>(to), rows);
        if (matrices.many())
            transform_each(matrices.all(), in, out);
        else if constexpr (sizeof(Vector) == sizeof(Vec2))
            transform_points(matrices.all()[0], in, out, set);
        else
            transform_vectors(matrices.all()[0], in, out, set);
    });
}

Rows transform_buffer(nb::handle matrix, nb::handle points, const std::string& instruction_set) {
    InstructionSet set = to_instruction_set(instruction_set);
    Matrices matrices(matrix, "transform", "matrix");
    FloatBuffer buffer(points, "transform", "points");
    if (!buffer.held()) {
        std::vector<Vec2> listed = to_corners(points, "transform", "points");
        const float* data = reinterpret_cast<const float*>(listed.data());
        require_finite(data, listed.size(), 2, "transform", "points");
        return transform_rows<Vec2>(matrices, data, listed.size(), set);
    }
    bool pairs = buffer.is_rows_of(2);
    if (!pairs && !buffer.is_rows_of(4))
        raise(ErrorKind::argument,
              "transform: points must have the shape (n, 2) or (n, 4); its shape is " + buffer.shape());
    require_finite(buffer.data(), buffer.rows(), buffer.width(), "transform", "points");
    return pairs ? transform_rows<Vec2>(matrices, buffer.data(), buffer.rows(), set)
                 : transform_rows<Vec4>(matrices, buffer.data(), buffer.rows(), set);
}

Rows multiply_buffers(nb::handle first, nb::handle second, const std::string& instruction_set) {
    InstructionSet set = to_instruction_set(instruction_set);
    Matrices a(first, "multiply", "a"), b(second, "multiply", "b");
    std::size_t rows = a.many() ? a.all().size() : b.all().size();
    if (a.many() && b.many() && a.all().size() != b.all().size())
        raise(ErrorKind::argument, "multiply: a holds " + std::to_string(a.all().size()) + " matrices and b " +
                                       std::to_string(b.all().size()) + "; give as many, or one");
    return make_rows(rows, 16,
                     [&](float* to) { multiply(a.all(), b.all(), {reinterpret_cast<Mat4*>(to), rows}, set); });
}

nb::object times(nb::handle matrix, nb::handle vector) {
    Mat4 m = to_mat4(matrix, "Mat4", "matrix");
    if (PySequence_Check(vector.ptr()) && PySequence_Size(vector.ptr()) == 4 && !PyUnicode_Check(vector.ptr())) {
        float v[4];
        for (Py_ssize_t i = 0; i < 4; ++i) {
            nb::object item = nb::steal(PySequence_GetItem(vector.ptr(), i));
            if (!item.is_valid()) throw nb::python_error();
            v[i] = to_float(item, "Mat4 @ vector", "vector");
        }
        Vec4 r = m * Vec4{v[0], v[1], v[2], v[3]};
        return nb::make_tuple(r.x, r.y, r.z, r.w);
    }
    PyErr_Clear();
    return from_vec2(apply(affine(m), to_vec2(vector, "Mat4 @ point", "point")));
}

} // namespace

void register_mat4(nb::module_& module) {
    module.def(
        "instruction_sets",
        [] {
            nb::list names;
            for (InstructionSet set : runnable_instruction_sets()) names.append(name(set));
            return names;
        },
        nb::sig("def instruction_sets() -> list[str]"),
        "What wide kernels can run with on this machine; the last is used.");
    module.def(
        "mat4", [](nb::handle values) { return from_mat4(to_mat4(values, "Mat4", "values"), "Mat4"); },
        nb::arg("values").none(), nb::sig("def mat4(values: object) -> tuple[float, ...]"),
        "16 numbers or 64 bytes as a matrix: finite, and rounded to 32 bits.");
    module.def(
        "mat4_rotation",
        [](double angle) {
            SinCos f = sincos(angle);
            return from_mat4(mat4(affine(Pose{{}, {f.cos, f.sin}})), "Mat4.rotation");
        },
        nb::arg("angle"), nb::sig("def mat4_rotation(angle: float) -> tuple[float, ...]"), "Rotation by radians.");
    module.def(
        "mat4_product",
        [](nb::handle a, nb::handle b) {
            return from_mat4(to_mat4(a, "Mat4 @ Mat4", "a") * to_mat4(b, "Mat4 @ Mat4", "b"), "Mat4 @ Mat4");
        },
        nb::arg("a"), nb::arg("b"), nb::sig("def mat4_product(a: object, b: object) -> tuple[float, ...]"),
        "The matrix that applies b, then a.");
    module.def("mat4_times", &times, nb::arg("matrix"), nb::arg("vector").none(),
               nb::sig("def mat4_times(matrix: object, vector: object) -> tuple[float, ...]"),
               "Matrix times a point (a Vec2) or a vector of four (a tuple).");
    module.def(
        "mat4_transposed", [](nb::handle a) { return from_mat4(transpose(to_mat4(a, "Mat4", "a")), "Mat4"); },
        nb::arg("a"), nb::sig("def mat4_transposed(a: object) -> tuple[float, ...]"), "Rows as columns.");
    module.def(
        "mat4_inverse",
        [](nb::handle a) {
            std::optional<Mat4> result = inverse(to_mat4(a, "Mat4", "a"));
            return result ? nb::object(from_mat4(*result, "Mat4.inverse")) : nb::none();
        },
        nb::arg("a"), nb::sig("def mat4_inverse(a: object) -> tuple[float, ...] | None"),
        "The matrix that undoes a, or None.");
    module.def("transform", &transform_buffer, nb::arg("matrix").none(), nb::arg("points").none(),
               nb::arg("instruction_set") = "",
               nb::sig("def transform(matrix: object, points: object, instruction_set: str = '') -> memoryview"),
               "One matrix, or one for each, times points (n, 2) or vectors (n, 4).");
    module.def("multiply", &multiply_buffers, nb::arg("a").none(), nb::arg("b").none(), nb::arg("instruction_set") = "",
               nb::sig("def multiply(a: object, b: object, instruction_set: str = '') -> memoryview"),
               "Products of matrices, (n, 16) by (n, 16), or one by many.");
}

} // namespace evil::bind
