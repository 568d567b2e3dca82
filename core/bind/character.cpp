// Characters for Python: what one can do, what it is told to do, and how it is.
#include "bind/handle.hpp"

namespace evil::bind {
namespace {

constexpr const char* kOwner = "Character";

struct CharacterHandle { // a character is known by its body
    BodyHandle body;
};

Door* door_of(const CharacterHandle& h) { return door_of(h.body); }

Character& row(const CharacterHandle& h) {
    require_alive(h.body);
    Character* c = character_of(h.body.world->characters, h.body.ref.slot);
    if (!c) raise(ErrorKind::argument, "Character: this body is no character; world.add_character makes one");
    return *c;
}

template <auto Field>
void bind_ability(nb::class_<CharacterHandle>& c, const char* name, float least, float most, const char* doc) {
    def_value(
        c, name, kNumber, [](const CharacterHandle& h) { return row(h).abilities.*Field; },
        [name, least, most](const CharacterHandle& h, nb::handle value) {
            float number = in_range(value, kOwner, name, least, most);
            row(h).abilities.*Field = number;
        },
        doc);
}

void bind_abilities(nb::class_<CharacterHandle>& c) {
    using A = Abilities;
    bind_ability<&A::speed>(c, "speed", 0, 1e4f, "Metres a second that it walks.");
    bind_ability<&A::acceleration>(c, "acceleration", 0, 1e6f, "m/s2 on the ground, until it walks as fast as it can.");
    bind_ability<&A::deceleration>(c, "deceleration", 0, 1e6f, "m/s2 on the ground, when it stops or turns.");
    bind_ability<&A::air_acceleration>(c, "air_acceleration", 0, 1e6f,
                                       "m/s2 in the air, towards where it wants to go.");
    bind_ability<&A::air_deceleration>(c, "air_deceleration", 0, 1e6f, "m/s2 in the air, when it wants nothing.");
    bind_ability<&A::jump_height>(c, "jump_height", 0, 1e4f,
                                  "Metres that a jump goes up when it is held; 0: it cannot jump.");
    bind_ability<&A::jump_cut>(c, "jump_cut", 0, 1,
                               "Share of the upward speed that is left when a jump is let go early.");
    bind_ability<&A::coyote_time>(c, "coyote_time", 0, 10,
                                  "Seconds after it walked off an edge in which it still can jump.");
    bind_ability<&A::jump_buffer>(c, "jump_buffer", 0, 10, "Seconds before it lands in which a jump is remembered.");
    bind_ability<&A::gravity_scale>(c, "gravity_scale", 0, 1e4f, "Times the world's gravity.");
    bind_ability<&A::fall_speed>(c, "fall_speed", 0, 1e4f, "Metres a second that it falls at most.");
    bind_ability<&A::max_slope>(c, "max_slope", 0, 1.57f, "Radians: the steepest slope that it walks on.");
    bind_ability<&A::step_height>(c, "step_height", 0, 1e4f, "Metres: how high a step it walks onto, and down from.");
    bind_ability<&A::climb_speed>(c, "climb_speed", 0, 1e4f, "Metres a second on ladders.");
    bind_ability<&A::push_force>(c, "push_force", 0, 1e9f, "Newtons at most on what stands in its way.");
    bind_ability<&A::mass>(c, "mass", 1e-6f, 1e9f, "Kilograms, where it meets what is not fixed.");
    def_value(
        c, "air_jumps", "int", [](const CharacterHandle& h) { return row(h).abilities.air_jumps; },
        [](const CharacterHandle& h, nb::handle value) {
            float wanted = in_range(value, kOwner, "air_jumps", 0, 1000);
            if (wanted != std::floor(wanted)) raise(ErrorKind::argument, "Character: air_jumps must be a whole number");
            row(h).abilities.air_jumps = static_cast<std::uint32_t>(wanted);
        },
        "How often it can jump again in the air.");
}

void bind_wishes(nb::class_<CharacterHandle>& c) {
    c.def(
        "_move",
        [](const CharacterHandle& h, nb::handle axis) {
            float wanted = in_range(axis, "Character.move", "axis", -1, 1);
            row(h).wish.move = wanted;
        },
        nb::arg("axis").none());
    c.def(
        "_climb",
        [](const CharacterHandle& h, nb::handle axis) {
            float wanted = in_range(axis, "Character.climb", "axis", -1, 1);
            row(h).wish.climb = wanted;
        },
        nb::arg("axis").none());
    c.def("_jump", [](const CharacterHandle& h) {
        Character& it = row(h);
        it.wish.jump = true;
        it.jump_wanted = std::max(it.abilities.jump_buffer, 1e-6f); // at least until the next step
    });
    c.def("_let_go", [](const CharacterHandle& h) { row(h).wish.jump = false; });
    c.def("_drop", [](const CharacterHandle& h) { row(h).dropping = 0.25f; });
    c.def_prop_ro("_wish", [](const CharacterHandle& h) {
        const Wish& w = row(h).wish;
        return nb::borrow<Anything>(nb::make_tuple(w.move, w.climb, w.jump));
    });
    c.def("_add_ladder", [](const CharacterHandle& h, float left, float bottom, float right, float top) {
        row(h).ladders.push_back({{left, bottom}, {right, top}});
    });
    c.def("_clear_ladders", [](const CharacterHandle& h) { row(h).ladders.clear(); });
    c.def_prop_ro("_ladders", [](const CharacterHandle& h) {
        nb::list list;
        for (const Ladder& l : row(h).ladders) list.append(nb::make_tuple(l.low.x, l.low.y, l.high.x, l.high.y));
        return nb::borrow<Anything>(nb::tuple(list));
    });
}

void bind_state(nb::class_<CharacterHandle>& c) {
    c.def_prop_ro(
        "alive",
        [](const CharacterHandle& h) {
            return alive(h.body) && character_of(h.body.world->characters, h.body.ref.slot) != nullptr;
        },
        "False once its body was destroyed.");
    c.def_prop_ro("grounded", [](const CharacterHandle& h) { return row(h).grounded; }, "Does it stand on something?");
    c.def_prop_ro("climbing", [](const CharacterHandle& h) { return row(h).climbing; }, "Does it hold on to a ladder?");
    c.def_prop_ro(
        "crushed", [](const CharacterHandle& h) { return row(h).crushed; },
        "Is it pressed into something that does not give way?");
    c.def_prop_ro("_ground", [](const CharacterHandle& h) { return row(h).ground; });
    c.def_prop_ro(
        "ground_normal",
        [](const CharacterHandle& h) {
            const Character& it = row(h);
            return from_vec2(it.grounded ? it.ground_normal : Vec2{});
        },
        "Direction of length 1 out of what it stands on; (0, 0) in the air.");
    def_value(
        c, "velocity", kPoint,
        [](const CharacterHandle& h) {
            const Character& it = row(h);
            return from_vec2(it.velocity + it.ground_velocity);
        },
        [](const CharacterHandle& h, nb::handle value) {
            Vec2 v = to_vec2(value, kOwner, "velocity");
            if (std::abs(v.x) > kMaxSpeed || std::abs(v.y) > kMaxSpeed)
                raise(ErrorKind::argument, "Character: velocity must be at most 1e5 m/s along each axis");
            launch(row(h), v);
        },
        "Metres a second in the world. Set it to throw the character: what leads off the ground lifts it.");
    c.def_prop_ro("_told", [](const CharacterHandle& h) {
        const Character& it = row(h);
        return nb::borrow<Anything>(nb::make_tuple(it.landing, it.jumped, it.begins_crush));
    });
}

} // namespace

void register_character(nb::module_& module) {
    nb::class_<CharacterHandle> c(module, "Character", "A handle of a character: its body's slot and generation.");
    c.def("__init__",
          [](CharacterHandle* self, std::shared_ptr<World> world, std::uint32_t slot, std::uint32_t generation) {
              new (self) CharacterHandle;
              self->body.ref = {slot, generation};
              self->body.world = std::move(world);
          });
    bind_abilities(c);
    bind_wishes(c);
    bind_state(c);
    module.def("add_character", [](World& w, std::uint32_t body) { add_character(w, body, {}); });
    module.def(
        "characters",
        [](const World& w) {
            std::vector<std::uint32_t> slots;
            for (const Character& it : w.characters.rows) slots.push_back(it.body);
            return slots;
        },
        "The bodies of all characters, in the order in which they were made.");
}

} // namespace evil::bind
