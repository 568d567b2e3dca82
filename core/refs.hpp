#pragma once
// Typed references: a slot and its generation (SPEC A6). A reference whose object is gone is known by its generation.
#include <algorithm>
#include <cassert>
#include <cstdint>
#include <functional>
#include <queue>
#include <vector>

namespace evil {

inline constexpr std::uint32_t kNone = 0xffffffffu; // "no slot"

template <class Tag> struct Ref {
    std::uint32_t slot = kNone, generation = 0;
    friend bool operator==(Ref, Ref) = default;
};
using BodyRef = Ref<struct BodyTag>;
using ShapeRef = Ref<struct ShapeTag>;
using ForceRef = Ref<struct ForceTag>;

// Which slots are taken. Odd generation: taken; even: free. Generations only grow, also when a snapshot is restored, so
// a stale reference never becomes another object. The lowest free slot is taken first: the order is canonical, and
// follows from which slots are taken alone.
class Slots {
public:
    std::uint32_t size() const { return static_cast<std::uint32_t>(generation_.size()); }
    std::uint32_t count() const { return count_; }
    bool taken(std::uint32_t slot) const { return slot < size() && (generation_[slot] & 1u); }
    std::uint32_t generation(std::uint32_t slot) const { return generation_[slot]; }
    const std::vector<std::uint32_t>& generations() const { return generation_; }
    template <class Tag> bool alive(Ref<Tag> ref) const {
        return ref.slot < size() && generation_[ref.slot] == ref.generation && (ref.generation & 1u);
    }

    std::uint32_t take() {
        std::uint32_t slot = size();
        if (free_.empty()) {
            generation_.push_back(0);
        } else {
            slot = free_.top();
            free_.pop();
        }
        ++generation_[slot];
        ++count_;
        return slot;
    }
    void release(std::uint32_t slot) {
        assert(taken(slot));
        ++generation_[slot];
        --count_;
        free_.push(slot);
    }

    // Become the slots that `now_taken` says, for a restore. A slot where `same` is true holds the same object as before
    // and keeps its generation; any other gets a new one.
    void restore(const std::vector<bool>& now_taken, const std::vector<bool>& same) {
        std::size_t n = std::max(generation_.size(), now_taken.size());
        generation_.resize(n, 0);
        free_ = {};
        count_ = 0;
        // Slots beyond the snapshot stay as free ones: their generations must survive.
        for (std::size_t i = 0; i < n; ++i) {
            bool was = generation_[i] & 1u, is = i < now_taken.size() && now_taken[i];
            bool kept = was && is && i < same.size() && same[i];
            if (was && !kept) ++generation_[i];
            if (is && !kept) ++generation_[i];
            if (is) ++count_;
            if (!is) free_.push(static_cast<std::uint32_t>(i));
        }
    }

private:
    std::vector<std::uint32_t> generation_;
    std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> free_;
    std::uint32_t count_ = 0;
};

} // namespace evil
