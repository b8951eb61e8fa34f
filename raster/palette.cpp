#include "raster/palette.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace scanlight::raster {

namespace {

constexpr std::size_t most_colors = 256;
constexpr int bits = 6;  // of a channel
constexpr std::size_t cells = std::size_t{1} << (3 * bits);

/// Pixels whose colours have the same highest bits.
struct Cell {
    std::array<int, 3> place{};  // those bits
    std::uint64_t pixels = 0;
    std::array<std::uint64_t, 3> sum{};  // of their colours
};

using Cells = std::vector<Cell>;

/// Cells [begin, end), and how much it would help to cut them.
struct Box {
    std::size_t begin;
    std::size_t end;
    int axis = 0;            // the longest
    std::uint64_t need = 0;  // pixels times its length squared; 0: it cannot be cut
};

std::size_t cell_of(const std::uint8_t* rgb) {
    constexpr int shift = 8 - bits;
    return static_cast<std::size_t>(rgb[0] >> shift) << (2 * bits) |
           static_cast<std::size_t>(rgb[1] >> shift) << bits |
           static_cast<std::size_t>(rgb[2] >> shift);
}

std::array<int, 3> place_of(std::size_t cell) {
    constexpr std::size_t mask = (1 << bits) - 1;
    return {static_cast<int>(cell >> (2 * bits)), static_cast<int>(cell >> bits & mask),
            static_cast<int>(cell & mask)};
}

/// Those that have pixels, in their order.
Cells occupied(const Image8& image) {
    Cells all(cells);
    const auto& samples = image.samples();
    for (std::size_t i = 0; i < samples.size(); i += 3) {
        Cell& cell = all[cell_of(&samples[i])];
        ++cell.pixels;
        for (std::size_t k = 0; k < 3; ++k)
            cell.sum[k] += samples[i + k];
    }
    for (std::size_t i = 0; i < cells; ++i)
        all[i].place = place_of(i);
    std::erase_if(all, [](const Cell& cell) { return cell.pixels == 0; });
    return all;
}

Box box_of(const Cells& all, std::size_t begin, std::size_t end) {
    Box box{begin, end};
    int longest = 0;
    std::uint64_t pixels = 0;
    for (std::size_t i = begin; i < end; ++i)
        pixels += all[i].pixels;
    for (int axis = 0; axis < 3; ++axis) {
        const auto along = [axis](const Cell& cell) {
            return cell.place[static_cast<std::size_t>(axis)];
        };
        const auto [low, high] =
            std::ranges::minmax_element(all.begin() + static_cast<std::ptrdiff_t>(begin),
                                        all.begin() + static_cast<std::ptrdiff_t>(end), {}, along);
        const int length = along(*high) - along(*low);
        if (length > longest) {
            longest = length;
            box.axis = axis;
        }
    }
    box.need = pixels * static_cast<std::uint64_t>(longest) * static_cast<std::uint64_t>(longest);
    return box;
}

/// Sorts the box's cells along its axis, and finds where half of its pixels lie on each side.
std::size_t median_cut(Cells& all, const Box& box) {
    const auto axis = static_cast<std::size_t>(box.axis);
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(box.begin);
    const auto last = all.begin() + static_cast<std::ptrdiff_t>(box.end);
    std::sort(first, last, [axis](const Cell& a, const Cell& b) {
        return a.place[axis] != b.place[axis] ? a.place[axis] < b.place[axis] : a.place < b.place;
    });
    std::uint64_t pixels = 0;
    for (auto cell = first; cell != last; ++cell)
        pixels += cell->pixels;
    std::uint64_t before = 0;
    std::size_t cut = box.begin;
    while (cut + 1 < box.end && (before + all[cut].pixels) * 2 <= pixels)
        before += all[cut++].pixels;
    return std::max(cut, box.begin + 1);
}

std::vector<Box> boxes_of(Cells& all) {
    std::vector<Box> boxes{box_of(all, 0, all.size())};
    while (boxes.size() < most_colors) {
        const auto largest = std::ranges::max_element(boxes, {}, &Box::need);
        if (largest->need == 0) break;
        const Box box = *largest;
        const std::size_t cut = median_cut(all, box);
        *largest = box_of(all, box.begin, cut);
        boxes.push_back(box_of(all, cut, box.end));
    }
    return boxes;
}

std::array<std::uint8_t, 3> mean_color(const Cells& all, const Box& box) {
    std::uint64_t pixels = 0;
    std::array<std::uint64_t, 3> sum{};
    for (std::size_t i = box.begin; i < box.end; ++i) {
        pixels += all[i].pixels;
        for (std::size_t k = 0; k < 3; ++k)
            sum[k] += all[i].sum[k];
    }
    std::array<std::uint8_t, 3> color{};
    for (std::size_t k = 0; k < 3; ++k)
        color[k] = static_cast<std::uint8_t>((sum[k] + pixels / 2) / pixels);
    return color;
}

}  // namespace

PalettePicture with_palette(const Image8& rgb) {
    assert(rgb.channels() == 3);
    Cells all = occupied(rgb);
    PalettePicture picture;
    std::vector<std::uint8_t> color_of_cell(cells, 0);
    for (const Box& box : boxes_of(all)) {
        for (std::size_t i = box.begin; i < box.end; ++i) {
            const auto [r, g, b] = all[i].place;
            color_of_cell[static_cast<std::size_t>(r << (2 * bits) | g << bits | b)] =
                static_cast<std::uint8_t>(picture.colors.size());
        }
        picture.colors.push_back(mean_color(all, box));
    }
    const auto& samples = rgb.samples();
    for (std::size_t i = 0; i < samples.size(); i += 3)
        picture.pixels.push_back(color_of_cell[cell_of(&samples[i])]);
    return picture;
}

}  // namespace scanlight::raster
