#pragma once
// Which thread is in a world. A call from Python that takes a world, or a handle of something in one, is in that world
// until it returns; other threads' calls wait for it. So a step, and what else takes long, may let go of the GIL.
//
// It is the arguments' type casters that come in and go out, so no function of the binding can forget it.
#include "bind/convert.hpp"
#include "world.hpp"
#include <concepts>
#include <optional>

namespace evil::bind {

class Visit {
public:
    Visit() = default;
    Visit(const Visit&) = delete;
    Visit& operator=(const Visit&) = delete;
    ~Visit() {
        if (door_) door_->leave();
    }
    void enter(Door* door) noexcept;

private:
    Door* door_ = nullptr;
};

class Away { // this thread is without the GIL, and others run
public:
    Away();
    ~Away();
    Away(const Away&) = delete;
    Away& operator=(const Away&) = delete;

private:
    PyThreadState* mine_;
};

// Others run while one lives, if it is worth it: to ask for the GIL again may take 5 ms where they are busy, so that short
// work is done sooner with it.
class Meanwhile {
public:
    explicit Meanwhile(bool worth_it);

private:
    std::optional<Away> away_;
};

inline constexpr std::uint32_t kManyBodies = 100;  // about where a step takes 50 us
inline constexpr std::size_t kManyQuestions = 500; // and as many ray casts

inline bool is_large(const World& world) { return world.bodies.slots.count() >= kManyBodies; }

// Into which world an argument leads; a handle of nothing has no door. Handles add theirs.
inline Door* door_of(const World& world) { return &world.door; }
template <class T>
concept WayIn = requires(const T& value) {
    { door_of(value) } -> std::same_as<Door*>;
};
void enter(Visit& visit, const WayIn auto& value) { visit.enter(door_of(value)); }

} // namespace evil::bind

namespace nanobind::detail {

template <class T>
    requires evil::bind::WayIn<T>
struct type_caster<T> : type_caster_base<T> {
    bool from_python(handle source, std::uint8_t flags, cleanup_list* cleanup) noexcept {
        if (!type_caster_base<T>::from_python(source, flags, cleanup)) return false;
        const T* value = this->operator T*();
        if (!value || (flags & static_cast<std::uint8_t>(cast_flags::construct))) return true; // not there yet
        evil::bind::enter(visit_, *value);
        return true;
    }

private:
    evil::bind::Visit visit_;
};

} // namespace nanobind::detail
