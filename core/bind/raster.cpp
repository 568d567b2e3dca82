// _core.Raster: the software renderer over pixels that Python owns.
#include "bind/bytes.hpp"
#include "draw/draw_list.hpp"
#include "raster/renderer.hpp"
#include <nanobind/stl/optional.h>
#include <nanobind/stl/tuple.h>
#include <optional>
#include <tuple>

namespace evil::bind {
namespace {

using Part = std::tuple<int, int, int, int>; // left, top, width, height

// Ids count up and are never given out twice, so a released texture can never turn into another.
class Raster {
public:
    explicit Raster(int threads) { set_threads(threads); }

    int threads() const { return threads_.count(); }
    void set_threads(int threads) {
        if (threads < 1 || threads > kMaxThreads)
            raise(ErrorKind::argument,
                  "Raster: threads=" + std::to_string(threads) + " must be 1 to " + std::to_string(kMaxThreads));
        threads_.set_count(threads);
    }

    std::uint32_t upload(nb::handle pixels, long width, long height) {
        Bytes bytes(pixels, false, "Raster.upload", "pixels");
        check_picture(bytes, width, height, "Raster.upload");
        textures_.push_back(raster::make_texture(bytes.data(), static_cast<int>(width), static_cast<int>(height)));
        return static_cast<std::uint32_t>(textures_.size() - 1);
    }

    void update(std::uint32_t texture, nb::handle pixels, long width, long height) {
        check_texture(texture, "Raster.update");
        Bytes bytes(pixels, false, "Raster.update", "pixels");
        check_picture(bytes, width, height, "Raster.update");
        textures_[texture] = raster::make_texture(bytes.data(), static_cast<int>(width), static_cast<int>(height));
    }

    void release(std::uint32_t texture) {
        check_texture(texture, "Raster.release");
        textures_[texture] = {};
    }

    // Holds the GIL: the list, the textures and the pixels all belong to Python, and another thread could change them.
    void draw(const draw::DrawList& list, nb::handle pixels, long width, long height,
              std::optional<std::uint32_t> background, const std::string& instructions, std::optional<Part> part,
              int rows) {
        Bytes bytes(pixels, true, "Raster.draw", "pixels");
        check_picture(bytes, width, height, "Raster.draw");
        if (reinterpret_cast<std::uintptr_t>(bytes.data()) % alignof(raster::Pixel) != 0)
            raise(ErrorKind::argument, "Raster.draw: pixels must start at a multiple of four bytes");
        raster::Target target{reinterpret_cast<raster::Pixel*>(bytes.data()), static_cast<int>(width),
                              static_cast<int>(height), static_cast<int>(width)};
        if (part) target = part_of(target, *part);
        if (rows < 0) raise(ErrorKind::argument, "Raster.draw: rows=" + std::to_string(rows) + " must not be negative");
        raster::render(list, background, textures_, target, scratch_, threads_, {to_set(instructions), rows});
    }

private:
    void check_texture(std::uint32_t texture, const char* owner) const {
        if (texture >= textures_.size() || textures_[texture].levels.empty())
            raise(ErrorKind::argument, std::string(owner) + ": texture=" + std::to_string(texture) +
                                           " is not one that upload() gave and that is still held");
    }

    static raster::Target part_of(raster::Target target, const Part& part) {
        const auto [left, top, width, height] = part;
        const bool inside = left >= 0 && top >= 0 && width >= 1 && height >= 1 && width <= target.width &&
                            height <= target.height && left <= target.width - width && top <= target.height - height;
        if (!inside) raise(ErrorKind::argument, "Raster.draw: part must lie within the picture");
        target.pixels = raster::row_of(target, top) + left;
        target.width = width, target.height = height;
        return target;
    }

    static InstructionSet to_set(const std::string& instructions) {
        if (instructions.empty()) return best_instruction_set();
        for (InstructionSet set : runnable_instruction_sets())
            if (instructions == name(set)) return set;
        raise(ErrorKind::argument, "Raster.draw: instructions='" + instructions + "' cannot run here");
    }

    std::vector<raster::Texture> textures_ = std::vector<raster::Texture>(1); // id 0 is no texture
    raster::Scratch scratch_;
    Threads threads_;
};

void unpremultiply(nb::handle pixels) {
    Bytes bytes(pixels, true, "unpremultiply", "pixels");
    if (bytes.size() % 4 != 0 || reinterpret_cast<std::uintptr_t>(bytes.data()) % alignof(raster::Pixel) != 0)
        raise(ErrorKind::argument, "unpremultiply: pixels must be whole pixels of four bytes");
    raster::unpremultiply({reinterpret_cast<raster::Pixel*>(bytes.data()), bytes.size() / 4});
}

} // namespace

void check_picture(const Bytes& bytes, long width, long height, const char* owner) {
    const bool sides = width >= 1 && height >= 1 && width <= raster::kMaxSide && height <= raster::kMaxSide;
    if (!sides || bytes.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4)
        raise(ErrorKind::argument, std::string(owner) + ": width=" + std::to_string(width) +
                                       ", height=" + std::to_string(height) + " must each be 1 to " +
                                       std::to_string(raster::kMaxSide) + " and go with " +
                                       std::to_string(bytes.size()) + " bytes, four a pixel");
}

void register_raster(nb::module_& module) {
    nb::class_<Raster>(module, "Raster", "The software renderer; evilengine.renderer.soft is its face.")
        .def(nb::init<int>(), nb::arg("threads") = 1)
        .def_prop_rw("threads", &Raster::threads, &Raster::set_threads, "How many threads may share in a picture.")
        .def("upload", &Raster::upload, nb::arg("pixels"), nb::arg("width"), nb::arg("height"),
             "Keep a picture of straight r, g, b, a bytes; its id is for DrawList.instance().")
        .def("update", &Raster::update, nb::arg("texture"), nb::arg("pixels"), nb::arg("width"), nb::arg("height"),
             "Put another picture, of any size, under the same id.")
        .def("release", &Raster::release, nb::arg("texture"), "Forget a picture.")
        .def("draw", &Raster::draw, nb::arg("list"), nb::arg("pixels"), nb::arg("width"), nb::arg("height"),
             nb::arg("background").none() = 0xff000000u, nb::arg("instructions") = "", nb::arg("part") = nb::none(),
             nb::arg("rows") = 0,
             "Draw into `pixels`, rows of r, g, b, a multiplied with alpha, over what is there if background is None; "
             "`instructions` forces one instruction set, `part` is the left, top, width and height drawn into, and "
             "`rows` is how many of them a thread takes at a time, 0 for as many as suit the frame: it changes no "
             "pixel.");
    module.def("unpremultiply", &unpremultiply, nb::arg("pixels"),
               "Turn pixels multiplied with alpha into straight ones, in place.");
}

} // namespace evil::bind
