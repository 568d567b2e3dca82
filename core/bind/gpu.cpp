// _core.Batcher: a draw list as what a graphics card takes; evilengine.renderer.gl is its face.
#include "bind/bytes.hpp"
#include "draw/draw_list.hpp"
#include "gpu/batches.hpp"
#include "raster/pyramid.hpp"
#include "raster/texture.hpp"
#include <memory>
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

nb::tuple to_tuple(const draw::Interlude& interlude) {
    switch (interlude.kind) {
    case draw::InterludeKind::blur: {
        const raster::Depth depth = raster::depth_of(interlude.radius);
        return nb::make_tuple("blur", depth.levels, depth.share);
    }
    case draw::InterludeKind::post:
        return nb::make_tuple("post");
    default:
        break;
    }
    const bool disc = interlude.form == draw::SpeckForm::disc;
    return nb::make_tuple("specks", interlude.first, interlude.count, disc, interlude.adds);
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
        result.held_ = held_;
        return result;
    }

    std::uint32_t hold() {
        held_->push_back(true);
        return static_cast<std::uint32_t>(held_->size() - 1);
    }
    void drop(std::uint32_t texture) {
        if (texture >= held_->size() || !(*held_)[texture])
            raise(ErrorKind::argument, "Renderer.release: texture=" + std::to_string(texture) +
                                           " is not one that upload() gave and that is still held");
        (*held_)[texture] = false;
    }

    nb::list collect(const draw::DrawList& list, int width, int height) {
        if (frame_.use_count() > 1) frame_ = std::make_shared<gpu::Frame>();
        if (shapes_.use_count() > 1) shapes_ = std::make_shared<gpu::Shapes>(*shapes_);
        post_ = list.interludes.post;
        gpu::collect(*frame_, *shapes_, scratch_, list, *held_, width, height);
        frame_->edges.resize((frame_->edges.size() + gpu::kRow - 1) / gpu::kRow * gpu::kRow); // uploaded by whole rows
        nb::list batches;
        for (const gpu::Batch& batch : frame_->batches) {
            if (batch.interlude) {
                batches.append(to_tuple(*batch.interlude));
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
    Memory quads() const { return memory_of(frame_, frame_->quads); }
    Memory edges() const { return memory_of(frame_, frame_->edges); }
    Memory shapes() const { return memory_of(shapes_, shapes_->texels); }
    std::uint64_t revision() const { return shapes_->revision; }

private:
    std::shared_ptr<gpu::Frame> frame_ = std::make_shared<gpu::Frame>();
    std::shared_ptr<gpu::Shapes> shapes_ = std::make_shared<gpu::Shapes>();
    gpu::Scratch scratch_;
    draw::Post post_;                                                                  // of the frame
    std::shared_ptr<std::vector<bool>> held_ = std::make_shared<std::vector<bool>>(1); // id 0 is no texture
};

// The picture and its smaller copies, each half as wide and high, colours multiplied with alpha: those `soft` draws from.
nb::list mipmaps(nb::handle pixels, long width, long height) {
    const Bytes bytes(pixels, false, "mipmaps", "pixels");
    check_picture(bytes, width, height, "mipmaps");
    const raster::Texture texture =
        raster::make_texture(bytes.data(), static_cast<int>(width), static_cast<int>(height));
    nb::list levels;
    for (const raster::Picture& level : texture.levels)
        levels.append(nb::make_tuple(level.width, level.height,
                                     nb::bytes(level.texels.data(), level.texels.size() * sizeof(raster::Pixel))));
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
        .def("collect", &Batcher::collect, nb::arg("list"), nb::arg("width"), nb::arg("height"),
             nb::sig("def collect(self, list: DrawList, width: int, height: int) -> "
                     "list[tuple[typing.Any, ...]]"),
             "A frame as draw calls: the first quad, how many, their pictures by unit, and 1 if any has facets plus "
             "twice the number of their draw::Blend plus 8 if any has normals or glows. "
             "Between them ('specks', first, count, are they discs, do they add), ('blur', levels, share), ('post',).")
        .def_prop_ro(
            "post", [](const Batcher& b) { return settings_of(b.post()); },
            nb::sig("def post(self) -> dict[str, float]"), "What the post pass of the frame is told.")
        .def_prop_ro(
            "tones", [](const Batcher& b) { return nb::bytes(b.post().table.data(), sizeof b.post().table); },
            "Its table: 1024 rows of four float32.")
        .def_prop_ro("specks", &Batcher::specks, "The frame's specks; see core/draw/specks.hpp.")
        .def_prop_ro("quads", &Batcher::quads, "The frame's quads; see core/gpu/quads.hpp.")
        .def_prop_ro("edges", &Batcher::edges,
                     "Edges made for this frame, in pixels: texels that follow those of `shapes`.")
        .def_prop_ro("shapes", &Batcher::shapes, "Edges and facets of the meshes: rows of 1024 texels of 4 floats.")
        .def_prop_ro("revision", &Batcher::revision, "Changes when `shapes` does.");
    module.def("mipmaps", &mipmaps, nb::arg("pixels"), nb::arg("width"), nb::arg("height"),
               nb::sig("def mipmaps(pixels: object, width: int, height: int) -> list[tuple[int, int, bytes]]"),
               "A picture of straight r, g, b, a and its smaller copies: width, height, bytes multiplied with alpha.");
}

} // namespace evil::bind
