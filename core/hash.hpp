#pragma once
// 64 bits over bytes, for checksums: the same on every machine, no proof against malice.
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>

namespace evil {

// 64 bits over 8 bytes at a time: multiply, rotate, and a last avalanche (as in Appleby's MurmurHash3 finaliser).
inline std::uint64_t mixed(std::uint64_t h, std::uint64_t word) {
    return std::rotl(h ^ (word * 0xff51afd7ed558ccdull), 29) * 0xc4ceb9fe1a85ec53ull;
}
inline std::uint64_t finished(std::uint64_t h) {
    h ^= h >> 33;
    h *= 0xff51afd7ed558ccdull;
    return h ^ (h >> 33);
}
inline constexpr std::uint64_t kHashSeed = 0x9e3779b97f4a7c15ull;

inline std::uint64_t hash(std::span<const std::uint8_t> bytes) {
    std::uint64_t h = kHashSeed ^ bytes.size();
    std::size_t i = 0;
    for (; i + 8 <= bytes.size(); i += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + i, 8);
        h = mixed(h, word);
    }
    std::uint64_t tail = 0;
    for (std::size_t k = 0; i + k < bytes.size(); ++k) tail |= std::uint64_t{bytes[i + k]} << (8 * k);
    return finished(mixed(h, tail));
}

} // namespace evil
