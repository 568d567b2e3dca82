#include "draw/debug_lights.hpp"
#include "draw/scene.hpp"
#include <algorithm>
#include <cmath>

namespace evil::draw {
namespace {

using light::Caster;
using light::Light;

// All in logical points.
constexpr float kLine = 1.5f, kThin = 1.0f, kMiddle = 2.5f;
constexpr float kSunArrow = 40.0f, kSunAside = 18.0f;
constexpr float kEdge = 4000.0f; // how long the edges of a sun's shadows are

struct Source {        // a light in pixels
    Vec2 at, way;      // a sun has no place
    float size, reach; // of a sun: a pixel away
    bool sun;
};

Source source_of(const LightFrame& f, const Light& light) {
    Pose pose;
    if (light.body.slot != kNone)
        pose = between(f.world.previous[light.body.slot], f.world.present[light.body.slot], f.alpha);
    const Rot turn = rotation(light.angle);
    const float scale = std::sqrt(std::fabs(determinant(f.view)));
    const bool sun = light.reach == light::Reach::parallel;
    return {apply(f.view, transform(pose, light.at)),
            normalised(apply_linear(f.view, rotate(pose.q, {turn.c, turn.s}))), sun ? light.size : light.size * scale,
            sun ? kEdge * f.points : light.radius * scale, sun};
}

void draw_source(const LightFrame& f, const Light& light, const Source& source, Vec2 middle) {
    const float line_width = kLine * f.points, thin = kThin * f.points;
    if (source.sun) {
        const Vec2 half = 0.5f * kSunArrow * f.points * source.way, aside = kSunAside * f.points * left_of(source.way);
        for (const float side : {-1.0f, 0.0f, 1.0f})
            arrow(f.overlay, middle - half + side * aside, middle + half + side * aside, line_width, f.inks.lamp);
        return;
    }
    disc(f.overlay, source.at, kMiddle * f.points, f.inks.lamp);
    ring(f.overlay, source.at, source.size, line_width, f.inks.lamp);
    ring(f.overlay, source.at, source.reach, thin, f.inks.lamp);
    if (light.reach != light::Reach::cone) return;
    for (const float side : {-0.5f, 0.5f})
        for (const float part : {1.0f, 1.0f - light.edge}) { // to where it has faded, and to where it is whole
            const Vec2 along = source.reach * rotate(rotation(side * part * light.cone), source.way);
            line(f.overlay, source.at, source.at + along, part < 1.0f ? thin : line_width, f.inks.lamp);
        }
}

struct Tangent {
    Vec2 from, along; // of length 1; `from` is on the caster
};

// From a point past a convex caster, on its left (1) or right (-1) as seen from there.
Tangent tangent(const light::Casters& casters, const Caster& caster, Vec2 eye, float side) {
    if (caster.count == 0) {
        const Vec2 to = caster.middle - eye;
        const float away = std::max(length(to), caster.radius * 1.0001f), sine = caster.radius / away;
        const float cosine = std::sqrt(1.0f - sine * sine);
        const Vec2 ahead = (1.0f / away) * to, along = cosine * ahead + side * sine * left_of(ahead);
        return {eye + away * cosine * along, along};
    }
    Vec2 best = casters.corners[caster.first];
    for (std::uint32_t i = 1; i < caster.count; ++i) {
        const Vec2 corner = casters.corners[caster.first + i];
        if (side * cross(best - eye, corner - eye) > 0.0f) best = corner;
    }
    return {best, normalised(best - eye)};
}

// How far along a line it meets another one; kEdge where it does not.
float meeting(const Tangent& one, const Tangent& other) {
    const float turn = cross(one.along, other.along);
    if (std::fabs(turn) < 1e-6f) return kEdge;
    const float at = cross(other.from - one.from, other.along) / turn;
    return at > 0.0f ? at : kEdge;
}

// Full shadow lies between tangents on the same sides of both, half shadow reaches out to those that cross over:
//
//      lamp         caster
//      ( )----------|  |-------- umbra, which ends where its two edges meet
//         `.        |  |   ....- penumbra
void draw_shadow(const LightFrame& f, const Source& source, const light::Casters& casters, const Caster& caster) {
    const Vec2 lamp = source.sun ? caster.middle - kEdge * f.points * source.way : source.at;
    const Vec2 aside =
        (source.sun ? source.size * kEdge * f.points : source.size) * left_of(normalised(caster.middle - lamp));
    const auto rest = [&](const Tangent& edge) {
        return source.sun ? source.reach : std::max(source.reach - length(edge.from - lamp), 0.0f);
    };
    const Tangent left = tangent(casters, caster, lamp + aside, 1.0f),
                  right = tangent(casters, caster, lamp - aside, -1.0f);
    const float apex = meeting(left, right);
    for (const Tangent& edge : {left, right})
        line(f.overlay, edge.from, edge.from + std::min(apex, rest(edge)) * edge.along, kThin * f.points, f.inks.umbra);
    for (const float side : {1.0f, -1.0f}) {
        const Tangent edge = tangent(casters, caster, lamp - side * aside, side);
        line(f.overlay, edge.from, edge.from + rest(edge) * edge.along, kThin * f.points, f.inks.penumbra);
    }
}

} // namespace

int draw_lights(const LightFrame& f, const light::Lights& lights, light::Casters& casters) {
    int count = 0;
    gather(casters, f.world, f.view, f.alpha);
    for (std::uint32_t slot = 0; slot < lights.rows.size(); ++slot) {
        const Light& light = lights.rows[slot];
        const bool bodiless = light.body.slot == kNone || f.world.bodies.slots.alive(light.body);
        if (!lights.slots.taken(slot) || !light.on || !bodiless) continue;
        const Source source = source_of(f, light);
        for (const Caster& caster : casters.rows) {
            const bool away = source.sun || length(caster.middle - source.at) < source.reach + caster.radius;
            const bool outside = source.sun || length(caster.middle - source.at) > caster.radius;
            if (light.shadows && away && outside && (caster.category & light.mask) && caster.body != light.body.slot)
                draw_shadow(f, source, casters, caster);
        }
        const float place = 60.0f * f.points * static_cast<float>(1 + count);
        draw_source(f, light, source, {place, 60.0f * f.points});
        ++count;
    }
    return count;
}

} // namespace evil::draw
