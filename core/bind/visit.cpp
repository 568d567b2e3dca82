#include "bind/visit.hpp"
#include <chrono>
#include <thread>

namespace evil::bind {
namespace {

// Both are guarded by the GIL. When Python ends, a thread that asks for the GIL is ended where it is, which C++ answers by
// ending the process: so all of them are called back before, and stay.
int threads_away = 0;
bool closing = false;

void call_back() {
    closing = true;
    while (threads_away > 0) {
        nb::gil_scoped_release others;
        std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
}

void queue(Door& door, Door::Thread me) {
    Door::Ticket ticket = door.take_ticket();
    while (!door.enter(me, ticket)) {
        std::uint64_t seen = door.rings();
        Away others_run;
        door.wait(seen);
    }
}

} // namespace

Away::Away() : mine_((++threads_away, PyEval_SaveThread())) {}

Away::~Away() {
    PyEval_RestoreThread(mine_);
    --threads_away;
}

void Visit::enter(Door* door) noexcept {
    if (!door) return;
    Door::Thread me = PyThread_get_thread_ident();
    if (!door->enter(me, closing)) queue(*door, me);
    door_ = door;
}

Meanwhile::Meanwhile(bool worth_it) {
    if (worth_it && !closing) away_.emplace();
}

void register_threads() { nb::module_::import_("atexit").attr("register")(nb::cpp_function(call_back)); }

} // namespace evil::bind
