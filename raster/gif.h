#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "raster/image.h"
#include "raster/project.h"

namespace scanlight::raster {

/// An animated GIF (89a) that repeats for ever, frame by frame, each in 256 colours of its own. The
/// same pictures give the same bytes. Frames are compressed as they come, so that no more than one
/// has to be held.
class GifEncoder {
public:
    /// Each frame stays for `delay` hundredths of a second, at least 2: many viewers slow down what
    /// is faster.
    GifEncoder(Viewport size, int delay);
    ~GifEncoder();
    GifEncoder(const GifEncoder&) = delete;
    GifEncoder& operator=(const GifEncoder&) = delete;

    /// Three channels, of the encoder's size.
    void add(const Image8& frame);

    /// The bytes of the file; no frame can be added any more. Throws ImageError if memory fails.
    std::vector<std::uint8_t> finish();

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace scanlight::raster
