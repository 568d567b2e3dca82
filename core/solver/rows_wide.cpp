// Rows of bodies moved on, and contacts brought into blocks and back.
#include "collider/contact.hpp"
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

// A contact's floats from `normal` on and those of its points, each read as eight in a row.
static_assert(offsetof(Contact, friction) == offsetof(Contact, normal) + 8);
static_assert(offsetof(ManifoldPoint, anchor_b) == 8 && offsetof(ManifoldPoint, separation) == 16);
static_assert(offsetof(ManifoldPoint, normal_impulse) == 20 && offsetof(ManifoldPoint, closing_speed) == 32);
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

EVIL_INLINE void fill_point(ContactBlock& k, BlockSource& from, int point, const Contact* const* contacts,
                            const Frame& frame, const Sides& s, Mask turned, Mask there) {
    const float* rows[8];
    for (int i = 0; i < 8; ++i) rows[i] = &contacts[i]->points[point].anchor_a.x;
    Floats p[8]; // anchor_a, anchor_b, separation, normal, tangent and total impulse
    load_rows_at(rows, p);
    Floats ax = select(turned, p[2], p[0]), ay = select(turned, p[3], p[1]);
    Floats bx = select(turned, p[0], p[2]), by = select(turned, p[1], p[3]);
    Floats an = frame.n(ax, ay), at = frame.t(ax, ay), bn = frame.n(bx, by), bt = frame.t(bx, by), zero = 0.0f;
    store(k.arm_n[point], bn);
    store(k.arm_t[point], bt);
    if (point == 0) {
        store(k.apart_n, bn - an);
        store(k.apart_t, bt - at);
        Floats small = 1e-3f; // of an arm: it leads along the normal, so each is a disc about its body's centre
        Mask discs = (bn < zero) & (zero < an) & (abs(at) <= small * an) & (abs(bt) <= -small * bn);
        discs = discs & (load(k.lag) == Floats(0.5f)) & (p[4] < 0.5f * (an - bn));
        store(k.lag, select(discs, Floats(-1.0f) / select(discs, (an - bn) - p[4], Floats(1.0f)), load(k.lag)));
    }
    store(k.gap[point], select(there, p[4], zero));
    store(k.normal_mass[point], select(there, effective_mass(s, at, bt), zero));
    store(k.tangent_mass[point], select(there, effective_mass(s, an, bn), zero));
    store(k.normal_impulse[point], select(there, p[5], zero));
    store(k.tangent_impulse[point], select(there, p[6], zero));
    store(k.total_impulse[point], zero);
    Floats parting = frame.n(s.b[0] - s.a[0], s.b[1] - s.a[1]) + (s.b[2] * bt - s.a[2] * at);
    store(from.closing_speed[point], select(there, -parting, zero));
}

// The contact point goes along with the body whose corner it is, which is not the one whose face was the reference; halfway
// where nobody knows, and with the one that moves at a wall.
EVIL_INLINE float lag_of(const Contact& c, const ContactBlock& k, int lane) {
    if (k.a[lane] == 0) return 0.0f;
    return !c.axis.known ? 0.5f : c.axis.of_b ? 1.0f : 0.0f;
}

EVIL_INLINE void fill_block(const SolverBody* bodies, const Contact* contacts, ContactBlock& k, BlockSource& from) {
    const Contact* each[8];
    const float* heads[8];
    std::int32_t points[8];
    float lag[8];
    for (int i = 0; i < 8; ++i) {
        each[i] = from.contact[i] == kNone ? &kNoContact : contacts + from.contact[i];
        heads[i] = &each[i]->normal.x;
        points[i] = each[i]->count;
        lag[i] = lag_of(*each[i], k, i);
        k.surface_speed[i] = each[i]->surface_speed;
    }
    Floats head[8]; // normal, friction, and what is not asked for here
    Sides s;
    load_rows_at(heads, head);
    load_rows(&bodies->vx, k.a, s.a);
    load_rows(&bodies->vx, k.b, s.b);
    Mask turned = load(from.turn) < Ints(0), wall = s.a[3] == Floats(0.0f);
    Frame frame{select(turned, -head[0], head[0]), select(turned, -head[1], head[1])};
    store(k.nx, frame.nx);
    store(k.ny, frame.ny);
    store(k.friction, head[2]);
    store(k.lag, select(wall, Floats(0.0f), load(lag)));
    fill_point(k, from, 0, each, frame, s, turned, Ints(0) < load(points));
    fill_point(k, from, 1, each, frame, s, turned, Ints(1) < load(points));
}

EVIL_INLINE void store_point(const ContactBlock& k, const BlockSource& from, int point, Contact* contacts) {
    float nowhere[8][4];
    float* rows[8];
    for (int i = 0; i < 8; ++i)
        rows[i] = from.contact[i] == kNone ? nowhere[i] : &contacts[from.contact[i]].points[point].normal_impulse;
    Floats most = kMaxForce;
    Floats field[4] = {within(load(k.normal_impulse[point]), most), within(load(k.tangent_impulse[point]), most),
                       within(load(k.total_impulse[point]), most), within(load(from.closing_speed[point]), most)};
    store_half_rows_at(rows, field);
}

} // namespace

void push_bodies(SolverBody* bodies, ForceStep* force_steps, std::size_t count, bool warm) noexcept {
    Floats most = load(kMost), zero = 0.0f;
    Mask speeds = warm ? first_lanes(3) : first_lanes(0);
    for (std::size_t i = 0; i < count; ++i) {
        Floats row = load(&bodies[i].vx), by_contacts = select(speeds, row - load(force_steps[i].pushed), zero);
        Floats pushed = within(row * load(force_steps[i].keep) + load(force_steps[i].gain), most); // (4.2), (4.5)
        store(force_steps[i].pushed, pushed);
        store(&bodies[i].vx, within(pushed + by_contacts, most));
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
    for (std::size_t i = 0; i < count; ++i) fill_block(bodies, contacts, blocks[i], sources[i]);
}

void store_impulses(const ContactBlock* blocks, const BlockSource* sources, Contact* contacts,
                    std::size_t count) noexcept {
    for (std::size_t i = 0; i < count; ++i) {
        store_point(blocks[i], sources[i], 0, contacts);
        store_point(blocks[i], sources[i], 1, contacts);
    }
}

} // namespace evil::EVIL_ISA
