#include "threads.hpp"
#include <algorithm>

#if defined(__EMSCRIPTEN__) && !defined(__EMSCRIPTEN_PTHREADS__)
#define EVIL_THREADS 0
#else
#define EVIL_THREADS 1
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>
#if !defined(_WIN32)
#include <unistd.h>
#endif
#endif

namespace evil {

#if EVIL_THREADS

namespace {

// More threads than this are only started where the machine has them: those that have no core of their own wait for
// others. Not fewer, so that tests mean the same on any machine.
constexpr int kAlwaysStarted = 4;

constexpr int kLooks = 256; // at the board before others on the same core are let in

void breathe(int& looks) {
    if (++looks < kLooks) {
#if defined(__x86_64__) || defined(__i386__)
        __builtin_ia32_pause();
#endif
        return;
    }
    looks = 0;
    std::this_thread::yield();
}

#if defined(_WIN32)
int this_process() { return 0; } // a process does not split there
#else
int this_process() { return static_cast<int>(getpid()); }
#endif

} // namespace

// Each thread has a share of the chunks of its own, and the same one of the next job over as many: so what it worked on lies
// in its own cache still. Who is through takes from the far ends of the others'.
//
// A share is the first chunk that nobody has taken and the end, in one word: whoever changes it has taken a chunk of the
// job as it is now, even if what he compared it with was read in an earlier one. A job is only replaced when all its chunks
// are done, and its shares are dealt out after all else is known of it.
class Share {
public:
    void deal(std::size_t first, std::size_t end) {
        word_.store(std::uint64_t{first} << 32 | end, std::memory_order_release);
    }
    bool take(bool own, std::size_t& chunk) {
        std::uint64_t word = word_.load(std::memory_order_acquire);
        while (true) {
            std::uint64_t first = word >> 32, end = word & 0xffffffffu;
            if (first >= end) return false;
            chunk = own ? first : end - 1;
            std::uint64_t left = own ? word + (std::uint64_t{1} << 32) : word - 1;
            if (word_.compare_exchange_weak(word, left, std::memory_order_acq_rel, std::memory_order_acquire))
                return true;
        }
    }

private:
    alignas(64) std::atomic<std::uint64_t> word_{0};
};

struct Threads::Crew {
    std::vector<Share> shares;                     // the caller's, then those of the members
    alignas(64) std::atomic<std::uint64_t> job{0}; // a line of the cache that all read, and one that all write
    std::size_t count = 0, grain = 1, chunks = 0;
    Chunk chunk = nullptr;
    void* work = nullptr;
    alignas(64) std::atomic<std::size_t> done{0};

    alignas(64) std::atomic<bool> awake{false};
    std::atomic<bool> over{false};
    std::mutex door;
    std::condition_variable bell;
    std::vector<std::thread> members;
    int process = this_process();

    explicit Crew(std::size_t size) : shares(size + 1) {
        for (std::size_t i = 1; i <= size; ++i) members.emplace_back([this, i] { serve(i); });
    }
    ~Crew() {
        {
            std::lock_guard lock(door);
            over.store(true);
        }
        bell.notify_all();
        for (std::thread& member : members) member.join();
    }

    std::size_t work_on_share(std::size_t share, bool own) {
        std::size_t did = 0;
        for (std::size_t number; shares[share].take(own, number); ++did) {
            std::size_t first = number * grain;
            chunk(work, first, std::min(count, first + grain));
        }
        return did;
    }

    // What it did is told at the end and at once: the others look at that line, too.
    void work_on(std::size_t me) {
        std::size_t did = work_on_share(me, true);
        for (std::size_t next = 1; next < shares.size(); ++next)
            did += work_on_share((me + next) % shares.size(), false);
        if (did > 0) done.fetch_add(did, std::memory_order_acq_rel);
    }

    void serve(std::size_t me) {
        int looks = 0;
        for (std::uint64_t last = 0; !over.load(std::memory_order_relaxed);) {
            if (std::uint64_t now = job.load(std::memory_order_acquire); now != last) {
                last = now;
                looks = 0;
                work_on(me);
            } else if (awake.load(std::memory_order_acquire)) {
                breathe(looks);
            } else {
                std::unique_lock lock(door);
                bell.wait(lock, [this] { return awake.load() || over.load(); });
            }
        }
    }

    void wake(bool up) {
        {
            std::lock_guard lock(door);
            awake.store(up);
        }
        if (up) bell.notify_all();
    }
};

Threads::Threads(int count) { set_count(count); }

Threads::~Threads() {
    if (crew_ && crew_->process != this_process()) (void)crew_.release(); // the threads stayed with the parent process
}

void Threads::set_count(int count) {
    count_ = std::clamp(count, 1, kMaxThreads);
    crew_.reset();
}

Threads::Shift::Shift(Threads& threads) : threads_(threads) {
    if (threads.count_ == 1) return;
    // A fork has no threads but the one that forked.
    if (threads.crew_ && threads.crew_->process != this_process()) (void)threads.crew_.release();
    if (!threads.crew_) {
        const int cores = static_cast<int>(std::thread::hardware_concurrency());
        const int size = std::min(threads.count_, std::max(cores, kAlwaysStarted)) - 1;
        threads.crew_ = std::make_unique<Crew>(static_cast<std::size_t>(size));
    }
    threads.crew_->wake(true);
}

Threads::Shift::~Shift() {
    if (threads_.crew_) threads_.crew_->wake(false);
}

void Threads::run(std::size_t count, std::size_t grain, Chunk chunk, void* work) {
    Crew& crew = *crew_;
    crew.count = count;
    crew.grain = grain;
    crew.chunks = (count + grain - 1) / grain;
    crew.chunk = chunk;
    crew.work = work;
    crew.done.store(0, std::memory_order_relaxed);
    std::size_t shares = crew.shares.size();
    for (std::size_t i = 0; i < shares; ++i)
        crew.shares[i].deal(crew.chunks * i / shares, crew.chunks * (i + 1) / shares);
    crew.job.fetch_add(1, std::memory_order_release);
    crew.work_on(0);
    for (int looks = 0; crew.done.load(std::memory_order_acquire) != crew.chunks;) breathe(looks);
}

#else

struct Threads::Crew {};
Threads::Threads(int count) { set_count(count); }
Threads::~Threads() = default;
void Threads::set_count(int count) { count_ = std::clamp(count, 1, kMaxThreads); }
Threads::Shift::Shift(Threads& threads) : threads_(threads) { (void)threads_; }
Threads::Shift::~Shift() = default;
void Threads::run(std::size_t count, std::size_t, Chunk chunk, void* work) { chunk(work, 0, count); }

#endif

} // namespace evil
