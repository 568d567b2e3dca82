#include "light/soak.hpp"
#include "light/soak_wide.hpp"
#include <algorithm>

namespace evil::light {
namespace {

constexpr int kAtOnce = 4; // rows whose windows move together, so that no sum waits for another

constexpr int kNumbers = 4; // in a Soft
static_assert(sizeof(Soft) == kNumbers * sizeof(float), "rows of them are rows of floats");

void add(Soft& sum, const Soft& one, float sign) {
    sum.red += sign * one.red, sum.green += sign * one.green;
    sum.blue += sign * one.blue, sum.air += sign * one.air;
}

Soft scaled(const Soft& one, float by) { return {one.red * by, one.green * by, one.blue * by, one.air * by}; }

float share_of(int half) { return 1.0f / static_cast<float>(2 * half + 1); }

// The means over windows of `half` texels to either side, which move along rows; beyond their ends, the end goes on.
void blur_rows(const Soft* from, Soft* to, int width, int half) {
    Soft sums[kAtOnce]{};
    for (int r = 0; r < kAtOnce; ++r)
        for (int i = -half; i <= half; ++i) add(sums[r], from[r * width + std::clamp(i, 0, width - 1)], 1.0f);
    const float share = share_of(half);
    for (int i = 0; i < width; ++i) {
        const int enters = std::min(i + half + 1, width - 1), leaves = std::max(i - half, 0);
        for (int r = 0; r < kAtOnce; ++r) {
            const Soft* row = from + r * width;
            to[r * width + i] = scaled(sums[r], share);
            add(sums[r], row[enters], 1.0f);
            add(sums[r], row[leaves], -1.0f);
        }
    }
}

// Means over squares: a row at a time, from the top. `put(y, row)` gives the rows that they are taken of, each once.
template <class Put> class Means {
public:
    Means(Spread& spread, int width, int height, int half, InstructionSet set, Put put)
        : spread_(spread), width_(width), height_(height), half_(half), set_(set), put_(put),
          kept_((2 * half + 2 + 2 * kAtOnce - 1) / kAtOnce * kAtOnce) {
        const auto columns = static_cast<std::size_t>(width);
        spread.rows.resize(kept_ * columns);
        spread.fresh.resize(kAtOnce * columns);
        spread.sums.assign(columns, Soft{});
    }
    void next(Soft* out) {
        Soft* sums = spread_.sums.data();
        for (int y = -half_; y_ == 0 && y <= half_; ++y) {
            const Soft* row = row_of(y);
            for (int x = 0; x < width_; ++x) add(sums[x], row[x], 1.0f);
        }
        const Soft *enters = row_of(y_ + half_ + 1), *leaves = row_of(y_ - half_);
        EVIL_PICK(set_, move_windows_wide)
        (&out->red, &sums->red, &enters->red, &leaves->red, share_of(half_), kNumbers * width_);
        ++y_;
    }

private:
    Soft* place_of(int y) { return spread_.rows.data() + static_cast<std::size_t>(y % kept_) * width_; }
    const Soft* row_of(int y) { // its means; beyond the ends, the end goes on
        y = std::clamp(y, 0, height_ - 1);
        for (; made_ <= y; made_ += kAtOnce) {
            for (int r = 0; r < std::min(kAtOnce, height_ - made_); ++r)
                put_(made_ + r, spread_.fresh.data() + static_cast<std::size_t>(r) * width_);
            blur_rows(spread_.fresh.data(), place_of(made_), width_, half_);
        }
        return place_of(y);
    }

    Spread& spread_;
    int width_, height_, half_;
    InstructionSet set_;
    Put put_;
    int kept_;
    int made_ = 0; // rows that were put
    int y_ = 0;    // the next one
};

} // namespace

void add_soaked(float* const to[3], const float* const from[3], std::span<const std::uint8_t> solid, int width,
                int height, int reach, InstructionSet set, SoakScratch& scratch) {
    const int half = std::max(1, (reach + 1) / 2); // two passes reach twice as far, and fade as a parabola does
    Means once(scratch.first, width, height, half, set, [&](int y, Soft* row) {
        const auto at = static_cast<std::size_t>(y) * width;
        for (int x = 0; x < width; ++x) {
            const float air = solid[at + x] ? 0.0f : 1.0f;
            row[x] = {air * from[0][at + x], air * from[1][at + x], air * from[2][at + x], air};
        }
    });
    Means twice(scratch.second, width, height, half, set, [&](int, Soft* row) { once.next(row); });
    scratch.row.resize(static_cast<std::size_t>(width));
    for (int y = 0; y < height; ++y) {
        twice.next(scratch.row.data());
        const auto at = static_cast<std::size_t>(y) * width;
        for (int x = 0; x < width; ++x) {
            Soft light{from[0][at + x], from[1][at + x], from[2][at + x], 1.0f};
            if (solid[at + x]) light = scaled(scratch.row[x], 1.0f / std::max(scratch.row[x].air, 0.5f));
            to[0][at + x] += light.red;
            to[1][at + x] += light.green;
            to[2][at + x] += light.blue;
        }
    }
}

} // namespace evil::light
