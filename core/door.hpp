#pragma once
// Who is in a world: one thread at a time, which may come in again as often as it likes. The others queue outside.
//
// Whoever comes and goes holds one lock that all of them share: to Python's binding, the GIL. So coming in costs an
// addition. Inside, a thread may let go of that lock while it works, as a step does: the door keeps the others out.
#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace evil {

class Door {
public:
    using Thread = std::uint64_t;
    using Ticket = std::uint64_t;

    // With the shared lock. False: another thread is inside, or was here first; take a ticket and wait. `pushing` goes
    // before those who wait.
    bool enter(Thread me, bool pushing) {
        if (depth_ != 0 ? inside_ != me : given_ != called_ && !pushing) return false;
        inside_ = me;
        ++depth_;
        return true;
    }
    Ticket take_ticket() { return given_++; }
    bool enter(Thread me, Ticket ticket) {
        if (depth_ != 0 || ticket != called_) return false;
        ++called_;
        inside_ = me;
        depth_ = 1;
        return true;
    }
    void leave() {
        if (--depth_ == 0 && given_ != called_) ring();
    }
    std::uint64_t rings() const { return rings_; } // before the lock is let go of, for wait()

    // Without it: until somebody rang who had not when `seen` was read.
    void wait(std::uint64_t seen) {
        std::unique_lock lock(mutex_);
        bell_.wait(lock, [&] { return rings_ != seen; });
    }

private:
    void ring() {
        {
            std::lock_guard lock(mutex_);
            ++rings_;
        }
        bell_.notify_all();
    }

    Thread inside_ = 0;
    std::uint32_t depth_ = 0;
    Ticket given_ = 0, called_ = 0; // the queue: those from `called_` on wait still
    std::uint64_t rings_ = 0;       // written with both locks
    std::mutex mutex_;
    std::condition_variable bell_;
};

} // namespace evil
