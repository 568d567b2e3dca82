#pragma once
// What lies on top of the world, in pixels: lines, arrows, discs, boxes and rows of glyphs. All are instances of three
// unit meshes, so nothing is built per frame.
#include "draw/draw_list.hpp"
#include <span>

namespace evil::draw {

struct Overlay {
    DrawList& list;
    std::uint32_t square;   // corners (0,0) to (1,1), texture coordinates the same
    std::uint32_t triangle; // point at the origin, base from (1,-1) to (1,1)
    std::uint32_t disc;     // radius 1 round the origin
};

// Adds the meshes behind those that `list` has.
Overlay begin_overlay(DrawList& list);

void line(const Overlay& overlay, Vec2 from, Vec2 to, float width, Rgba8 colour);
void arrow(const Overlay& overlay, Vec2 from, Vec2 to, float width, Rgba8 colour); // its point is at `to`
void disc(const Overlay& overlay, Vec2 centre, float radius, Rgba8 colour);
void ring(const Overlay& overlay, Vec2 centre, float radius, float width, Rgba8 colour);
void coil(const Overlay& overlay, Vec2 from, Vec2 to, float half, float width, Rgba8 colour); // a spring
void box(const Overlay& overlay, Vec2 low, Vec2 high, Rgba8 colour);

struct Glyph { // where it is on the picture, in pixels, and where in its texture, 0..1
    Vec2 low, high;
    Vec2 texture_low, texture_high;
};
void glyphs(const Overlay& overlay, std::span<const Glyph> row, Vec2 at, std::uint32_t texture, Rgba8 colour);

} // namespace evil::draw
