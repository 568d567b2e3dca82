#pragma once
// A picture cut into bands of whole rows, which threads take one by one (sorted before they are drawn, and by strips:
// Molnar, Cox, Ellsworth and Fuchs 1994, "A Sorting Classification of Parallel Rendering").
//
// What becomes of a pixel follows from its place and from what was done before, never from where a band ends. So any number
// of bands and of threads gives the same bits.
#include "threads.hpp"
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace evil::raster {

struct Rows { // of a picture; none if last <= first
    int first = 0, last = 0;
};

struct Bands {
    Threads& threads;
    int most = 1;  // how many a picture is cut into at most
    int least = 0; // pixels that are worth a band: with fewer, handing it out costs more than it saves
};

// How many rows each band of a picture has; its last one may have fewer.
inline int side_of(const Bands& bands, int width, int height) {
    const int even = (height + bands.most - 1) / bands.most, worth = (bands.least + width - 1) / width;
    return std::clamp(std::max(even, worth), 1, std::max(height, 1));
}

// work(rows, band): `band` is below `most`, and no other thread's at that time. What it keeps to work with is found by that.
template <class Work> void each_band(const Bands& bands, int width, int height, Work&& work) {
    const auto side = static_cast<std::size_t>(side_of(bands, width, height));
    parallel_for(bands.threads, static_cast<std::size_t>(height), side, [&](std::size_t first, std::size_t last) {
        work(Rows{static_cast<int>(first), static_cast<int>(last)}, first / side);
    });
}

// Things in the order in which they are drawn, sorted into the bands that they may touch.
struct Bins {                          // losing it changes nothing
    std::vector<Rows> reach;           // by thing: which rows it may touch
    std::vector<std::uint32_t> ends;   // by band: where its things end; none: each band has all things
    std::vector<std::uint32_t> things; // band after band
};

void sort(Bins& bins, int side, int height); // by `reach`

// Calls f(thing) for those of first..last - 1 that may touch a band, in order.
template <class F> void each_thing(const Bins& bins, std::size_t band, std::uint32_t first, std::uint32_t last, F&& f) {
    if (bins.ends.empty()) {
        for (; first < last; ++first) f(first);
        return;
    }
    const std::uint32_t* thing = bins.things.data() + (band == 0 ? 0 : bins.ends[band - 1]);
    const std::uint32_t* const end = bins.things.data() + bins.ends[band];
    for (thing = std::lower_bound(thing, end, first); thing != end && *thing < last; ++thing) f(*thing);
}

} // namespace evil::raster
