#include "draw/layers.hpp"
#include <algorithm>

namespace evil::draw {

std::uint32_t end_of_layer(const DrawList& list, std::int32_t layer) {
    for (const LayerStart& start : list.layers)
        if (start.layer > layer) return start.first;
    return static_cast<std::uint32_t>(list.instances.size());
}

void move_to_layer(DrawList& list, std::uint32_t first, std::int32_t layer) {
    const std::uint32_t place = std::min(end_of_layer(list, layer), first);
    const auto count = static_cast<std::uint32_t>(list.instances.size()) - first;
    std::rotate(list.instances.begin() + place, list.instances.begin() + first, list.instances.end());
    for (LayerStart& start : list.layers)
        if (start.layer > layer) start.first += count;
}

void add_fog(DrawList& list, std::int32_t layer, Rgba8 top, Rgba8 bottom, Vec2 screen, bool lit) {
    const Vertex corners[] = {
        {{0, 0}, {0, 0}, top}, {{1, 0}, {1, 0}, top}, {{1, 1}, {1, 1}, bottom}, {{0, 1}, {0, 1}, bottom}};
    constexpr std::uint32_t kTriangles[] = {0, 1, 2, 0, 2, 3};
    const std::uint32_t mesh = add_polygon(list, corners, kTriangles);
    const auto first = static_cast<std::uint32_t>(list.instances.size());
    list.instances.push_back(
        {{screen.x, 0, 0, screen.y, 0, 0}, {}, mesh, kNoTexture, 0xffffffffu, 0.0f, Blend::over, lit});
    move_to_layer(list, first, layer);
}

void add_shafts(DrawList& list, std::int32_t layer, const Shafts& shafts) {
    Interlude row;
    row.before = end_of_layer(list, layer);
    row.kind = InterludeKind::shafts;
    row.first = static_cast<std::uint32_t>(list.interludes.shafts.size());
    list.interludes.shafts.push_back(shafts);
    list.interludes.rows.push_back(row);
}

LiquidMap& add_liquid(DrawList& list, std::int32_t layer) {
    draw::Interludes& all = list.interludes;
    Interlude row;
    row.before = end_of_layer(list, layer);
    row.kind = InterludeKind::liquid;
    row.first = all.liquid_count++;
    all.rows.push_back(row);
    if (all.liquids.size() < all.liquid_count) all.liquids.emplace_back();
    return all.liquids[row.first];
}

void drop_liquid(DrawList& list) {
    list.interludes.rows.pop_back();
    --list.interludes.liquid_count;
}

void add_blur(DrawList& list, std::int32_t layer, float radius) {
    Interlude blur;
    blur.before = end_of_layer(list, layer);
    blur.kind = InterludeKind::blur;
    blur.radius = radius;
    list.interludes.rows.push_back(blur);
}

} // namespace evil::draw
