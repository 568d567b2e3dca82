#pragma once
// 64 bits over bytes, for checksums: the same on every machine, no proof against malice.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>

namespace evil {

// Multiply and rotate, and a last avalanche, as in Appleby's MurmurHash3. Four sums side by side, each over every fourth
// word, so that a processor need not wait for one multiplication before it begins the next.
class Hash {
public:
    static constexpr std::size_t kStripe = 32; // bytes

    // Whole stripes; only the last call before sum() may end within one.
    void add(std::span<const std::uint8_t> bytes) {
        std::size_t i = 0;
        for (; i + kStripe <= bytes.size(); i += kStripe)
            for (std::size_t lane = 0; lane < 4; ++lane) mix(lanes_[lane], word(bytes.data() + i + 8 * lane, 8));
        for (; i < bytes.size(); i += 8)
            mix(lanes_[i / 8 % 4], word(bytes.data() + i, std::min<std::size_t>(8, bytes.size() - i)));
        size_ += bytes.size();
    }
    std::uint64_t size() const { return size_; }
    std::uint64_t sum() const {
        std::uint64_t h = kSeed ^ size_;
        for (std::uint64_t lane : lanes_) mix(h, lane);
        return avalanche(h);
    }

private:
    static constexpr std::uint64_t kSeed = 0x9e3779b97f4a7c15ull;
    static std::uint64_t word(const std::uint8_t* at, std::size_t size) {
        std::uint64_t w = 0;
        std::memcpy(&w, at, size);
        return w;
    }
    static void mix(std::uint64_t& h, std::uint64_t w) {
        h = std::rotl(h ^ (w * 0xff51afd7ed558ccdull), 29) * 0xc4ceb9fe1a85ec53ull;
    }
    static std::uint64_t avalanche(std::uint64_t h) {
        h = (h ^ (h >> 33)) * 0xff51afd7ed558ccdull;
        return h ^ (h >> 33);
    }
    std::uint64_t lanes_[4] = {kSeed, kSeed + 1, kSeed + 2, kSeed + 3};
    std::uint64_t size_ = 0;
};

inline std::uint64_t hash(std::span<const std::uint8_t> bytes) {
    Hash h;
    h.add(bytes);
    return h.sum();
}

} // namespace evil
