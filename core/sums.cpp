#include "hash.hpp"
#include "snapshot.hpp"
#include "state_fields.hpp"

namespace evil {
namespace {

// An archive that keeps nothing but a sum of what it is given.
class Summer {
public:
    static constexpr bool reading = false;
    template <class T>
        requires std::is_arithmetic_v<T> || std::is_enum_v<T>
    void value(const T& v) {
        std::uint64_t word = 0;
        std::memcpy(&word, &v, sizeof(T));
        h_ = mixed(h_, word);
    }
    std::size_t count(std::size_t n) {
        value(static_cast<std::uint64_t>(n));
        return n;
    }
    std::uint64_t sum() const { return finished(h_); }

private:
    std::uint64_t h_ = kHashSeed;
};

} // namespace

Sums sums(const World& world) {
    Summer bodies, contacts, forces;
    write_bodies(bodies, world);
    write_contacts(contacts, world);
    visit(forces, world.gravity);
    write_forces(forces, world);
    return {bodies.sum(), contacts.sum(), forces.sum()};
}

} // namespace evil
