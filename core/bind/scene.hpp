#pragma once
// What Python holds of a scene; one file a subject fills it.
#include "bind/convert.hpp"
#include "draw/overlay.hpp"
#include "draw/scene.hpp"
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

namespace evil::bind {

struct SceneBox { // what Python holds
    draw::Scene scene;
    std::vector<std::shared_ptr<draw::DrawList>> lists{std::make_shared<draw::DrawList>()};
    std::shared_ptr<draw::DrawList> list = lists[0]; // the one that is filled
    std::optional<draw::Overlay> overlay;            // of the frame being collected
    std::vector<draw::Glyph> glyphs;                 // scratch
};

inline draw::Drawing& drawing_at(SceneBox& box, std::uint32_t slot, std::uint32_t generation) {
    if (!box.scene.slots.alive(draw::DrawingRef{slot, generation}))
        raise(ErrorKind::stale_reference, "this Drawing was destroyed; ask drawing.alive first");
    return box.scene.drawings[slot];
}

void bind_surfaces(nb::class_<SceneBox>& c);

using Matrix6 = std::tuple<float, float, float, float, float, float>; // a b c d tx ty

inline Affine to_affine(const Matrix6& matrix) {
    const auto& [a, b, c, d, tx, ty] = matrix;
    return {a, b, c, d, tx, ty};
}

inline float part_of_step(double alpha) {
    return std::isfinite(alpha) ? static_cast<float>(std::clamp(alpha, 0.0, 1.0)) : 1.0f;
}

inline const draw::Overlay& overlay_of(const SceneBox& box) {
    if (!box.overlay) raise(ErrorKind::argument, "Scene: collect() comes before what lies on top of it");
    return *box.overlay;
}

void register_frame(nb::class_<SceneBox>& scene); // bind/frame.cpp

} // namespace evil::bind
