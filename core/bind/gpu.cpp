// _core.Batcher: a draw list as what a graphics card takes; evilengine.renderer.gl is its face.
#include "bind/bytes.hpp"
#include "draw/draw_list.hpp"
#include "gpu/batches.hpp"
#include "gpu/liquid.hpp"
#include "raster/pyramid.hpp"
#include "raster/shafts.hpp"
#include "raster/texture.hpp"
#include <memory>
#include <nanobind/stl/array.h>
#include <nanobind/stl/vector.h>

namespace evil::bind {
namespace {

// Memory that was filled for one frame, seen from Python. It stays as it is for as long as somebody looks at it.
struct Memory {
    std::shared_ptr<const void> owner;
    const void* data;
    std::size_t size;
};

int get_buffer(PyObject* self, Py_buffer* buffer, int flags) {
    const Memory* memory = nb::inst_ptr<Memory>(self);
    return PyBuffer_FillInfo(buffer, self, const_cast<void*>(memory->data), static_cast<Py_ssize_t>(memory->size), 1,
                             flags);
}

PyType_Slot memory_slots[] = {{Py_bf_getbuffer, reinterpret_cast<void*>(get_buffer)}, {0, nullptr}};

template <class T> Memory memory_of(const std::shared_ptr<const void>& owner, const std::vector<T>& values) {
    return {owner, values.data(), values.size() * sizeof(T)};
}

nb::tuple to_tuple(const draw::Interlude& interlude, const draw::Interludes& all,
                   const std::shared_ptr<gpu::Frame>& frame) {
    switch (interlude.kind) {
    case draw::InterludeKind::blur: {
        const raster::Depth depth = raster::depth_of(interlude.radius);
        return nb::make_tuple("blur", depth.levels, depth.share);
    }
    case draw::InterludeKind::shafts: {
        const draw::Shafts& shafts = all.shafts[interlude.first];
        nb::list passes;
        for (int pass = 0; pass < raster::kShaftPasses; ++pass) {
            const raster::ShaftTaps taps = raster::shaft_taps(shafts.reach, pass);
            nb::list at, weight;
            for (int i = 0; i < raster::kShaftTaps; ++i) at.append(taps.at[i]), weight.append(taps.weight[i]);
            passes.append(nb::make_tuple(nb::tuple(at), nb::tuple(weight)));
        }
        const raster::Glow glow = raster::glow_of(shafts);
        return nb::make_tuple("shafts", nb::make_tuple(shafts.from.x, shafts.from.y), nb::tuple(passes),
                              nb::make_tuple(glow.red, glow.green, glow.blue), shafts.threshold);
    }
    case draw::InterludeKind::liquid: {
        const draw::LiquidMap& map = all.liquids[interlude.first];
        nb::list planes;
        for (const gpu::Halves& plane : frame->liquids[interlude.first]) planes.append(memory_of(frame, plane));
        return nb::make_tuple("liquid", nb::make_tuple(map.stride, map.height), nb::tuple(planes),
                              nb::make_tuple(map.first.x, map.first.y, 1.0f / map.step),
                              nb::make_tuple(map.width, map.height), 1.0f / map.rim_width, map.lit);
    }
    case draw::InterludeKind::post:
        return nb::make_tuple("post");
    default:
        break;
    }
    const bool disc = interlude.form == draw::SpeckForm::disc;
    return nb::make_tuple("specks", interlude.first, interlude.count, disc, static_cast<int>(interlude.blend));
}

// What the shader needs of the post pass besides the table.
nb::dict settings_of(const draw::Post& post) {
    nb::dict settings;
    settings["bloom"] = post.bloom, settings["threshold"] = post.threshold, settings["saturation"] = post.saturation;
    settings["vignette"] = post.vignette, settings["grain"] = post.grain, settings["seed"] = post.seed;
    return settings;
}

// Ids of pictures count up and are never given out twice, so a released one can never turn into another.
class Batcher {
public:
    Batcher another() const {
        Batcher result;
        result.pictures_ = pictures_;
        return result;
    }

    std::uint32_t hold() {
        pictures_->held.push_back(true);
        return static_cast<std::uint32_t>(pictures_->held.size() - 1);
    }
    void drop(std::uint32_t texture) {
        if (texture >= pictures_->held.size() || !pictures_->held[texture])
            raise(ErrorKind::argument, "Renderer.release: texture=" + std::to_string(texture) +
                                           " is not one that upload() gave and that is still held");
        pictures_->held[texture] = false;
    }

    void place(std::uint32_t texture, std::uint32_t page, const std::vector<std::array<float, 9>>& copies) {
        std::vector<gpu::Place>& places = pictures_->places.pictures;
        if (texture >= pictures_->held.size())
            raise(ErrorKind::argument, "Batcher.place: texture=" + std::to_string(texture) + " was never held");
        if (texture >= places.size()) places.resize(texture + 1);
        gpu::Place& place = places[texture] = {page, {}};
        for (const auto& [left, top, width, height, from, first, to, last, clear_corners] : copies)
            place.copies.push_back(
                gpu::make_spot(left, top, width, height, {from, first, to, last}, clear_corners != 0.0f));
    }

    nb::list collect(const draw::DrawList& list, int width, int height) {
        if (frame_.use_count() > 1) frame_ = std::make_shared<gpu::Frame>();
        if (shapes_.use_count() > 1) shapes_ = std::make_shared<gpu::Shapes>(*shapes_);
        post_ = list.interludes.post;
        gpu::collect(*frame_, *shapes_, scratch_, list, *pictures_, width, height);
        frame_->edges.resize((frame_->edges.size() + gpu::kRow - 1) / gpu::kRow * gpu::kRow); // uploaded by whole rows
        nb::list batches;
        for (const gpu::Batch& batch : frame_->batches) {
            if (batch.interlude) {
                batches.append(to_tuple(*batch.interlude, list.interludes, frame_));
                continue;
            }
            if (batch.sprites) {
                batches.append(nb::make_tuple("sprites", batch.first, batch.count, batch.textures[0],
                                              static_cast<int>(batch.fringe), batch.lit,
                                              static_cast<int>(batch.blend)));
                continue;
            }
            nb::list textures;
            for (std::uint32_t i = 0; i < batch.units; ++i) textures.append(batch.textures[i]);
            const int look = int{batch.facets} + 2 * static_cast<int>(batch.blend) + 8 * int{batch.surfaces};
            batches.append(nb::make_tuple(batch.first, batch.count, nb::tuple(textures), look));
        }
        return batches;
    }

    const draw::Post& post() const { return post_; }
    Memory specks() const { return memory_of(frame_, frame_->specks); }
    Memory sprites() const { return memory_of(frame_, frame_->sprites); }
    Memory quads() const { return memory_of(frame_, frame_->quads); }
    Memory edges() const { return memory_of(frame_, frame_->edges); }
    Memory shapes() const { return memory_of(shapes_, shapes_->texels); }
    std::uint64_t revision() const { return shapes_->revision; }

private:
    std::shared_ptr<gpu::Frame> frame_ = std::make_shared<gpu::Frame>();
    std::shared_ptr<gpu::Shapes> shapes_ = std::make_shared<gpu::Shapes>();
    gpu::Scratch scratch_;
    draw::Post post_; // of the frame
    std::shared_ptr<gpu::Pictures> pictures_ =
        std::make_shared<gpu::Pictures>(gpu::Pictures{std::vector<bool>(1), {}}); // id 0 is no texture
};

// The picture and its smaller copies, each half as wide and high, colours multiplied with alpha: those `soft` draws from.
nb::list mipmaps(nb::handle pixels, long width, long height) {
    const Bytes bytes(pixels, false, "mipmaps", "pixels");
    check_picture(bytes, width, height, "mipmaps");
    const raster::Texture texture =
        raster::make_texture(bytes.data(), static_cast<int>(width), static_cast<int>(height));
    nb::list levels;
    for (const raster::Picture& level : texture.levels) {
        const raster::Box seen = raster::seen_part(level);
        levels.append(nb::make_tuple(
            level.width, level.height, nb::bytes(level.texels.data(), level.texels.size() * sizeof(raster::Pixel)),
            nb::make_tuple(seen.left, seen.top, seen.right, seen.bottom, raster::corners_are_clear(level))));
    }
    return levels;
}

} // namespace

void register_gpu(nb::module_& module) {
    nb::class_<Memory>(module, "Memory", nb::type_slots(memory_slots), "Bytes of the core, read-only, without a copy.")
        .def("__len__", [](const Memory& memory) { return memory.size; });
    nb::class_<Batcher>(module, "Batcher", "Draw lists as quads for a graphics card, in few draw calls.")
        .def(nb::init<>())
        .def("another", &Batcher::another, "One more of the same pictures, which keeps another list's meshes.")
        .def("hold", &Batcher::hold, "The id of one more picture.")
        .def("drop", &Batcher::drop, nb::arg("texture"), "Draw what names this picture without one from now on.")
        .def("place", &Batcher::place, nb::arg("texture"), nb::arg("page"), nb::arg("copies"),
             nb::sig("def place(self, texture: int, page: int, "
                     "copies: collections.abc.Sequence[tuple[float, float, float, float, float, float, float, float, "
                     "float]]) -> None"),
             "Where in the atlas a picture is: for each of its copies left and top there, width, height, and the part "
             "that is not clear: left, top, right, bottom; 1 if its corners are clear. No copies: nowhere. Texture 0: "
             "a white texel.")
        .def("collect", &Batcher::collect, nb::arg("list"), nb::arg("width"), nb::arg("height"),
             nb::sig("def collect(self, list: DrawList, width: int, height: int) -> "
                     "list[tuple[typing.Any, ...]]"),
             "A frame as draw calls: the first quad, how many, their pictures by unit, and 1 if any has facets plus "
             "twice the number of their draw::Blend plus 8 if any has normals or glows. "
             "Or ('sprites', first, count, page of the atlas, COVER, is one lit, blend). "
             "Between them ('specks', first, count, are they discs, their blend), ('blur', levels, share), "
             "('shafts', from, taps of each pass, colour, threshold), ('liquid', size, planes, place, texels used, one "
             "over the rim's width, is it lit), ('post',).")
        .def_prop_ro(
            "post", [](const Batcher& b) { return settings_of(b.post()); },
            nb::sig("def post(self) -> dict[str, float]"), "What the post pass of the frame is told.")
        .def_prop_ro(
            "tones", [](const Batcher& b) { return nb::bytes(b.post().table.data(), sizeof b.post().table); },
            "Its table: 1024 rows of four float32.")
        .def_prop_ro("specks", &Batcher::specks, "The frame's specks; see core/draw/specks.hpp.")
        .def_prop_ro("sprites", &Batcher::sprites, "The frame's sprites; see core/gpu/quads.hpp.")
        .def_prop_ro("quads", &Batcher::quads, "The frame's quads; see core/gpu/quads.hpp.")
        .def_prop_ro("edges", &Batcher::edges,
                     "Edges made for this frame, in pixels: texels that follow those of `shapes`.")
        .def_prop_ro("shapes", &Batcher::shapes, "Edges and facets of the meshes: rows of 1024 texels of 4 floats.")
        .def_prop_ro("revision", &Batcher::revision, "Changes when `shapes` does.");
    module.def(
        "mipmaps", &mipmaps, nb::arg("pixels"), nb::arg("width"), nb::arg("height"),
        nb::sig("def mipmaps(pixels: object, width: int, height: int) -> "
                "list[tuple[int, int, bytes, tuple[int, int, int, int, bool]]]"),
        "A picture of straight r, g, b, a and its smaller copies: width, height, bytes multiplied with alpha, and "
        "the part that is not clear: left, top, right, bottom; and whether the corners are, two texels each way.");
}

} // namespace evil::bind
