#include "fluid/looks.hpp"
#include <algorithm>
#include <cmath>

namespace evil::fluid {
namespace {

// The ramp's entry for a value. 1 - exp(-x) without exp: to the cubic term, which no eye tells from it.
std::size_t entry(const Ramp& ramp, float value) {
    const float x = std::clamp(value * ramp.scale, 0.0f, 50.0f);
    const float shown = 1.0f - 1.0f / (1.0f + x * (1.0f + x * (0.5f + x * (1.0f / 6.0f))));
    return static_cast<std::size_t>(shown * static_cast<float>(kRamp - 1) + 0.5f);
}

template <class Paint> void each_pixel(const Smoke& smoke, std::span<std::uint32_t> pixels, Paint paint) {
    const auto nx = static_cast<std::size_t>(smoke.grid.nx), ny = static_cast<std::size_t>(smoke.grid.ny);
    for (std::size_t j = 0; j < ny; ++j)
        for (std::size_t i = 0; i < nx; ++i) pixels[(ny - 1 - j) * nx + i] = paint(j * nx + i);
}

std::uint32_t tinted(std::uint32_t colour, const float* cell, float density, const Colour& own) {
    const float parts[3] = {own.r, own.g, own.b};
    std::uint32_t result = colour & 0xff000000u;
    for (std::uint32_t k = 0; k < 3; ++k) {
        const float here = cell[k] / std::max(density, 1e-6f), by = here / std::max(parts[k], 0.02f);
        const float shown = std::clamp(static_cast<float>(colour >> (8 * k) & 255u) * by, 0.0f, 255.0f);
        result |= static_cast<std::uint32_t>(shown + 0.5f) << (8 * k);
    }
    return result;
}

} // namespace

void paint_density(const Smoke& smoke, const Ramp& ramp, std::span<std::uint32_t> pixels) {
    const Views& views = *smoke.views;
    each_pixel(smoke, pixels, [&](std::size_t at) {
        const float density = views.content[at].density;
        const std::uint32_t colour = ramp.colours[entry(ramp, density)];
        if (views.colour.empty() || (colour & 0xff000000u) == 0u) return colour;
        return tinted(colour, &views.colour[4 * at], density, smoke.colour);
    });
}

void paint_heat(const Smoke& smoke, const Ramp& ramp, std::span<std::uint32_t> pixels) {
    each_pixel(smoke, pixels,
               [&](std::size_t at) { return ramp.colours[entry(ramp, smoke.views->content[at].temperature)]; });
}

Blaze blaze(const Smoke& smoke, float above) {
    const Grid& g = smoke.grid;
    double sum = 0.0, x = 0.0, y = 0.0, square = 0.0;
    const Cell* cell = smoke.views->content.data();
    for (int j = 0; j < g.ny; ++j)
        for (int i = 0; i < g.nx; ++i, ++cell) {
            const double heat = double(cell->temperature) - double(above);
            if (!(heat > 0.0)) continue;
            sum += heat, x += heat * i, y += heat * j, square += heat * (double(i) * i + double(j) * j);
        }
    if (sum == 0.0) return {};
    x /= sum, y /= sum;
    const double spread = std::sqrt(std::max(square / sum - x * x - y * y, 0.0));
    return {static_cast<float>(sum * double(g.h) * double(g.h)),
            g.low + g.h * Vec2{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f},
            static_cast<float>(spread) * g.h};
}

} // namespace evil::fluid
