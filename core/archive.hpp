#pragma once
// Writing and reading State field by field, in one visit function for both directions.
#include "math/transform.hpp"
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

namespace evil {

static_assert(std::endian::native == std::endian::little,
              "snapshots are little-endian; swap bytes in Writer and Reader");

class Writer {
public:
    static constexpr bool reading = false;
    std::vector<std::uint8_t> bytes;

    template <class T>
        requires std::is_arithmetic_v<T> || std::is_enum_v<T>
    void value(const T& v) {
        const auto* raw = reinterpret_cast<const std::uint8_t*>(&v);
        bytes.insert(bytes.end(), raw, raw + sizeof(T));
    }
    std::size_t count(std::size_t n) {
        value(static_cast<std::uint64_t>(n));
        return n;
    }
};

class Reader {
public:
    static constexpr bool reading = true;
    explicit Reader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}
    bool ok = true; // false once anything was missing or out of range; what is read then is zero

    template <class T>
        requires std::is_arithmetic_v<T> || std::is_enum_v<T>
    void value(T& v) {
        v = T{};
        if (rest_.size() < sizeof(T)) {
            ok = false;
            return;
        }
        if constexpr (std::same_as<T, bool>) {
            ok = ok && rest_[0] <= 1;
            v = rest_[0] == 1;
        } else {
            std::memcpy(&v, rest_.data(), sizeof(T));
        }
        rest_ = rest_.subspan(sizeof(T));
        if constexpr (std::floating_point<T>) {
            if (!std::isfinite(v)) ok = false, v = T{};
        }
    }
    // A count of things of at least one byte each: more than the bytes that are left is a lie.
    std::size_t count(std::size_t = 0) {
        std::uint64_t n = 0;
        value(n);
        if (n > rest_.size()) ok = false, n = 0;
        return static_cast<std::size_t>(n);
    }
    bool at_end() const { return rest_.empty(); }

private:
    std::span<const std::uint8_t> rest_;
};

template <class A, class T>
    requires std::is_arithmetic_v<std::remove_const_t<T>> || std::is_enum_v<std::remove_const_t<T>>
void visit(A& archive, T& v) {
    archive.value(v);
}
template <class A>
void visit(A& archive, auto& v, auto&... more)
    requires(sizeof...(more) > 0)
{
    visit(archive, v);
    visit(archive, more...);
}
template <class V, class T>
concept Like = std::same_as<std::remove_const_t<V>, T>;

template <class A, Like<Vec2> V> void visit(A& archive, V& v) { visit(archive, v.x, v.y); }
template <class A, Like<Rot> V> void visit(A& archive, V& v) { visit(archive, v.c, v.s); }
template <class A, Like<Pose> V> void visit(A& archive, V& v) { visit(archive, v.p, v.q); }
template <class A, Like<Affine> V> void visit(A& archive, V& v) { visit(archive, v.a, v.b, v.c, v.d, v.tx, v.ty); }

} // namespace evil
