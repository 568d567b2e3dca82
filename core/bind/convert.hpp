#pragma once
// Python values to core values and back, with errors that name the argument.
#include "bind/module.hpp"
#include "math/vec2.hpp"

namespace evil::bind {

enum class ErrorKind { argument, argument_type, shape, stale_reference, snapshot, asset, count_ };

// Look up evilengine.values' classes; called once when the module is loaded.
void load_python_types();

// Raise one of evilengine's errors. Never returns.
[[noreturn]] void raise(ErrorKind kind, const std::string& message);

// A finite point from any pair of numbers, or evil.ArgumentError / ArgumentTypeError that names owner and argument.
Vec2 to_vec2(nb::handle value, const char* owner, const char* argument);

// A finite float that fits in 32 bits.
float to_float(nb::handle value, const char* owner, const char* argument);

// A Python Vec2; the type's name is for the stubs.
struct PyVec2 : nb::object {
    NB_OBJECT(PyVec2, nb::object, "evilengine.values.vec2.Vec2", PyTuple_Check)
};
PyVec2 from_vec2(Vec2 value);

} // namespace evil::bind
