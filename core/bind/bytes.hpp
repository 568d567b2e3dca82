#pragma once
// Memory of Python objects, and of ours for Python.
#include "bind/convert.hpp"
#include <cstdint>

namespace evil::bind {

// Bytes of any Python object that shows its memory, for as long as this lives.
class Bytes {
public:
    Bytes(nb::handle object, bool writable, const char* owner, const char* argument) {
        if (PyObject_GetBuffer(object.ptr(), &view_, writable ? PyBUF_WRITABLE : PyBUF_SIMPLE) == 0) return;
        PyErr_Clear();
        raise(ErrorKind::argument_type,
              std::string(owner) + ": " + argument + " must be " + (writable ? "writable " : "") + "contiguous bytes");
    }
    ~Bytes() { PyBuffer_Release(&view_); }
    Bytes(const Bytes&) = delete;
    Bytes& operator=(const Bytes&) = delete;

    std::uint8_t* data() const { return static_cast<std::uint8_t*>(view_.buf); }
    std::size_t size() const { return static_cast<std::size_t>(view_.len); }

private:
    Py_buffer view_{};
};

// width * height * 4 bytes, or evil.ArgumentError.
void check_picture(const Bytes& bytes, long width, long height, const char* owner);

} // namespace evil::bind
