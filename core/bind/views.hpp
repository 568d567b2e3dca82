#pragma once
#include "bind/visit.hpp"

namespace evil::bind {

struct View {
    std::shared_ptr<Arrays> owner;
    const float* data;
    Py_ssize_t columns;
    Py_ssize_t shape[2], strides[2];

    View(std::shared_ptr<Arrays> arrays, const std::vector<float>& values, Py_ssize_t rows, Py_ssize_t width)
        : owner(std::move(arrays)), data(values.data()), columns(width), shape{rows, width},
          strides{width * static_cast<Py_ssize_t>(sizeof(float)), static_cast<Py_ssize_t>(sizeof(float))} {}
};

} // namespace evil::bind
