#include "raster/bands.hpp"

namespace evil::raster {

void sort(Bins& bins, int side, int height) {
    const std::size_t count = static_cast<std::size_t>((height + side - 1) / side);
    const auto each = [&](auto&& f) {
        for (std::uint32_t thing = 0; thing < bins.reach.size(); ++thing)
            if (const Rows& rows = bins.reach[thing]; rows.first < rows.last)
                for (int band = rows.first / side; band <= (rows.last - 1) / side; ++band) f(bins.ends[band], thing);
    };
    bins.ends.assign(count, 0);
    each([](std::uint32_t& end, std::uint32_t) { ++end; });
    std::uint32_t sum = 0;
    for (std::uint32_t& end : bins.ends) { // for now, where they begin
        const std::uint32_t own = end;
        end = sum, sum += own;
    }
    bins.things.resize(sum);
    each([&](std::uint32_t& end, std::uint32_t thing) { bins.things[end++] = thing; });
}

} // namespace evil::raster
