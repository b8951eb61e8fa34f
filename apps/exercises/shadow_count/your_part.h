#pragma once

#include <vector>

// Exercise 5: shadow volumes (chapter 12.1.4; Crow 1977).
//
// A ray from the eye goes through faces of shadow volumes: it enters a volume by a face that looks
// towards the eye, and leaves it by one that looks away. A surface is in shadow when the ray is
// inside a volume where it meets the surface.
//
// Where the eye itself stands in a shadow, a count that begins at the eye with 0 is wrong. So count
// from the other end: beyond everything the ray is in no shadow at all (z-fail).

namespace scanlight::exercises {

struct Crossing {
    bool enters;  // a volume; else it leaves one
    bool is_behind_surface;
};

/// All crossings of the ray, in any order.
inline bool is_in_shadow(const std::vector<Crossing>& crossings) {
    // Your part.
    (void)crossings;
    return false;
}

}  // namespace scanlight::exercises
