// Eight manifolds into their contacts. The points of the last step leave their impulses to those with their ids.
#include "collider/contact.hpp"
#include "collider/manifolds_wide.hpp"
#include "math/wide_rows.hpp"

namespace evil::EVIL_ISA {
namespace {

// The rows of eight contacts, a lane for each; see ContactRows.
struct WideContacts {
    Floats head[8], first[8], middle[8], last[8];

    Ints axis() const { return float_to_bits(head[0]); } // edge, of_b, known: 2, 1 and 1 bytes
    Ints told() const { return float_to_bits(head[1]); } // count, fresh, touching, struck: a byte each
};

EVIL_INLINE void load_contacts(Contact* const* contacts, WideContacts& w) {
    load_rows_at(contacts, ContactRows::kHead, w.head);
    load_rows_at(contacts, ContactRows::kFirst, w.first);
    load_rows_at(contacts, ContactRows::kMiddle, w.middle);
    load_rows_at(contacts, ContactRows::kLast, w.last);
}

EVIL_INLINE void store_contacts(Contact* const* contacts, const WideContacts& w) {
    store_rows_at(contacts, ContactRows::kHead, w.head);
    store_rows_at(contacts, ContactRows::kFirst, w.first);
    store_rows_at(contacts, ContactRows::kMiddle, w.middle);
    store_rows_at(contacts, ContactRows::kLast, w.last);
}

// The ten floats of each point, where they lie in the rows.
struct WidePoints {
    Floats* of[2][10];
    explicit WidePoints(WideContacts& w) {
        for (int i = 0; i < 8; ++i) of[0][i] = &w.first[i];
        for (int i = 0; i < 2; ++i) of[0][8 + i] = &w.middle[i], of[1][i] = &w.middle[2 + i];
        for (int i = 2; i < 10; ++i) of[1][i] = &w.last[i - 2];
    }
};

enum Field {
    anchor_ax,
    anchor_ay,
    anchor_bx,
    anchor_by,
    separation,
    normal_impulse,
    tangent_impulse,
    total,
    closing,
    id
};

EVIL_INLINE Mask byte_is_set(Ints word, int byte) { return Ints(0) < (word & (127 << (8 * byte))); }

// As packed() in manifolds.cpp, but with the bytes of an Axis.
EVIL_INLINE Ints axis_bytes(Ints axis) {
    return select(axis == Ints(kNoAxis), Ints(0), (axis & (kAxisOfB | (kAxisOfB - 1))) | (1 << 24));
}

EVIL_INLINE void store_marks(const WideContacts& w, Mask meets, Floats deepest, std::uint8_t* marks) {
    Ints told = w.told(), none = 0;
    Mask compound = byte_is_set(float_to_bits(w.head[2]), 1);
    Mask telling = compound | (~meets & (byte_is_set(told, 2) | byte_is_set(told, 3)));
    auto mark = [&](Mask when, std::uint8_t what) { return select(when, Ints(what), none); };
    store_bytes(marks, mark(telling, kTelling) | mark(meets, kMeets) |
                           mark(meets & (deepest <= Floats(-kDeepOverlap)), kDeep) |
                           mark(meets & (w.head[6] > Floats(0.0f)), kBounces));
}

} // namespace

void take_over(const EightManifolds& m, Contact* const* contacts, std::uint8_t* marks) noexcept {
    WideContacts w;
    load_contacts(contacts, w);
    WidePoints p(w);
    Ints count = load(m.count), last_count = w.told() & 255, last_id[2];
    Floats last_normal[2], last_tangent[2], zero = 0.0f;
    for (int i = 0; i < 2; ++i) {
        last_id[i] = float_to_bits(*p.of[i][id]);
        last_normal[i] = *p.of[i][normal_impulse];
        last_tangent[i] = *p.of[i][tangent_impulse];
    }
    Mask meets =
        Ints(0) < count; // the manifold of bodies that have parted stays as it was last: it says where they touched
    w.head[0] = bits_to_float(axis_bytes(load(m.axis)));
    w.head[1] = bits_to_float((w.told() & ~255) | count);
    w.head[3] = select(meets, load(m.normal_x), w.head[3]);
    w.head[4] = select(meets, load(m.normal_y), w.head[4]);
    for (int i = 0; i < 2; ++i) {
        const auto& from = m.points[i];
        Mask there = Ints(i) < count;
        Ints new_id = load(from.id);
        Mask was_first = (Ints(0) < last_count) & (last_id[0] == new_id);
        Mask was_second = (Ints(1) < last_count) & (last_id[1] == new_id);
        auto left = [&](const Floats* impulse) {
            return select(was_second, impulse[1], select(was_first, impulse[0], zero));
        };
        auto put = [&](Field field, Floats value) {
            *p.of[i][field] = select(meets, select(there, value, zero), *p.of[i][field]);
        };
        put(anchor_ax, load(from.anchor_ax));
        put(anchor_ay, load(from.anchor_ay));
        put(anchor_bx, load(from.anchor_bx));
        put(anchor_by, load(from.anchor_by));
        put(separation, load(from.separation));
        put(normal_impulse, left(last_normal));
        put(tangent_impulse, left(last_tangent));
        put(total, zero);
        put(closing, zero);
        put(id, bits_to_float(new_id));
    }
    store_contacts(contacts, w);
    Floats one = *p.of[0][separation], two = *p.of[1][separation];
    store_marks(w, meets, select((Ints(1) < count) & (two < one), two, one), marks);
}

} // namespace evil::EVIL_ISA
