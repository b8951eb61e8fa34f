#pragma once

#include <string>
#include <vector>

#include "raster/image.h"

namespace scanlight::exercises {

/// Numbers that a part left to write should give, as they come in.
class Checks {
public:
    /// Right within 1e-6.
    void number(const std::string& what, double yours, double right);
    void answer(const std::string& what, bool yours, bool right);

    int count() const { return count_; }
    /// A sentence for each that is wrong.
    const std::vector<std::string>& wrong() const { return wrong_; }

private:
    int count_ = 0;
    std::vector<std::string> wrong_;
};

/// What an exercise is judged by: numbers, and a picture drawn by means of the part left to write
/// beside the one that the renderer draws.
struct Exercise {
    std::string name;  // of its folder, and of its pictures
    Checks (*checks)();
    raster::Image8 (*yours)();
    raster::Image8 (*right)();
    double tolerance_levels = 0;  // of 255, in the picture
};

/// The whole program of an exercise: says what is right and what is not, and writes NAME.png,
/// NAME-right.png and NAME-difference.png into the folder that is its one argument, or where it
/// stands. Returns the exit status: 0 all is right, 1 not yet, 2 an error.
int judge(const Exercise& exercise, int argc, const char* const* argv);

}  // namespace scanlight::exercises
