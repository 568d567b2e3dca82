#pragma once
// Python values to core values and back, with errors that name the argument.
#include "bind/module.hpp"
#include "math/vec2.hpp"
#include <string>
#include <vector>

namespace evil::bind {

enum class ErrorKind { argument, argument_type, shape, stale_reference, snapshot, asset, count_ };

// Look up evilengine.values' classes; called once when the module is loaded.
void load_python_types();

// Raise one of evilengine's errors. Never returns.
[[noreturn]] void raise(ErrorKind kind, const std::string& message);

// A finite point from any pair of numbers, or evil.ArgumentError / ArgumentTypeError that names owner and argument.
Vec2 to_vec2(nb::handle value, const char* owner, const char* argument);

// A string or bytes: a sequence, and no point or list of points all the same.
bool is_text(nb::handle value);

// A finite float that fits in 32 bits.
float to_float(nb::handle value, const char* owner, const char* argument);

// True or False and nothing else: a 0 or a "no" in its place is more often a slip than a wish.
bool to_bool(nb::handle value, const char* owner, const char* argument);

// How the stubs call what an argument may be.
inline constexpr const char *kNumber = "float", *kSwitch = "bool", *kPoint = "evilengine.values.vec2.Point";

// A property that may be written with anything at all, None too, so that it is our error that says what is right.
template <class Class, class Get, class Set>
void def_value(Class& c, const char* name, const char* type, Get get, Set set, const char* doc) {
    std::string signature = "def " + std::string(name) + "(self, value: " + type + ", /) -> None";
    c.def_prop_rw(name, get, set, nb::for_setter(nb::arg("value").none()), nb::for_setter(nb::sig(signature.c_str())),
                  doc);
}

// A call that fits no form of `name`, which takes `words`. Never returns.
[[noreturn]] void refuse_call(const std::string& name, const std::vector<std::string>& words, nb::args args,
                              nb::kwargs keywords);

// A method with one form; a call that does not fit it, as by an unknown keyword, is answered by an error of ours.
template <class Class, class Function, class... Extra>
void def_method(Class& c, const char* owner, const char* name, const char* signature, std::vector<std::string> words,
                Function function, const Extra&... extra) {
    std::string other =
        "def " + std::string(name) + "(self, *args: typing.Never, **words: typing.Never) -> typing.Never";
    c.def(name, function, nb::sig(signature), extra...);
    c.def(
        name,
        [full = std::string(owner) + "." + name, words = std::move(words)](
            nb::handle, nb::args args, nb::kwargs keywords) { refuse_call(full, words, args, keywords); },
        nb::sig(other.c_str()));
}

// A Python Vec2; the type's name is for the stubs.
struct PyVec2 : nb::object {
    NB_OBJECT(PyVec2, nb::object, "evilengine.values.vec2.Vec2", PyTuple_Check)
};
PyVec2 from_vec2(Vec2 value);

} // namespace evil::bind
