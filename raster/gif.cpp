#include "raster/gif.h"

#include <gif_lib.h>

#include <cassert>
#include <cstddef>
#include <new>

#include "raster/image_error.h"
#include "raster/palette.h"

namespace scanlight::raster {

namespace {

using Bytes = std::vector<std::uint8_t>;

int append(GifFileType* gif, const GifByteType* bytes, int count) {
    auto& to = *static_cast<Bytes*>(gif->UserData);
    try {
        to.insert(to.end(), bytes, bytes + count);
        return count;
    } catch (const std::bad_alloc&) {
        return 0;  // the library is C: nothing may be thrown through it
    }
}

void expect_ok(int result) {
    if (result != GIF_OK) throw ImageError("GIF: out of memory");
}

/// giflib wants a power of two of colours.
int palette_size(std::size_t colors) {
    int size = 2;
    while (static_cast<std::size_t>(size) < colors)
        size *= 2;
    return size;
}

struct FreeMap {
    void operator()(ColorMapObject* map) const { GifFreeMapObject(map); }
};
using ColorMap = std::unique_ptr<ColorMapObject, FreeMap>;

ColorMap color_map(const PalettePicture& picture) {
    ColorMap map(GifMakeMapObject(palette_size(picture.colors.size()), nullptr));
    if (map == nullptr) throw std::bad_alloc();
    for (int i = 0; i < map->ColorCount; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const bool used = k < picture.colors.size();
        map->Colors[i] =
            used ? GifColorType{picture.colors[k][0], picture.colors[k][1], picture.colors[k][2]}
                 : GifColorType{0, 0, 0};
    }
    return map;
}

/// Netscape's extension, which all viewers know: repeat for ever.
void put_loop(GifFileType* gif) {
    const GifByteType forever[] = {1, 0, 0};
    expect_ok(EGifPutExtensionLeader(gif, APPLICATION_EXT_FUNC_CODE));
    expect_ok(EGifPutExtensionBlock(gif, 11, "NETSCAPE2.0"));
    expect_ok(EGifPutExtensionBlock(gif, sizeof forever, forever));
    expect_ok(EGifPutExtensionTrailer(gif));
}

void put_delay(GifFileType* gif, int delay) {
    const GraphicsControlBlock block{DISPOSE_DO_NOT, false, delay, NO_TRANSPARENT_COLOR};
    GifByteType bytes[4];
    const auto size = EGifGCBToExtension(&block, bytes);
    expect_ok(EGifPutExtension(gif, GRAPHICS_EXT_FUNC_CODE, static_cast<int>(size), bytes));
}

}  // namespace

struct GifEncoder::State {
    Viewport size;
    int delay;
    Bytes bytes{};
    GifFileType* gif = nullptr;

    void close() {
        if (gif != nullptr) EGifCloseFile(gif, nullptr);
        gif = nullptr;
    }
    ~State() { close(); }
};

GifEncoder::GifEncoder(Viewport size, int delay)
    : state_(std::make_unique<State>(State{size, delay})) {
    state_->gif = EGifOpen(&state_->bytes, append, nullptr);
    if (state_->gif == nullptr) throw std::bad_alloc();
    EGifSetGifVersion(state_->gif, true);
    expect_ok(EGifPutScreenDesc(state_->gif, size.width, size.height, 8, 0, nullptr));
    put_loop(state_->gif);
}

GifEncoder::~GifEncoder() = default;

void GifEncoder::add(const Image8& frame) {
    assert(frame.width() == state_->size.width && frame.height() == state_->size.height);
    PalettePicture picture = with_palette(frame);
    const ColorMap map = color_map(picture);
    const auto [width, height] = state_->size;
    put_delay(state_->gif, state_->delay);
    expect_ok(EGifPutImageDesc(state_->gif, 0, 0, width, height, false, map.get()));
    for (int y = 0; y < height; ++y) {
        const std::size_t begin = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
        expect_ok(EGifPutLine(state_->gif, &picture.pixels[begin], width));
    }
}

Bytes GifEncoder::finish() {
    state_->close();
    return std::move(state_->bytes);
}

}  // namespace scanlight::raster
