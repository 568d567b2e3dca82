#include "fluid/smoke.hpp"
#include "fluid/rows.hpp"
#include "fluid/scratch.hpp"
#include "fluid/water/pouring.hpp"

namespace evil {

Fluids::Fluids() = default;
Fluids::~Fluids() = default;

void drop_sources_of(World& world, std::uint32_t body) {
    Fluids& all = world.fluids;
    for (std::uint32_t i = 0; i < all.source_slots.size(); ++i)
        if (all.source_slots.taken(i) && all.sources[i].body == body) fluid::destroy_source(world, i);
    for (std::uint32_t i = 0; i < all.stream_slots.size(); ++i)
        if (all.stream_slots.taken(i) && all.streams[i].body == body) fluid::destroy_stream(world, i);
}

namespace fluid {

Smoke::Smoke() = default;
Smoke::~Smoke() = default;

std::unique_ptr<Smoke> make_smoke(const Grid& grid, Method method) {
    auto smoke = std::make_unique<Smoke>();
    smoke->grid = grid;
    smoke->method = method;
    smoke->views = std::make_shared<Views>(grid.cells());
    smoke->scratch = std::make_unique<Scratch>();
    if (method == Method::stam) return smoke;
    for (Field* field : {&smoke->u, &smoke->v, &smoke->pressure, &smoke->half_pressure}) field->lay_out(grid);
    return smoke;
}

SmokeRef add_smoke(World& world, std::unique_ptr<Smoke> smoke) {
    Fluids& all = world.fluids;
    const std::uint32_t slot = add_row(world, all.smoke_slots, all.smokes, std::move(smoke));
    return {slot, all.smoke_slots.generation(slot)};
}

void destroy_smoke(World& world, std::uint32_t smoke) {
    Fluids& all = world.fluids;
    for (std::uint32_t i = 0; i < all.source_slots.size(); ++i)
        if (all.source_slots.taken(i) && all.sources[i].smoke == smoke) destroy_source(world, i);
    all.smokes[smoke].reset();
    all.smoke_slots.release(smoke);
}

SourceRef add_source(World& world, Source source) {
    Fluids& all = world.fluids;
    Smoke& smoke = *all.smokes[source.smoke];
    const bool plain = source.colour == smoke.colour || source.rate < 0.0f;
    const std::uint32_t slot = add_row(world, all.source_slots, all.sources, std::move(source));
    if (!plain) paint(smoke);
    return {slot, all.source_slots.generation(slot)};
}

void destroy_source(World& world, std::uint32_t source) {
    world.fluids.sources[source] = {};
    world.fluids.source_slots.release(source);
}

void paint(Smoke& smoke) {
    Views& views = *smoke.views;
    if (!views.colour.empty()) return;
    views.colour.resize(4 * views.content.size());
    for (std::size_t i = 0; i < views.content.size(); ++i) {
        const float density = views.content[i].density;
        views.colour[4 * i] = density * smoke.colour.r;
        views.colour[4 * i + 1] = density * smoke.colour.g;
        views.colour[4 * i + 2] = density * smoke.colour.b;
        views.colour[4 * i + 3] = views.content[i].open;
    }
}

} // namespace fluid
} // namespace evil
