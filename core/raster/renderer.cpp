#include "raster/renderer.hpp"
#include "raster/specks.hpp"
#include <algorithm>

namespace evil::raster {
namespace {

using draw::Interlude;
using draw::InterludeKind;

// What drawing costs, in pixels that are filled with a picture, which take about a nanosecond. From kWorthSharing on it is
// longer than it takes to wake threads, twenty times.
constexpr double kInstance = 300, kSpeck = 40, kPass = 3, kFill = 0.25, kWorthSharing = 200'000;
constexpr int kBandsEach = 4;        // bands for each thread: what one thing more here or there costs evens out
constexpr int kWorthABand = 4096;    // pixels of a pass over the picture
constexpr int kLeastRows = 16;       // of a band: what lies across its border is set up on both sides
constexpr std::size_t kLooks = 2048; // things whose place a thread finds at a time

// One frame, as all of its bands see it.
struct Frame {
    const draw::DrawList& list;
    std::span<const Texture> textures;
    const Target& target;
    Scratch& scratch;
    Bands bands;
    Set set;

    const Texture* picture(std::uint32_t id) const {
        return id != draw::kNoTexture && id < textures.size() ? &textures[id] : nullptr;
    }
    bool is_drawn(const draw::Instance& instance) const {
        return instance.mesh < scratch.sound.size() && scratch.sound[instance.mesh];
    }
    LightRows* light() const { return list.light.on ? &scratch.light : nullptr; }
    void draw(std::uint32_t first, std::uint32_t last, const Strip& strip) const {
        each_thing(scratch.instances, strip.band, first, last, [&](std::uint32_t i) {
            const draw::Instance& one = list.instances[i];
            if (!is_drawn(one)) return;
            const Pictures pictures{picture(one.texture), picture(one.normals), picture(one.glows)};
            draw_instance(list, one, pictures, target, strip, light(), set);
        });
    }
};

// Instances and specks that lie one over the other, with nothing between them that needs the whole picture.
struct Stretch {
    std::uint32_t first = 0, last = 0; // instances
    std::span<const Interlude> specks{};
};

void draw_stretch(const Frame& frame, const Stretch& stretch, std::optional<Pixel> background) {
    if (stretch.first == stretch.last && stretch.specks.empty() && !background) return;
    const Target& target = frame.target;
    each_band(frame.bands, target.width, target.height, [&](const Rows& rows, std::size_t band) {
        for (int y = rows.first; background && y < rows.last; ++y)
            fill(frame.set, row_of(target, y), target.width, *background);
        const Strip strip{rows, band, frame.scratch.desks[band]};
        std::uint32_t at = stretch.first;
        for (const Interlude& one : stretch.specks) {
            frame.draw(at, one.before, strip);
            at = one.before;
            draw_specks(frame.list.interludes.specks, one, frame.scratch.specks, band, rows, target, frame.set);
        }
        frame.draw(at, stretch.last, strip);
    });
}

void change_all(const Frame& frame, const Interlude& one) { // what has been drawn so far
    const draw::Interludes& all = frame.list.interludes;
    Scratch& scratch = frame.scratch;
    switch (one.kind) {
    case InterludeKind::specks:
        return;
    case InterludeKind::blur:
        return blur(frame.target, one.radius, scratch.pyramid, frame.bands, frame.set);
    case InterludeKind::shafts:
        return shine(frame.target, all.shafts[one.first], scratch.pyramid, frame.bands, frame.set);
    case InterludeKind::liquid:
        return draw_liquid(all.liquids[one.first], frame.target, frame.light(), scratch.liquid, frame.bands, frame.set);
    case InterludeKind::post:
        return finish(frame.target, all.post, scratch.pyramid, frame.bands, frame.set);
    }
}

void draw_all(const Frame& frame, std::optional<Pixel> background) {
    const auto count = static_cast<std::uint32_t>(frame.list.instances.size());
    std::span<const Interlude> rest(frame.list.interludes.rows);
    while (!rest.empty() && rest.back().before > count) rest = rest.first(rest.size() - 1);
    for (std::uint32_t first = 0;;) {
        const auto whole =
            std::ranges::find_if(rest, [](const Interlude& one) { return one.kind != InterludeKind::specks; });
        const auto specks = static_cast<std::size_t>(whole - rest.begin());
        const bool over = whole == rest.end();
        const Stretch stretch{first, over ? count : whole->before, rest.first(specks)};
        draw_stretch(frame, stretch, background);
        if (over) return;
        change_all(frame, *whole);
        background.reset(), first = stretch.last, rest = rest.subspan(specks + 1);
    }
}

bool is_worth_sharing(const Frame& frame) {
    const draw::DrawList& list = frame.list;
    const double area = static_cast<double>(frame.target.width) * frame.target.height;
    double cost = kFill * area + kInstance * static_cast<double>(list.instances.size());
    for (const Interlude& one : list.interludes.rows)
        cost += one.kind == InterludeKind::specks ? kSpeck * one.count : kPass * area;
    for (std::size_t i = 0; i < list.instances.size() && cost < kWorthSharing; ++i) {
        const draw::Instance& one = list.instances[i];
        const Box box = frame.is_drawn(one) ? reach_of(list, one, frame.target) : Box{};
        cost += static_cast<double>(box.right - box.left) * (box.bottom - box.top);
    }
    return cost >= kWorthSharing;
}

void sort_into_bands(const Frame& frame) {
    const draw::DrawList& list = frame.list;
    const Target& target = frame.target;
    Bins &instances = frame.scratch.instances, &specks = frame.scratch.specks;
    instances.reach.resize(list.instances.size());
    parallel_for(frame.bands.threads, list.instances.size(), kLooks, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const draw::Instance& one = list.instances[i];
            const Box box = frame.is_drawn(one) ? reach_of(list, one, target) : Box{};
            instances.reach[i] = {box.top, box.bottom};
        }
    });
    specks.reach.resize(list.interludes.specks.size());
    parallel_for(frame.bands.threads, specks.reach.size(), kLooks, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) specks.reach[i] = reach_of(list.interludes.specks[i], target.height);
    });
    const int side = side_of(frame.bands, target.width, target.height);
    sort(instances, side, target.height);
    sort(specks, side, target.height);
}

// One band where threads would wake for too little.
void cut(Bands& bands, const Frame& frame, const How& how) {
    const int height = frame.target.height, threads = bands.threads.count();
    if (how.rows > 0)
        bands.most = (height + how.rows - 1) / how.rows, bands.least = 0;
    else if (threads > 1 && is_worth_sharing(frame))
        bands.most = std::clamp(height / kLeastRows, 1, kBandsEach * threads);
}

} // namespace

void render(const draw::DrawList& list, std::optional<draw::Rgba8> background, std::span<const Texture> textures,
            const Target& target, Scratch& scratch, Threads& threads, const How& how) {
    scratch.sound.resize(list.meshes.size());
    for (std::size_t i = 0; i < list.meshes.size(); ++i) scratch.sound[i] = draw::is_sound(list, list.meshes[i]);
    Frame frame{list, textures, target, scratch, {threads, 1, kWorthABand}, how.set};
    cut(frame.bands, frame, how);
    std::optional<Threads::Shift> shift;
    if (frame.bands.most > 1) shift.emplace(threads);

    const auto bands = static_cast<std::size_t>(frame.bands.most);
    if (scratch.desks.size() < bands) scratch.desks.resize(bands);
    for (Desk& desk : std::span(scratch.desks).first(bands)) make_room(desk, target.width);
    begin(scratch.light, list.light, target, frame.bands);
    scratch.instances.ends.clear(), scratch.specks.ends.clear();
    if (bands > 1) sort_into_bands(frame);
    draw_all(frame, background ? std::optional(premultiply(*background)) : std::nullopt);
}

void unpremultiply(std::span<Pixel> pixels) noexcept {
    for (Pixel& pixel : pixels) {
        const Pixel alpha = pixel >> 24;
        if (alpha == 255 || alpha == 0) continue;
        Pixel straight = alpha << 24;
        for (int shift = 0; shift < 24; shift += 8)
            straight |= std::min<Pixel>(255, ((pixel >> shift & 255) * 255 + alpha / 2) / alpha) << shift;
        pixel = straight;
    }
}

} // namespace evil::raster
