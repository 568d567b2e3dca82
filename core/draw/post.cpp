#include "draw/post.hpp"
#include "math/functions.hpp"
#include <algorithm>

namespace evil::draw {
namespace {

double to_linear(double s) { return s <= 0.04045 ? s / 12.92 : power((s + 0.055) / 1.055, 2.4); }
double to_srgb(double l) { return l <= 0.0031308 ? 12.92 * l : 1.055 * power(l, 1.0 / 2.4) - 0.055; }
double filmic(double x) { return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14); }

} // namespace

void grade(Post& post, const Grading& grading) {
    post.grading = grading, post.graded = true;
    for (int i = 0; i < kTones; ++i) {
        const double light = to_linear(i / 255.0) * grading.exposure;
        for (int channel = 0; channel < 3; ++channel) {
            const double tinted = light * grading.tint[channel];
            const double bent = std::clamp(grading.filmic ? filmic(tinted) : tinted, 0.0, 1.0);
            const double shown = 0.5 + (to_srgb(bent) - 0.5) * grading.contrast;
            post.table[static_cast<std::size_t>(4 * i + channel)] =
                static_cast<float>(255.0 * std::clamp(shown, 0.0, 1.0));
        }
    }
}

} // namespace evil::draw
