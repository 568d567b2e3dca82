// Rows of bodies moved on, and contacts brought into blocks and back.
#include "collider/contact.hpp"
#include "math/wide_fours.hpp"
#include "math/wide_rows.hpp"
#include "solver/contacts_wide.hpp"
#include <cstddef>

namespace evil::EVIL_ISA {
namespace {

constexpr float kMostMoved = 1e30f; // what has no limit of its own stays finite all the same
constexpr float kMost[8] = {kMaxSpeed, kMaxSpeed, kMaxSpin, kMostMoved, kMostMoved, kMostMoved, kMostMoved, kMostMoved};

EVIL_INLINE Floats within(Floats x, Floats most) { // not-a-number becomes 0
    return select(x == x, clamp(x, -most, most), Floats(0.0f));
}

EVIL_INLINE Floats inverse(Floats k) {
    Floats zero = 0.0f, one = 1.0f;
    return select(k > zero, one / select(k > zero, k, one), zero);
}

constexpr Contact kNoContact{};

struct Frame {
    Floats nx, ny; // t = (ny, -nx)
    EVIL_INLINE Floats n(Floats x, Floats y) const { return x * nx + y * ny; }
    EVIL_INLINE Floats t(Floats x, Floats y) const { return x * ny - y * nx; }
};

struct Sides { // two bodies' rows, a lane for each contact
    Floats a[8], b[8];
};

// (4.8)'s denominator: what one newton second changes of the relative speed, by the arms across its direction.
EVIL_INLINE Floats effective_mass(const Sides& s, Floats across_a, Floats across_b) {
    return inverse((s.a[3] + s.b[3]) + (s.a[7] * (across_a * across_a) + s.b[7] * (across_b * across_b)));
}

struct Point { // of a manifold, as its row has it
    Floats anchor_ax, anchor_ay, anchor_bx, anchor_by, separation, normal_impulse, tangent_impulse;
};

EVIL_INLINE void fill_point(ContactBlock& k, BlockSource& from, int point, const Point& p, const Frame& frame,
                            const Sides& s, Mask turned, Mask there) {
    Floats ax = select(turned, p.anchor_bx, p.anchor_ax), ay = select(turned, p.anchor_by, p.anchor_ay);
    Floats bx = select(turned, p.anchor_ax, p.anchor_bx), by = select(turned, p.anchor_ay, p.anchor_by);
    Floats an = frame.n(ax, ay), at = frame.t(ax, ay), bn = frame.n(bx, by), bt = frame.t(bx, by), zero = 0.0f;
    store(k.arm_n[point], bn);
    store(k.arm_t[point], bt);
    if (point == 0) {
        store(k.apart_n, bn - an);
        store(k.apart_t, bt - at);
        Floats small = 1e-3f; // of an arm: it leads along the normal, so each is a disc about its body's centre
        Mask discs = (bn < zero) & (zero < an) & (abs(at) <= small * an) & (abs(bt) <= -small * bn);
        discs = discs & (load(k.lag) == Floats(0.5f)) & (p.separation < 0.5f * (an - bn));
        store(k.lag, select(discs, Floats(-1.0f) / select(discs, (an - bn) - p.separation, Floats(1.0f)), load(k.lag)));
    }
    store(k.gap[point], select(there, p.separation, zero));
    store(k.normal_mass[point], select(there, effective_mass(s, at, bt), zero));
    store(k.tangent_mass[point], select(there, effective_mass(s, an, bn), zero));
    store(k.normal_impulse[point], select(there, p.normal_impulse, zero));
    store(k.tangent_impulse[point], select(there, p.tangent_impulse, zero));
    store(k.total_impulse[point], zero);
    Floats parting = frame.n(s.b[0] - s.a[0], s.b[1] - s.a[1]) + (s.b[2] * bt - s.a[2] * at);
    store(from.closing_speed[point], select(there, -parting, zero));
}

// What a byte of each lane says.
EVIL_INLINE Mask is_set(Ints word, int byte) { return Ints(0) < (word & (127 << (8 * byte))); }

// The contact point goes along with the body whose corner it is, which is not the one whose face was the reference; halfway
// where nobody knows, and with the one that moves at a wall.
EVIL_INLINE Floats lag_of(Ints axis, Mask wall) {
    Floats lag = select(is_set(axis, 2), Floats(1.0f), Floats(0.0f));
    return select(wall, Floats(0.0f), select(is_set(axis, 3), lag, Floats(0.5f)));
}

// The rows of a block lie apart from each other, so the memory is told of them some blocks ahead.
constexpr std::size_t kAhead = 4;

EVIL_INLINE void foretell(const Contact* contacts, const BlockSource& from) {
    for (std::uint32_t contact : from.contact) {
        if (contact == kNone) continue;
        __builtin_prefetch(contacts + contact);
        __builtin_prefetch(reinterpret_cast<const char*>(contacts + contact) + 64);
    }
}

EVIL_INLINE void foretell_impulses(Contact* contacts, const BlockSource& from) {
    for (std::uint32_t contact : from.contact)
        if (contact != kNone) __builtin_prefetch(contacts[contact].points + 1, 1);
}

// A disc on a wall that does not turn is a disc on one without end. A corner just below its body's centre is taken for one
// too, in the one step in which it is there.
EVIL_INLINE void note_rolling(ContactBlock& k, Mask maybe) {
    constexpr float kStraight = 1e-3f, kNoCurve = 1e-30f;
    Floats bn = load(k.arm_n[0]);
    Mask discs = maybe & (bn < Floats(0.0f)) & (abs(load(k.arm_t[0])) <= Floats(-kStraight) * bn);
    store(k.lag, select(discs, Floats(-kNoCurve), load(k.lag)));
}

EVIL_INLINE void fill_block(const SolverBody* bodies, const Contact* contacts, ContactBlock& k, BlockSource& from) {
    const Contact* each[8];
    for (int i = 0; i < 8; ++i) each[i] = from.contact[i] == kNone ? &kNoContact : contacts + from.contact[i];
    Floats head[8], p[8], q[8]; // axis, count ..., normal, friction, surface speed; the first point; the second
    Sides s;
    load_rows_at(each, ContactRows::kHead, head);
    load_rows_at(each, ContactRows::kFirst, p);
    load_rows_at(each, ContactRows::kSecond, q);
    load_rows<1>(&bodies->vx, k.a, s.a);
    load_rows<1>(&bodies->vx, k.b, s.b);
    Ints known = float_to_bits(head[1]), count = known & 255;
    Mask turned = load(from.turn) < Ints(0), wall = s.a[3] == Floats(0.0f);
    Frame frame{select(turned, -head[3], head[3]), select(turned, -head[4], head[4])};
    store(from.known, known);
    store(k.nx, frame.nx);
    store(k.ny, frame.ny);
    store(k.friction, head[5]);
    store(k.surface_speed, head[7]);
    store(k.lag, lag_of(float_to_bits(head[0]), wall));
    fill_point(k, from, 0, {p[0], p[1], p[2], p[3], p[4], p[5], p[6]}, frame, s, turned, Ints(0) < count);
    fill_point(k, from, 1, {q[0], q[1], q[2], q[3], q[4], q[5], q[6]}, frame, s, turned, Ints(1) < count);
    note_rolling(k, (count < Ints(2)) & wall & (s.a[2] == Floats(0.0f)));
}

struct Told { // what events ask (collider/events.cpp)
    Mask touching, struck;
};

EVIL_INLINE void store_point(const ContactBlock& k, const BlockSource& from, int point, Contact* const* rows,
                             Mask there, Floats near, Floats hit_speed, Told& told) {
    Floats most = kMaxForce;
    Floats field[4] = {within(load(k.normal_impulse[point]), most), within(load(k.tangent_impulse[point]), most),
                       within(load(k.total_impulse[point]), most), within(load(from.closing_speed[point]), most)};
    store_half_rows_at(rows, ContactRows::kImpulses[point], field);
    Mask pushed = field[2] > Floats(0.0f);
    told.touching = told.touching | (there & (pushed | (load(k.gap[point]) <= near)));
    told.struck = told.struck | (there & pushed & (field[3] > hit_speed));
}

EVIL_INLINE void store_block(const ContactBlock& k, const BlockSource& from, Contact* contacts, std::uint8_t* marks,
                             Floats hit_speed) {
    Ints known = load(from.known);
    Mask touched = is_set(known, 2), struck = is_set(known, 3);
    Floats near = select(touched, Floats(kSlop), Floats(0.0f));
    Told told{first_lanes(0), first_lanes(0)};
    alignas(Contact) std::byte nowhere[sizeof(Contact)]; // is only written
    Contact* rows[8];
    for (int i = 0; i < 8; ++i)
        rows[i] = from.contact[i] == kNone ? reinterpret_cast<Contact*>(nowhere) : contacts + from.contact[i];
    store_point(k, from, 0, rows, Ints(0) < (known & 255), near, hit_speed, told);
    store_point(k, from, 1, rows, Ints(1) < (known & 255), near, hit_speed, told);
    unsigned changed = (bits(told.touching) ^ bits(touched)) | (bits(told.struck) ^ bits(struck));
    for (int i = 0; changed != 0; changed >>= 1, ++i)
        if (changed & 1u) marks[from.contact[i]] |= kTelling;
}

} // namespace

void push_bodies(SolverBody* bodies, ForceStep* force_steps, std::size_t count, bool warm) noexcept {
    Floats most = load_fours(kMost, kMost), zero = 0.0f, ones = 1.0f;
    constexpr float kSpeeds[4] = {1, 1, 1, 0};
    Mask speeds = warm ? load_fours(kSpeeds, kSpeeds) == ones : first_lanes(0);
    for (std::size_t i = 0; i < count; i += 2) {
        std::size_t next = i + 1 < count ? i + 1 : i; // two at once; the last may be alone
        ForceStep &f = force_steps[i], &g = force_steps[next];
        Floats row = load_fours(&bodies[i].vx, &bodies[next].vx);
        Floats by_contacts = select(speeds, row - load_fours(f.pushed, g.pushed), zero);
        Floats pushed = row * load_fours(f.keep, g.keep) + load_fours(f.gain, g.gain); // (4.2), (4.5)
        pushed = within(pushed, most);
        store_fours(f.pushed, g.pushed, pushed);
        store_fours(&bodies[i].vx, &bodies[next].vx, within(pushed + by_contacts, most));
    }
}

void move_bodies(SolverBody* bodies, std::size_t count, float h) noexcept {
    const float share[8] = {0, 0, 0, 0, h, h, h, 0};
    Floats most = load(kMost), way = load(share);
    for (std::size_t i = 0; i < count; ++i) {
        Floats row = within(load(&bodies[i].vx), most);
        store(&bodies[i].vx, row + swap_fours(row) * way); // (4.1), (4.4)
    }
}

void fill_blocks(const SolverBody* bodies, const Contact* contacts, ContactBlock* blocks, BlockSource* sources,
                 std::size_t count) noexcept {
    for (std::size_t i = 0; i < count; ++i) {
        if (i + kAhead < count) foretell(contacts, sources[i + kAhead]);
        fill_block(bodies, contacts, blocks[i], sources[i]);
    }
}

void store_impulses(const ContactBlock* blocks, const BlockSource* sources, Contact* contacts, std::uint8_t* marks,
                    std::size_t count, float hit_speed) noexcept {
    for (std::size_t i = 0; i < count; ++i) {
        if (i + kAhead < count) foretell_impulses(contacts, sources[i + kAhead]);
        store_block(blocks[i], sources[i], contacts, marks, hit_speed);
    }
}

} // namespace evil::EVIL_ISA
