#pragma once
// Writing and reading State field by field, in one visit function for both directions.
#include "hash.hpp"
#include "math/transform.hpp"
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string>
#include <vector>

namespace evil {

static_assert(std::endian::native == std::endian::little,
              "snapshots are little-endian; swap bytes in Writer and Reader");

template <class T, class... Any>
concept OneOf = (std::same_as<T, Any> || ...);

// Rows of floats without gaps: their bytes are the bytes of their floats.
template <class T>
concept FloatRow = OneOf<T, Vec2, Rot, Pose, Affine>;

// What is written as its bytes.
template <class T>
concept Plain = std::is_arithmetic_v<T> || std::is_enum_v<T> || FloatRow<T>;

// Writes into a window of memory; where that ends, `make_room` moves on to the next.
class Writer {
public:
    static constexpr bool reading = false;

    template <Plain... T> void values(const T&... v) {
        constexpr std::size_t size = (sizeof(T) + ...);
        if (static_cast<std::size_t>(end_ - at_) < size) make_room(size);
        std::uint8_t* at = at_;
        ((std::memcpy(at, &v, sizeof(T)), at += sizeof(T)), ...);
        at_ = at;
    }
    template <Plain T> void value(const T& v) { values(v); }
    std::size_t count(std::size_t n) {
        value(static_cast<std::uint64_t>(n));
        return n;
    }

protected:
    Writer() = default;
    ~Writer() = default;
    virtual void make_room(std::size_t size) = 0; // at least `size` bytes from at_ to end_
    std::uint8_t *at_ = nullptr, *end_ = nullptr;
};

// Nowhere: only how much it would be.
class Measure {
public:
    static constexpr bool reading = false;
    template <Plain... T> void values(const T&...) { size_ += (sizeof(T) + ...); }
    template <Plain T> void value(const T&) { size_ += sizeof(T); }
    std::size_t count(std::size_t n) {
        size_ += sizeof(std::uint64_t);
        return n;
    }
    std::size_t size() const { return size_; }

private:
    std::size_t size_ = 0;
};

// Into bytes of its own.
class BytesWriter final : public Writer {
public:
    std::vector<std::uint8_t> take() {
        bytes_.resize(written());
        at_ = end_ = nullptr;
        return std::move(bytes_);
    }

private:
    std::size_t written() const { return bytes_.size() - static_cast<std::size_t>(end_ - at_); }
    void make_room(std::size_t size) override {
        std::size_t before = written();
        bytes_.resize(2 * before + size + 256);
        at_ = bytes_.data() + before;
        end_ = bytes_.data() + bytes_.size();
    }
    std::vector<std::uint8_t> bytes_;
};

// Into memory that is there, of just the right size.
class SpanWriter final : public Writer {
public:
    explicit SpanWriter(std::span<std::uint8_t> out) {
        at_ = out.data();
        end_ = at_ + out.size();
    }
    bool full() const { return at_ == end_; }

private:
    void make_room(std::size_t) override { std::abort(); } // whoever measured the space has erred
};

// Nowhere: only their hash and their number are kept.
class HashWriter final : public Writer {
public:
    HashWriter() { rewind(0); }
    HashWriter(const HashWriter&) = delete;
    HashWriter& operator=(const HashWriter&) = delete;
    std::uint64_t size() const { return hash_.size() + used(); }
    std::uint64_t sum() {
        hash_.add({window_, used()});
        rewind(0);
        return hash_.sum();
    }

private:
    std::size_t used() const { return static_cast<std::size_t>(at_ - window_); }
    void rewind(std::size_t kept) { at_ = window_ + kept, end_ = window_ + sizeof window_; }
    void make_room(std::size_t) override {
        std::size_t whole = used() / Hash::kStripe * Hash::kStripe, rest = used() - whole;
        hash_.add({window_, whole});
        std::memmove(window_, window_ + whole, rest);
        rewind(rest);
    }
    Hash hash_;
    std::uint8_t window_[16384];
};

class Reader {
public:
    static constexpr bool reading = true;
    explicit Reader(std::span<const std::uint8_t> bytes) : at_(bytes.data()), end_(bytes.data() + bytes.size()) {}
    bool ok = true; // false once anything was missing or out of range; nothing that was read counts then

    template <Plain... T> void values(T&... v) {
        constexpr std::size_t size = (sizeof(T) + ...);
        if (left() < size) {
            ok = false;
            ((v = T{}), ...);
            return;
        }
        const std::uint8_t* at = at_; // kept here: for all that is known, what is written might be this reader
        bool sound = true;
        (read(v, at, sound), ...);
        at_ = at;
        ok &= sound;
    }
    template <Plain T> void value(T& v) { values(v); }
    // A count of things of at least `least` bytes each: more than the bytes that are left can hold is a lie.
    std::size_t count(std::size_t = 0, std::size_t least = 1) {
        std::uint64_t n = 0;
        value(n);
        if (n > left() / least) ok = false, n = 0;
        return static_cast<std::size_t>(n);
    }
    std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
    bool at_end() const { return at_ == end_; }

private:
    template <class T> static void read(T& v, const std::uint8_t*& at, bool& sound) {
        if constexpr (std::same_as<T, bool>) {
            sound &= *at <= 1;
            v = *at == 1;
        } else {
            std::memcpy(&v, at, sizeof(T));
        }
        if constexpr (std::floating_point<T>) sound &= std::isfinite(v);
        if constexpr (FloatRow<T>) {
            for (float f : std::bit_cast<std::array<float, sizeof(T) / sizeof(float)>>(v)) sound &= std::isfinite(f);
        }
        at += sizeof(T);
    }
    const std::uint8_t *at_, *end_;
};

// Fields that are all plain go in one piece; else one after the other.
template <class A, class... T>
    requires(Plain<std::remove_const_t<T>> && ...)
void visit(A& archive, T&... v) {
    archive.values(v...);
}
template <class A, class... T>
    requires(sizeof...(T) > 1 && !(Plain<std::remove_const_t<T>> && ...))
void visit(A& archive, T&... v) {
    (visit(archive, v), ...);
}

template <class V, class T>
concept Like = std::same_as<std::remove_const_t<V>, T>;

} // namespace evil
