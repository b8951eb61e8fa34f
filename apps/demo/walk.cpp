#include "apps/demo/walk.h"

namespace scanlight::demo {

std::vector<WalkStep> walk_of(const raster::Trace& trace) {
    using Kind = WalkStep::Kind;
    std::vector<WalkStep> steps;
    for (std::size_t edge = 0; edge < trace.edge_table.size(); ++edge)
        steps.push_back({Kind::edge, edge});
    const std::size_t last = trace.edge_table.empty() ? 0 : trace.edge_table.size() - 1;
    for (std::size_t line = 0; line < trace.scanlines.size(); ++line) {
        steps.push_back({Kind::scanline, last, line});
        const auto& spans = trace.scanlines[line].spans;
        for (std::size_t span = 0; span < spans.size(); ++span) {
            for (int x = spans[span].x_begin; x < spans[span].x_end; ++x)
                steps.push_back({Kind::pixel, last, line, span, x});
        }
    }
    return steps;
}

raster::Trace::Numbers numbers_at(const raster::Trace::Span& span, int x) {
    raster::Trace::Numbers numbers = span;
    const double steps = x - span.x_begin;
    numbers.z += steps * span.dz;
    for (std::size_t k = 0; k < numbers.values.size(); ++k)
        numbers.values[k] += steps * span.steps[k];
    return numbers;
}

}  // namespace scanlight::demo
