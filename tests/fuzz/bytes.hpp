#pragma once
// A fuzzer's bytes, read as what a caller may say.
#include "math/vec2.hpp"
#include <algorithm>
#include <cstdint>

namespace evil::fuzz {

class Bytes {
public:
    Bytes(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}
    bool empty() const { return left_ == 0; }
    std::uint8_t byte() {
        if (left_ == 0) return 0;
        --left_;
        return *data_++;
    }
    // Mostly what a game would say; sometimes the ends of what the door lets through.
    float number(float most) {
        const int word = byte() | byte() << 8;
        if (word == 0) return 0.0f;
        if (word % 64 == 1) return word & 64 ? most : -most;
        return (static_cast<float>(word) / 32768.0f - 1.0f) * std::min(most, 20.0f);
    }
    float size() {
        return byte() % 32 == 0 ? (byte() % 2 ? 1e4f : 1e-3f) : 0.05f + static_cast<float>(byte()) / 128.0f;
    }
    Vec2 point(float most) {
        const float x = number(most);
        return {x, number(most)};
    }

private:
    const std::uint8_t* data_;
    std::size_t left_;
};

} // namespace evil::fuzz
