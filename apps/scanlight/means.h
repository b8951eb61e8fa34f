#pragma once

#include "apps/scene/words.h"
#include "render/renderer.h"

namespace CLI {
class App;
}

namespace scanlight::apps {

/// The two ways through the renderer: vectors and threads, or the textbook's scanline walk.
enum class DrawPath { fast, textbook };

Words<DrawPath> words_beside(DrawPath);

/// By what means a picture is drawn. None of it changes a bit of the picture.
struct Means {
    DrawPath path = DrawPath::fast;
    render::Execution execution;  // of the fast path
};

/// Throws UsageError for means that the textbook's walk has not.
void check(const Means& means);

/// Adds --path, --threads and --instructions to a subcommand; `means` is filled as the command line
/// is parsed, and must outlive `app`.
void add_means_options(CLI::App& app, Means& means);

}  // namespace scanlight::apps
