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

// The board: number of the job and how many of its chunks nobody has taken, in one word, so that a thread that comes late
// cannot take a chunk of a job that it has not read. A job is only replaced when all its chunks are done.
struct Threads::Crew {
    alignas(64) std::atomic<std::uint64_t> board{0};
    alignas(64) std::atomic<std::size_t> done{0};
    std::size_t count = 0, grain = 1, chunks = 0;
    Chunk chunk = nullptr;
    void* work = nullptr;

    std::atomic<bool> awake{false}, over{false};
    std::mutex door;
    std::condition_variable bell;
    std::vector<std::thread> members;
    int process = this_process();

    explicit Crew(int size) {
        for (int i = 0; i < size; ++i) members.emplace_back([this] { serve(); });
    }
    ~Crew() {
        {
            std::lock_guard lock(door);
            over.store(true);
        }
        bell.notify_all();
        for (std::thread& member : members) member.join();
    }

    static std::uint32_t left(std::uint64_t word) { return static_cast<std::uint32_t>(word); }

    bool take_chunk() {
        std::uint64_t word = board.load(std::memory_order_acquire);
        do {
            if (left(word) == 0) return false;
        } while (!board.compare_exchange_weak(word, word - 1, std::memory_order_acq_rel, std::memory_order_acquire));
        std::size_t first = (chunks - left(word)) * grain;
        chunk(work, first, std::min(count, first + grain));
        done.fetch_add(1, std::memory_order_acq_rel);
        return true;
    }

    void serve() {
        int looks = 0;
        while (!over.load(std::memory_order_relaxed)) {
            if (take_chunk()) {
                looks = 0;
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
        threads.crew_ = std::make_unique<Crew>(std::min(threads.count_, std::max(cores, kAlwaysStarted)) - 1);
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
    std::uint64_t job = (crew.board.load(std::memory_order_relaxed) >> 32) + 1;
    crew.board.store(job << 32 | crew.chunks, std::memory_order_release);
    while (crew.take_chunk()) {}
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
