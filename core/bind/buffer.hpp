#pragma once
// Numbers in memory that some Python object shows: whatever their kind, and however they lie.
#include "bind/convert.hpp"
#include <bit>
#include <cstdint>
#include <cstring>

namespace evil::bind {

class Buffer { // held while it lives
public:
    explicit Buffer(nb::handle object) {
        held_ = !is_text(object) && PyObject_GetBuffer(object.ptr(), &view_, PyBUF_STRIDES | PyBUF_FORMAT) == 0;
        if (held_) letter_ = letter_of(format());
        PyErr_Clear();
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
    bool whole() const { return std::strchr("bBhHiIlLqQnN", letter_) != nullptr && letter_ != '\0'; }
    bool real() const { return letter_ == 'f' || letter_ == 'd'; }
    const char* format() const { return view_.format ? view_.format : "B"; }
    std::string shape() const { // as Python writes a tuple
        std::string text = "(";
        for (int i = 0; i < view_.ndim; ++i) text += (i ? ", " : "") + std::to_string(view_.shape[i]);
        return text + (view_.ndim == 1 ? ",)" : ")");
    }

    double number(Py_ssize_t row, Py_ssize_t column) const {
        const char* at = static_cast<const char*>(view_.buf) + row * view_.strides[0];
        if (view_.ndim == 2) at += column * view_.strides[1];
        if (letter_ == 'f') return double(read<float>(at));
        if (letter_ == 'd') return read<double>(at);
        return static_cast<double>(integer(at));
    }
    std::int64_t index(Py_ssize_t row) const {
        return integer(static_cast<const char*>(view_.buf) + row * view_.strides[0]);
    }

private:
    static char letter_of(const char* f) { // 0 for a format that is not native, or more than a letter
        if (*f == '@' || *f == '=' || *f == (std::endian::native == std::endian::little ? '<' : '>')) ++f;
        return f[0] != '\0' && f[1] == '\0' ? f[0] : '\0';
    }
    template <class T> static T read(const char* at) {
        T value;
        std::memcpy(&value, at, sizeof value);
        return value;
    }
    std::int64_t integer(const char* at) const { // by its size: what letters mean differs between systems
        bool has_sign = std::strchr("bhilqn", letter_) != nullptr;
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
    char letter_ = '\0'; // of its format
};

} // namespace evil::bind
