#pragma once
// The threads of one World: a loop's chunks are handed out to whoever is free, and the caller works along.
//
// Which thread does a chunk is left to chance, so chunks may not depend on each other: each writes only what is its own.
// Then the result is the same for any number of threads. Where a sum is wanted, each chunk keeps one and the caller adds
// them in order; where chunks begin depends on `grain` alone.
//
//     parallel_for(threads, rows.size(), 256, [&](std::size_t first, std::size_t last) {
//         for (std::size_t i = first; i < last; ++i) move(rows[i]);
//     });
//
// One thread has no crew: the loop is a plain one. So it is where there are no threads at all, as in most browsers.
#include <cstddef>
#include <memory>
#include <type_traits>

namespace evil {

inline constexpr int kMaxThreads = 256;

class Threads {
public:
    explicit Threads(int count = 1);
    ~Threads();
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;

    int count() const { return count_; } // as asked for: the crew is smaller where the machine has fewer
    void set_count(int count);           // 1..kMaxThreads

    // While one lives, the crew waits awake: a loop begins within a microsecond. Otherwise it sleeps, and loops are the
    // caller's alone. The first one starts the crew.
    class Shift {
    public:
        explicit Shift(Threads& threads);
        ~Shift();
        Shift(const Shift&) = delete;
        Shift& operator=(const Shift&) = delete;

    private:
        Threads& threads_;
    };

    using Chunk = void (*)(void* work, std::size_t first, std::size_t last);
    void run(std::size_t count, std::size_t grain, Chunk chunk, void* work); // what parallel_for does with a crew
    bool has_crew() const { return crew_ != nullptr; }

private:
    struct Crew;
    int count_ = 1;
    std::unique_ptr<Crew> crew_;
};

// work(first, last) for chunks of `grain` of 0..count, in any order and on any thread. Not to be nested.
template <class Work> void parallel_for(Threads& threads, std::size_t count, std::size_t grain, Work&& work) {
    if (threads.has_crew() && count > grain) {
        using Plain = std::remove_reference_t<Work>;
        auto chunk = [](void* w, std::size_t first, std::size_t last) { (*static_cast<Plain*>(w))(first, last); };
        threads.run(count, grain, chunk, const_cast<void*>(static_cast<const void*>(&work)));
        return;
    }
    for (std::size_t first = 0; first < count; first += grain)
        work(first, count - first < grain ? count : first + grain);
}

} // namespace evil
