#include "snapshot.hpp"
#include "fluid/state.hpp"
#include "shapes/polygon.hpp"
#include "state_fields.hpp"
#include <memory>

namespace evil {
namespace {

constexpr char kMagic[8] = {'E', 'V', 'I', 'L', 'W', 'R', 'L', 'D'};
constexpr std::size_t kHead = sizeof(kMagic) + 4 + 8, kTail = 8; // bytes round the payload

} // namespace

struct SavedState { // what is read before the world is touched
    Vec2 gravity;
    bool sleep_allowed = true;
    std::uint64_t steps = 0;
    double time = 0.0;
    Bodies bodies;
    Shapes shapes;
    Contacts contacts;
    Events events;
    Forces forces;
    Joints joints;
    Characters characters;
    SavedFluids fluids;
    std::vector<bool> body_taken, shape_taken, piece_taken, force_taken, joint_taken;
};

namespace {

// ---- the payload -------------------------------------------------------------------------------------------------

void write_payload(auto& ar, const World& w) {
    visit(ar, w.gravity, w.sleep_allowed, w.steps, w.time);
    visit(ar, w.bodies.next_serial, w.shapes.next_serial, w.forces.next_serial, w.joints.next_serial);
    write_bodies(ar, w);
    write_forces(ar, w);
    write_joints(ar, w);
    write_contacts(ar, w);
}

// Beside the State: what each object was made from, so that references know it again.
void visit_made(auto& ar, auto& table, auto&& taken) {
    for (std::uint32_t slot = 0; slot < table.rows.size(); ++slot)
        if (taken(slot)) ar.value(table.rows[slot].made);
}

void write_made(auto& ar, const World& w) {
    auto live = [](const Slots& slots) { return [&](std::uint32_t slot) { return slots.taken(slot); }; };
    visit_made(ar, w.bodies, live(w.bodies.slots));
    visit_made(ar, w.shapes, live(w.shapes.slots));
    visit_made(ar, w.forces, live(w.forces.slots));
    visit_made(ar, w.joints, live(w.joints.slots));
}

void read_made(Reader& ar, SavedState& s) {
    auto live = [](const std::vector<bool>& taken) { return [&](std::uint32_t slot) { return taken[slot]; }; };
    visit_made(ar, s.bodies, live(s.body_taken));
    visit_made(ar, s.shapes, live(s.shape_taken));
    visit_made(ar, s.forces, live(s.force_taken));
    visit_made(ar, s.joints, live(s.joint_taken));
}

void read_holes(Reader& ar, SavedState& s) {
    for (std::size_t n = ar.count(); n > 0 && ar.ok; --n) {
        std::uint32_t slot = 0;
        ar.value(slot);
        ar.ok = ar.ok && slot < s.shapes.holes.size() && s.shapes.holes[slot].empty();
        if (ar.ok) visit(ar, s.shapes.holes[slot]);
    }
}

void read_payload(Reader& ar, SavedState& s) {
    visit(ar, s.gravity, s.sleep_allowed, s.steps, s.time);
    visit(ar, s.bodies.next_serial, s.shapes.next_serial, s.forces.next_serial, s.joints.next_serial);
    read_table(
        ar, s.body_taken,
        [&](std::size_t n) { s.bodies.rows.resize(n), s.bodies.tags.resize(n), s.bodies.traits.resize(n); },
        [&](std::uint32_t slot) {
            visit(ar, s.bodies.rows[slot]);
            visit(ar, s.bodies.tags[slot]);
            visit(ar, s.bodies.traits[slot]);
        });
    read_table(
        ar, s.shape_taken,
        [&](std::size_t n) {
            s.shapes.rows.resize(n), s.shapes.corners.resize(n), s.shapes.parts.resize(n);
            s.shapes.holes.resize(n);
        },
        [&](std::uint32_t slot) {
            visit(ar, s.shapes.rows[slot]);
            visit(ar, s.shapes.corners[slot]);
            visit(ar, s.shapes.parts[slot]);
        });
    read_holes(ar, s);
    read_table(
        ar, s.piece_taken, [&](std::size_t n) { s.shapes.pieces.resize(n); },
        [&](std::uint32_t slot) { visit(ar, s.shapes.pieces[slot].shape, s.shapes.pieces[slot].next); });
    read_table(
        ar, s.force_taken, [&](std::size_t n) { s.forces.rows.resize(n), s.forces.areas.resize(n); },
        [&](std::uint32_t slot) {
            visit(ar, s.forces.rows[slot]);
            visit(ar, s.forces.areas[slot]);
        });
    read_table(
        ar, s.joint_taken, [&](std::size_t n) { s.joints.rows.resize(n); },
        [&](std::uint32_t slot) { visit(ar, s.joints.rows[slot]); });
    visit(ar, s.contacts.rows);
    visit(ar, s.events.hit_speed, s.events.lost);
    visit(ar, s.characters.rows);
    read_fluids(ar, s.fluids);
    if (ar.ok) read_made(ar, s); // else the tables are not as long as they say
    ar.ok = ar.ok && ar.at_end();
}

// ---- a snapshot is believed only when every index in it leads somewhere ------------------------------------------

bool taken(const std::vector<bool>& list, std::uint32_t slot) { return slot < list.size() && list[slot]; }

// Is the centre of mass where the body's place says, but for how that rounds?
bool lies_in_its_place(const Body& b) {
    const Vec2 away = b.centre - transform(b.pose, b.local_centre);
    auto close = [&](float far, float centre, float own) {
        return std::abs(far) <= 1e-3f * (1.0f + std::abs(centre) + std::abs(own));
    };
    return close(away.x, b.pose.p.x, length(b.local_centre)) && close(away.y, b.pose.p.y, length(b.local_centre));
}

bool bodies_hold_together(const SavedState& s) {
    for (std::uint32_t i = 0; i < s.body_taken.size(); ++i) {
        if (!s.body_taken[i]) continue;
        const Body& b = s.bodies.rows[i];
        if (b.kind > BodyKind::dynamic || b.serial >= s.bodies.next_serial || !lies_in_its_place(b)) return false;
        if ((b.first_shape == kNone) != (b.last_shape == kNone)) return false;
        std::size_t steps = 0;
        std::uint32_t last = kNone;
        for (std::uint32_t shape = b.first_shape; shape != kNone; shape = s.shapes.rows[shape].next) {
            if (!taken(s.shape_taken, shape) || s.shapes.rows[shape].body != i || ++steps > s.shape_taken.size())
                return false;
            last = shape;
        }
        if (last != b.last_shape) return false;
    }
    return true;
}

bool polygon_holds_together(const SavedState& s, std::uint32_t i) {
    std::size_t first = 0; // of a ring
    for (std::uint32_t hole : s.shapes.holes[i]) {
        if (hole < first + 3) return false;
        first = hole;
    }
    std::size_t corners = s.shapes.corners[i].size();
    if (corners < first + 3 || corners > kMaxCorners || s.shapes.parts[i].empty()) return false;
    for (const Part& part : s.shapes.parts[i]) {
        if (part.size() < 3 || part.size() > corners) return false;
        for (std::uint32_t corner : part)
            if (corner >= corners) return false;
    }
    return true;
}

bool line_holds_together(const SavedState& s, std::uint32_t i) {
    const Shape& shape = s.shapes.rows[i];
    std::size_t points = s.shapes.corners[i].size(), fewest = shape.closed ? 3 : 2;
    if (shape.kind == ShapeKind::line && points != 2) return false;
    return points >= fewest && points <= kMaxCorners && s.shapes.parts[i].empty();
}

bool corners_hold_together(const SavedState& s, std::uint32_t i) {
    const Shape& shape = s.shapes.rows[i];
    if (shape.kind != ShapeKind::polygon && !s.shapes.holes[i].empty()) return false;
    switch (shape.kind) {
    case ShapeKind::polygon:
        return polygon_holds_together(s, i);
    case ShapeKind::line:
    case ShapeKind::chain:
        return line_holds_together(s, i);
    case ShapeKind::circle:
    case ShapeKind::particle:
        break;
    }
    return s.shapes.parts[i].empty();
}

bool shapes_hold_together(const SavedState& s) {
    std::size_t pieces = 0;
    for (std::uint32_t i = 0; i < s.shape_taken.size(); ++i) {
        if (!s.shape_taken[i]) continue;
        const Shape& shape = s.shapes.rows[i];
        if (shape.kind > ShapeKind::chain || !taken(s.body_taken, shape.body)) return false;
        if (shape.serial >= s.shapes.next_serial) return false;
        if (!corners_hold_together(s, i)) return false;
        std::size_t wanted = piece_count(shape, s.shapes.corners[i], s.shapes.parts[i]), found = 0;
        for (std::uint32_t p = shape.first_piece; p != kNone; p = s.shapes.pieces[p].next)
            if (!taken(s.piece_taken, p) || s.shapes.pieces[p].shape != i || ++found > wanted) return false;
        if (found != wanted) return false;
        pieces += found;
    }
    return pieces == static_cast<std::size_t>(std::ranges::count(s.piece_taken, true));
}

bool forces_hold_together(const SavedState& s) {
    for (std::uint32_t i = 0; i < s.force_taken.size(); ++i) {
        if (!s.force_taken[i]) continue;
        const Force& f = s.forces.rows[i];
        if (f.kind > ForceKind::python || (f.target != kNone && !taken(s.body_taken, f.target))) return false;
        if (f.serial >= s.forces.next_serial) return false;
        for (const auto& part : s.forces.areas[i].parts)
            if (part.size() < 3) return false;
        for (std::uint32_t body : f.bodies)
            if (!taken(s.body_taken, body)) return false;
    }
    return true;
}

bool joints_hold_together(const SavedState& s) {
    for (std::uint32_t i = 0; i < s.joint_taken.size(); ++i) {
        if (!s.joint_taken[i]) continue;
        const Joint& j = s.joints.rows[i];
        if (j.kind > JointKind::pulley || j.serial >= s.joints.next_serial || j.body_a == j.body_b) return false;
        if (!taken(s.body_taken, j.body_a) || !taken(s.body_taken, j.body_b)) return false;
    }
    return true;
}

bool contacts_hold_together(const SavedState& s) {
    for (std::size_t i = 0; i < s.contacts.rows.size(); ++i) {
        const Contact& c = s.contacts.rows[i];
        bool rising =
            i == 0 || Pair{s.contacts.rows[i - 1].piece_a, s.contacts.rows[i - 1].piece_b} < Pair{c.piece_a, c.piece_b};
        if (!rising || c.count > 2 || c.passage > Passage::passing || !taken(s.piece_taken, c.piece_a) ||
            !taken(s.piece_taken, c.piece_b))
            return false;
    }
    return s.events.hit_speed >= 0.0f;
}

// What was not written: pieces' bodies, ranges and baked geometry.
void rebuild_pieces(SavedState& s) {
    for (std::uint32_t shape = 0; shape < s.shape_taken.size(); ++shape) {
        if (!s.shape_taken[shape]) continue;
        const Shape& row = s.shapes.rows[shape];
        std::size_t part = 0;
        for (std::uint32_t p = row.first_piece; p != kNone; p = s.shapes.pieces[p].next, ++part) {
            Piece& piece = s.shapes.pieces[p];
            piece.body = row.body;
            piece.sensor = row.traits.sensor;
            piece.first = static_cast<std::uint32_t>(s.shapes.points.size());
            piece.count = corner_count(row, s.shapes.parts[shape], part);
            std::uint32_t room = room_of(piece, row.kind);
            s.shapes.points.resize(s.shapes.points.size() + room);
            s.shapes.normals.resize(s.shapes.points.size());
            s.shapes.live_points += room;
        }
        bake(s.shapes, shape, s.bodies.rows[row.body].scale);
    }
}

// Farther than a world's edge and its largest shapes lead: a grid over what lies there could not number its cells.
bool within_reach(const SavedState& s) {
    auto near = [](float x, float y, float size) {
        constexpr float kFarthest = 1e12f; // metres
        return std::abs(x) <= kFarthest && std::abs(y) <= kFarthest && std::abs(size) <= kFarthest;
    };
    for (std::uint32_t i = 0; i < s.body_taken.size(); ++i) {
        const Body& b = s.bodies.rows[i];
        if (s.body_taken[i] && !(near(b.pose.p.x, b.pose.p.y, 0.0f) && near(b.centre.x, b.centre.y, 0.0f)))
            return false;
    }
    for (std::uint32_t i = 0; i < s.piece_taken.size(); ++i) {
        const Piece& piece = s.shapes.pieces[i];
        if (s.piece_taken[i] && !near(piece.centre.x, piece.centre.y, piece.reach)) return false;
    }
    return true;
}

// ---- references across a restore -----------------------------------------------------------------------------

// The same object: created as the same one in order, at the same step, from the same words.
template <class Rows> std::vector<bool> same_objects(const Slots& slots, const Rows& before, const Rows& after) {
    std::vector<bool> same(after.size(), false);
    for (std::uint32_t i = 0; i < after.size() && i < slots.size(); ++i)
        same[i] = slots.taken(i) && before[i].serial == after[i].serial && before[i].born == after[i].born &&
                  before[i].made == after[i].made;
    return same;
}

template <class Tag> Ref<Tag> current(const Slots& slots, Ref<Tag> ref, bool alive) {
    return {ref.slot, alive ? slots.generation(ref.slot) : 0};
}

} // namespace

void restore(World& w, SavedState& s) {
    auto restore_slots = [](Slots& slots, const std::vector<bool>& now, const std::vector<bool>& same, Slots& out) {
        out = slots;
        out.restore(now, same);
    };
    restore_slots(w.bodies.slots, s.body_taken, same_objects(w.bodies.slots, w.bodies.rows, s.bodies.rows),
                  s.bodies.slots);
    restore_slots(w.shapes.slots, s.shape_taken, same_objects(w.shapes.slots, w.shapes.rows, s.shapes.rows),
                  s.shapes.slots);
    restore_slots(w.forces.slots, s.force_taken, same_objects(w.forces.slots, w.forces.rows, s.forces.rows),
                  s.forces.slots);
    restore_slots(w.joints.slots, s.joint_taken, same_objects(w.joints.slots, w.joints.rows, s.joints.rows),
                  s.joints.slots);
    restore_slots(w.shapes.piece_slots, s.piece_taken, {}, s.shapes.piece_slots);
    s.bodies.rows.resize(s.bodies.slots.size());
    s.bodies.tags.resize(s.bodies.slots.size());
    s.bodies.traits.resize(s.bodies.slots.size());
    s.shapes.rows.resize(s.shapes.slots.size());
    s.shapes.corners.resize(s.shapes.slots.size());
    s.shapes.holes.resize(s.shapes.slots.size());
    s.shapes.parts.resize(s.shapes.slots.size());
    s.shapes.pieces.resize(s.shapes.piece_slots.size());
    s.forces.rows.resize(s.forces.slots.size());
    s.forces.areas.resize(s.forces.slots.size());
    s.joints.rows.resize(s.joints.slots.size());
    link_all(s.joints);
    for (Touch& t : s.events.lost) { // one of its two was destroyed, and its slot may be taken again
        bool a = taken(s.body_taken, t.a.slot) && s.bodies.rows[t.a.slot].serial == t.order[0];
        bool b = taken(s.body_taken, t.b.slot) && s.bodies.rows[t.b.slot].serial == t.order[1];
        bool sa = taken(s.shape_taken, t.shape_a.slot) && s.shapes.rows[t.shape_a.slot].serial == t.order[2];
        bool sb = taken(s.shape_taken, t.shape_b.slot) && s.shapes.rows[t.shape_b.slot].serial == t.order[3];
        t.a = current(s.bodies.slots, t.a, a);
        t.b = current(s.bodies.slots, t.b, b);
        t.shape_a = current(s.shapes.slots, t.shape_a, sa);
        t.shape_b = current(s.shapes.slots, t.shape_b, sb);
    }
    w.gravity = s.gravity;
    w.sleep_allowed = s.sleep_allowed;
    w.steps = s.steps;
    w.time = s.time;
    w.bodies = std::move(s.bodies);
    w.shapes = std::move(s.shapes);
    w.weighed = {};
    w.contacts = std::move(s.contacts);
    w.events = std::move(s.events);
    w.forces = std::move(s.forces);
    w.joints = std::move(s.joints);
    w.characters.rows = std::move(s.characters.rows);
    restore_fluids(w.fluids, s.fluids);

    std::size_t n = w.bodies.slots.size();
    w.present.assign(n, {});
    w.scales.assign(n, Vec2{1, 1});
    if (n > w.arrays->capacity) w.arrays = std::make_shared<Arrays>(std::max<std::size_t>(64, 2 * n));
    w.search.remade = true;
    publish_all(w);
    w.previous = w.present;
}

std::uint64_t checksum(const World& world) {
    HashWriter ar;
    write_payload(ar, world);
    if (!world.characters.rows.empty()) visit(ar, world.characters.rows); // a world without has the sum it always had
    if (world.fluids.any()) write_fluids(ar, world.fluids);
    return ar.sum();
}

std::size_t snapshot_size(const World& world) {
    Measure payload;
    write_payload(payload, world);
    visit(payload, world.characters.rows);
    write_fluids(payload, world.fluids);
    write_made(payload, world);
    return kHead + payload.size() + kTail;
}

void write_snapshot(const World& world, std::span<std::uint8_t> out) {
    std::span<std::uint8_t> payload = out.subspan(kHead, out.size() - kHead - kTail);
    SpanWriter head(out.first(kHead)), body(payload), tail(out.last(kTail));
    for (char c : kMagic) head.value(c);
    head.value(kSnapshotVersion);
    head.count(payload.size());
    write_payload(body, world);
    visit(body, world.characters.rows);
    write_fluids(body, world.fluids);
    write_made(body, world);
    assert(body.full());
    tail.value(hash(payload));
}

ReadSnapshot read_snapshot(std::span<const std::uint8_t> bytes) {
    std::size_t known = std::min(bytes.size(), sizeof(kMagic));
    if (known == 0 || std::memcmp(bytes.data(), kMagic, known) != 0) return {nullptr, SnapshotProblem::not_a_snapshot};
    if (bytes.size() < kHead + kTail) return {nullptr, SnapshotProblem::cut_short};
    Reader head(bytes.subspan(sizeof(kMagic), 12));
    std::uint32_t version = 0;
    std::uint64_t length = 0, written = 0;
    head.value(version);
    head.value(length);
    if (version != kSnapshotVersion) return {nullptr, SnapshotProblem::other_version};
    std::uint64_t there = bytes.size() - kHead - kTail;
    if (length != there) return {nullptr, length > there ? SnapshotProblem::cut_short : SnapshotProblem::damaged};
    std::span<const std::uint8_t> payload = bytes.subspan(kHead, length);
    Reader(bytes.last(kTail)).value(written);
    if (hash(payload) != written) return {nullptr, SnapshotProblem::damaged};

    auto state = std::make_shared<SavedState>();
    Reader ar(payload);
    read_payload(ar, *state);
    bool whole = ar.ok && shapes_hold_together(*state) && bodies_hold_together(*state) &&
                 forces_hold_together(*state) && joints_hold_together(*state) && contacts_hold_together(*state) &&
                 hold_together(state->characters, state->body_taken) && hold_together(state->fluids, state->body_taken);
    if (!whole) return {nullptr, SnapshotProblem::inconsistent};
    rebuild_pieces(*state);
    if (!within_reach(*state)) return {nullptr, SnapshotProblem::inconsistent};
    for (std::uint32_t body = 0; body < state->body_taken.size(); ++body)
        if (state->body_taken[body]) note_neighbours(state->shapes, state->bodies.rows[body]);
    for (Contact& c : state->contacts.rows) {
        c.body_a = state->shapes.rows[shape_a(c, state->shapes)].body;
        c.body_b = state->shapes.rows[shape_b(c, state->shapes)].body;
        c.fresh = false;
        mark(c, state->shapes);
    }
    return {state, SnapshotProblem::none};
}

std::vector<std::string> notes_of(const SavedState& saved) {
    std::vector<std::string> notes;
    for (std::uint32_t i = 0; i < saved.force_taken.size(); ++i)
        if (saved.force_taken[i] && saved.forces.rows[i].kind == ForceKind::python)
            notes.push_back(saved.forces.rows[i].note);
    return notes;
}

SavedSlots slots_of(const SavedState& saved) {
    auto numbers = [](const std::vector<bool>& taken) {
        std::vector<std::uint32_t> list;
        for (std::uint32_t i = 0; i < taken.size(); ++i)
            if (taken[i]) list.push_back(i);
        return list;
    };
    SavedSlots slots{numbers(saved.body_taken),         numbers(saved.shape_taken),
                     numbers(saved.force_taken),        numbers(saved.joint_taken),
                     numbers(saved.fluids.smoke_taken), numbers(saved.fluids.source_taken),
                     numbers(saved.fluids.water_taken), numbers(saved.fluids.stream_taken),
                     liquids_of(saved.fluids),          {}};
    for (std::uint32_t shape : slots.shapes) slots.shape_bodies.push_back(saved.shapes.rows[shape].body);
    return slots;
}

} // namespace evil
