#include "raster/instance.hpp"
#include <algorithm>
#include <bit>
#include <cmath>

namespace evil::raster {
namespace {

// Untouched blocks in a row between two touched ones from which on the run between is worth a call of its own.
constexpr int kGap = 2;
constexpr double kFarthest = 1e15; // pixels; beyond, a double no longer knows where in a pixel it is

// The pixels that the loops may touch, or an empty box if they lie outside or nowhere.
Box bounds_of(std::span<const Point> points, const Target& target) {
    double left = kFarthest, top = kFarthest, right = -kFarthest, bottom = -kFarthest;
    for (const Point& point : points) {
        if (!(std::fabs(point.x) < kFarthest && std::fabs(point.y) < kFarthest)) return {};
        left = std::min(left, point.x), right = std::max(right, point.x);
        top = std::min(top, point.y), bottom = std::max(bottom, point.y);
    }
    const double width = target.width, height = target.height;
    if (!(left < width && right > 0 && top < height && bottom > 0)) return {};
    return {static_cast<int>(std::floor(std::max(left, 0.0))), static_cast<int>(std::floor(std::max(top, 0.0))),
            static_cast<int>(std::ceil(std::min(right, width))), static_cast<int>(std::ceil(std::min(bottom, height)))};
}

int next_touched(const std::uint64_t* touched, int words, int from) { // the first touched block >= from, or -1
    for (int word = from / 64; word < words; ++word) {
        std::uint64_t rest = touched[word];
        if (word == from / 64) rest &= ~std::uint64_t{0} << (from % 64);
        if (rest) return word * 64 + std::countr_zero(rest);
    }
    return -1;
}

int cover_of(std::int32_t sum) { // as integrate() does for each pixel
    const std::int64_t area = std::min<std::int64_t>(std::abs(std::int64_t{sum}), kFullCell);
    return static_cast<int>((area * 255 + kFullCell / 2) >> 17);
}

// Draws runs of one row with a paint. The row's colours are worked out once, from its first run on.
struct Brush {
    Desk& desk;
    const draw::Instance& instance;
    Set set;
    Pixel* line;      // the target's row
    int y, right;     // where the row's last run ends
    LightRows* light; // null: it is not lit
    std::size_t band;
    int start = -1; // where the first one did
    Paint& paint = desk.paint;
    std::int32_t* mask = desk.mask.data();
    draw::Blend blend = instance.blend;

    bool is_plain() const { return is_flat(paint) && !light && instance.glow == 0.0f; }
    const Pixel* colours(int left) {
        Pixel* row = desk.row.data();
        if (start >= 0) return row + (left - start);
        start = left;
        const int count = right - left;
        if (is_flat(paint))
            fill(set, row, count, paint.flat);
        else
            paint_row(paint, set, y, left, right, row);
        if (instance.glow > 0.0f) keep_glow(left, row);
        if (light) light_up(set, row, factors(left), count, dither_at(left, y));
        if (instance.glow > 0.0f) shine(set, row, desk.glow.data(), count, instance.glow);
        return row;
    }
    void keep_glow(int left, const Pixel* unlit) {
        if (paint.glowing)
            paint_glow(paint, set, y, left, right, desk.glow.data());
        else
            std::copy_n(unlit, right - left, desk.glow.begin());
    }
    const std::uint32_t* factors(int left) {
        const std::uint32_t* flat = row_of(*light, light->light, y, band, set) + left;
        if (!paint.bumpy || !light->map->directed) return flat;
        const Light all{flat, row_of(*light, light->across, y, band, set) + left,
                        row_of(*light, light->down, y, band, set) + left};
        bend_light(paint, set, y, left, right, all, desk.bent.data());
        return desk.bent.data();
    }
    void masked(int left, int end) {
        const int count = end - left;
        if (blend == draw::Blend::add) return add_row(set, line + left, colours(left), mask, count);
        if (blend == draw::Blend::multiply) return multiply_row(set, line + left, colours(left), mask, count);
        if (blend == draw::Blend::screen) return screen_row(set, line + left, colours(left), mask, count);
        if (is_plain())
            blend_flat(set, line + left, mask, end - left, paint.flat);
        else
            blend_row(set, line + left, colours(left), mask, end - left);
    }
    void solid(int left, int end, int cover) {
        if (blend != draw::Blend::over) {
            std::fill_n(mask, end - left, cover);
            return masked(left, end);
        }
        if (!is_plain()) return blend_row(set, line + left, colours(left), end - left, cover);
        const Pixel colour = cover == 255 ? paint.flat : scale_pixel(paint.flat, cover);
        if (colour >> 24 == 255)
            fill(set, line + left, end - left, colour);
        else
            blend_flat(set, line + left, end - left, colour);
    }
};

// Turns one row's cells into runs and draws them. Leaves the cells zero.
void draw_row(Coverage& coverage, int row, Brush& brush) {
    std::uint64_t* touched = coverage.touched.data() + static_cast<std::size_t>(row) * coverage.words;
    std::int32_t* cells = coverage.cells.data() + static_cast<std::size_t>(row) * coverage.stride;
    const int width = coverage.box.right - coverage.box.left, left = coverage.box.left;
    int block = next_touched(touched, coverage.words, 0);
    std::int32_t sum = 0;
    while (block >= 0) {
        int end = block + 1, next = next_touched(touched, coverage.words, end);
        while (next >= 0 && next - end < kGap) end = next + 1, next = next_touched(touched, coverage.words, end);
        const int from = block * kBlock, to = end * kBlock;
        sum = integrate(brush.set, cells + from, to - from, sum, brush.mask);
        if (from < width) brush.masked(left + from, left + std::min(to, width));
        const int solid_end = next >= 0 ? std::min(next * kBlock, width) : width;
        if (const int cover = cover_of(sum); cover > 0 && to < solid_end)
            brush.solid(left + to, left + solid_end, cover);
        block = next;
    }
    std::fill_n(touched, coverage.words, std::uint64_t{0});
}

// Small things are all over the picture, and each of their rows is far from the one before: the processor is told early.
constexpr int kAhead = 4, kSmall = 128, kLine = 16; // rows; pixels
void fetch([[maybe_unused]] Pixel* row, const Box& box) {
    if (box.right - box.left > kSmall) return;
#if defined(__GNUC__)
    for (int x = box.left; x < box.right; x += kLine) __builtin_prefetch(row + x, 1);
    __builtin_prefetch(row + box.right - 1, 1);
#endif
}

} // namespace

void make_room(Desk& desk, int width) {
    const std::size_t room = static_cast<std::size_t>(width) + 4 * kBlock;
    if (desk.row.size() >= room) return;
    desk.mask.resize(room), desk.row.resize(room), desk.glow.resize(room), desk.bent.resize(room);
}

void draw_instance(const draw::DrawList& list, const draw::Instance& instance, const Pictures& pictures,
                   const Target& target, const Strip& strip, LightRows* light, Set set) {
    Desk& desk = strip.desk;
    const draw::Mesh& mesh = list.meshes[instance.mesh];
    if (instance.tint >> 24 == 0 || std::isnan(instance.outline)) return;
    clear(desk.loops);
    add_mesh(desk.loops, list, mesh, instance.to_pixel, instance.outline);
    Box box = bounds_of(desk.loops.points, target);
    const Rows rows{std::max(box.top, strip.rows.first), std::min(box.bottom, strip.rows.last)};
    if (box.left >= box.right || rows.first >= rows.last) return;
    const int blocks = (box.right - box.left + kBlock - 1) / kBlock; // whole ones: ends of runs take longer
    box.right = std::min(box.left + blocks * kBlock, target.width);

    begin(desk.coverage, box, rows);
    std::size_t first = 0;
    for (std::size_t end : desk.loops.ends) {
        add_loop(desk.coverage, std::span(desk.loops.points).subspan(first, end - first));
        first = end;
    }
    prepare(desk.paint, list, mesh, instance, pictures);
    if (!instance.lit) light = nullptr;
    for (int y = rows.first; y < rows.last; ++y) {
        if (y + kAhead < rows.last) fetch(row_of(target, y + kAhead), box);
        Brush brush{desk, instance, set, row_of(target, y), y, box.right, light, strip.band};
        draw_row(desk.coverage, y - rows.first, brush);
    }
}

Box reach_of(const draw::DrawList& list, const draw::Instance& instance, const Target& target) {
    const draw::Mesh& mesh = list.meshes[instance.mesh];
    const Affine& m = instance.to_pixel;
    const bool circle = mesh.kind == draw::MeshKind::circle;
    double left = kFarthest, top = kFarthest, right = -kFarthest, bottom = -kFarthest;
    for (const draw::Vertex& vertex :
         std::span(list.vertices).subspan(mesh.first_vertex, circle ? 1 : mesh.vertex_count)) {
        const double x = double{m.a} * vertex.at.x + double{m.c} * vertex.at.y + double{m.tx};
        const double y = double{m.b} * vertex.at.x + double{m.d} * vertex.at.y + double{m.ty};
        left = std::min(left, x), right = std::max(right, x), top = std::min(top, y), bottom = std::max(bottom, y);
    }
    // A stroke's tips reach kMitreLimit halves of its width, and the corners of a circle a twentieth beyond it.
    const double radius = circle ? 1.1 * std::fabs(double{mesh.radius}) : 0.0;
    const double edge = 0.5 * kMitreLimit * std::max(0.0, double{instance.outline}) + 1.0;
    const double across = radius * std::sqrt(double{m.a} * m.a + double{m.c} * m.c) + edge;
    const double down = radius * std::sqrt(double{m.b} * m.b + double{m.d} * m.d) + edge;
    left -= across, right += across, top -= down, bottom += down;
    const double width = target.width, height = target.height;
    if (!(left < width && right > 0 && top < height && bottom > 0)) return {};
    return {static_cast<int>(std::max(left, 0.0)), static_cast<int>(std::max(top, 0.0)),
            static_cast<int>(std::ceil(std::min(right, width))), static_cast<int>(std::ceil(std::min(bottom, height)))};
}

} // namespace evil::raster
