#pragma once
// Many bodies as Python holds them: references of which handles are made when they are asked for.
#include "bind/handle.hpp"

namespace evil::bind {

struct BodyRefs {
    std::vector<BodyRef> refs;
    std::vector<std::uint32_t> slots;                     // as a buffer; filled when it is first looked at
    Py_ssize_t count = 0, stride = sizeof(std::uint32_t); // the buffer's shape and strides
};

} // namespace evil::bind
