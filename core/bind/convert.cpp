#include "bind/convert.hpp"
#include <string>

namespace evil::bind {
namespace {

constexpr const char* kErrorNames[] = {"ArgumentError",       "ArgumentTypeError", "ShapeError",
                                       "StaleReferenceError", "SnapshotError",     "AssetError"};
static_assert(std::size(kErrorNames) == static_cast<std::size_t>(ErrorKind::count_));

// Python's own classes, alive as long as the interpreter: the module is never unloaded before them.
PyTypeObject* vec2_type = nullptr;
allocfunc new_vec2 = nullptr; // a Vec2 is a tuple subclass without a dictionary: allocated as one
PyObject* error_types[static_cast<std::size_t>(ErrorKind::count_)] = {};

std::string text_of(nb::handle value) { return nb::cast<std::string>(nb::repr(value)); }

bool to_double(nb::handle value, double& out) {
    out = PyFloat_AsDouble(value.ptr());
    if (out == -1.0 && PyErr_Occurred()) {
        bool overflow = PyErr_ExceptionMatches(PyExc_OverflowError);
        PyErr_Clear();
        if (!overflow) return false;
        out = HUGE_VAL;
    }
    return true;
}

[[noreturn]] void raise_not_finite(nb::handle value, const char* owner, const char* argument) {
    raise(ErrorKind::argument, std::string(owner) + ": " + argument + "=" + text_of(value) +
                                   " must be finite and below 1e38; NaN or infinity came in");
}

} // namespace

bool is_text(nb::handle value) {
    PyObject* v = value.ptr();
    return PyUnicode_Check(v) || PyBytes_Check(v) || PyByteArray_Check(v);
}

void load_python_types() {
    nb::object errors = nb::module_::import_("evilengine.values.errors");
    for (std::size_t i = 0; i < std::size(kErrorNames); ++i)
        error_types[i] = nb::object(errors.attr(kErrorNames[i])).release().ptr();
    nb::object vec2 = nb::module_::import_("evilengine.values.vec2").attr("Vec2");
    vec2_type = reinterpret_cast<PyTypeObject*>(vec2.release().ptr());
    new_vec2 = reinterpret_cast<allocfunc>(PyType_GetSlot(vec2_type, Py_tp_alloc));
}

void raise(ErrorKind kind, const std::string& message) {
    PyErr_SetString(error_types[static_cast<std::size_t>(kind)], message.c_str());
    throw nb::python_error();
}

float to_float(nb::handle value, const char* owner, const char* argument) {
    double number = 0.0;
    if (PyBool_Check(value.ptr()) || !to_double(value, number))
        raise(ErrorKind::argument_type,
              std::string(owner) + ": " + argument + "=" + text_of(value) + " must be a number");
    float result = static_cast<float>(number);
    if (!std::isfinite(result)) raise_not_finite(value, owner, argument);
    return result;
}

Vec2 to_vec2(nb::handle value, const char* owner, const char* argument) {
    double x = 0.0, y = 0.0;
    bool ok = false;
    PyObject* pair = value.ptr();
    if (PyTuple_Check(pair)) {
        ok =
            PyTuple_Size(pair) == 2 && to_double(PyTuple_GetItem(pair, 0), x) && to_double(PyTuple_GetItem(pair, 1), y);
    } else if (PySequence_Check(pair) && !is_text(pair) && PySequence_Size(pair) == 2) {
        nb::object first = nb::steal(PySequence_GetItem(pair, 0)), second = nb::steal(PySequence_GetItem(pair, 1));
        ok = first.is_valid() && second.is_valid() && to_double(first, x) && to_double(second, y);
    }
    PyErr_Clear();
    if (!ok)
        raise(ErrorKind::argument_type, std::string(owner) + ": " + argument + "=" + text_of(value) +
                                            " must be a point, a pair of numbers such as (0, 1)");
    Vec2 result{static_cast<float>(x), static_cast<float>(y)};
    if (!is_finite(result)) raise_not_finite(value, owner, argument);
    return result;
}

bool to_bool(nb::handle value, const char* owner, const char* argument) {
    if (!PyBool_Check(value.ptr()))
        raise(ErrorKind::argument_type,
              std::string(owner) + ": " + argument + "=" + text_of(value) + " must be True or False");
    return value.ptr() == Py_True;
}

void refuse_call(const std::string& name, const std::vector<std::string>& words, nb::args args, nb::kwargs keywords) {
    nb::list known;
    for (const std::string& word : words) known.append(word);
    nb::module_::import_("evilengine.values.checks").attr("refuse_call")(name, known, args, keywords);
    raise(ErrorKind::argument_type, name + "() was not called as it should be");
}

PyVec2 from_vec2(Vec2 value) {
    PyObject* pair = new_vec2(vec2_type, 2);
    if (!pair) throw nb::python_error();
    PyTuple_SetItem(pair, 0, PyFloat_FromDouble(value.x));
    PyTuple_SetItem(pair, 1, PyFloat_FromDouble(value.y));
    return nb::steal<PyVec2>(pair);
}

} // namespace evil::bind
