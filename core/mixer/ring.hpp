#pragma once
// A queue between two threads, one that only pushes and one that only pops: no locks, no allocation, nobody ever waits
// (Lamport 1983). Without threads it is a plain queue.
#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdint>
#include <memory>
#include <type_traits>

namespace evil::mixer {

template <class T> class Ring {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    explicit Ring(std::uint32_t least_capacity)
        : capacity_(std::bit_ceil(std::max(least_capacity, 1u))), items_(std::make_unique<T[]>(capacity_)) {}

    // For the thread that pushes. False, and nothing changed, when the ring is full.
    bool push(const T& item) noexcept {
        std::uint32_t end = pushed_.load(std::memory_order_relaxed);
        if (end - popped_.load(std::memory_order_acquire) == capacity_) return false;
        items_[end & (capacity_ - 1)] = item;
        pushed_.store(end + 1, std::memory_order_release);
        return true;
    }

    // For the thread that pops. The oldest item, or null when there is none; it stays until pop().
    const T* front() const noexcept {
        std::uint32_t begin = popped_.load(std::memory_order_relaxed);
        if (begin == pushed_.load(std::memory_order_acquire)) return nullptr;
        return &items_[begin & (capacity_ - 1)];
    }
    void pop() noexcept { popped_.store(popped_.load(std::memory_order_relaxed) + 1, std::memory_order_release); }

    std::uint32_t capacity() const noexcept { return capacity_; }

private:
    std::uint32_t capacity_; // a power of two, so that the counters may wrap round
    std::unique_ptr<T[]> items_;
    alignas(64) std::atomic<std::uint32_t> pushed_{0}; // a cache line each: the threads do not slow each other
    alignas(64) std::atomic<std::uint32_t> popped_{0};
};

} // namespace evil::mixer
