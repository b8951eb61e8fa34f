#include "apps/peers/options.h"

#include <exception>
#include <iostream>

#include <cstddef>

namespace scanlight::peers {

namespace {

/// "1920x1080".
raster::Viewport size_from(const std::string& text) {
    const std::size_t x = text.find('x');
    raster::Viewport size{0, 0};
    const bool right = x != std::string::npos &&
                       CLI::detail::lexical_cast(text.substr(0, x), size.width) &&
                       CLI::detail::lexical_cast(text.substr(x + 1), size.height);
    if (!right || size.width < 64 || size.height < 64 || size.width > 8192 || size.height > 8192)
        throw CLI::ValidationError("--size", text + " is not a size from 64x64 to 8192x8192");
    return size;
}

}  // namespace

void add_options(CLI::App& app, Options& options) {
    app.add_option_function<std::vector<std::string>>(
           "--size",
           [&options](const std::vector<std::string>& texts) {
               options.sizes.clear();
               for (const std::string& text : texts)
                   options.sizes.push_back(size_from(text));
           },
           "Size of the pictures [1920x1080]; several, separated by commas")
        ->delimiter(',');
    app.add_option("--threads", options.threads, "Threads of each side; several: one by one")
        ->delimiter(',')
        ->check(CLI::Range(1, 64))
        ->capture_default_str();
    app.add_option("--rounds", options.rounds, "Rounds to take the median of")
        ->check(CLI::Range(3, 1000))
        ->capture_default_str();
    app.add_option("--json", options.json_path, "Write all times to this file, an object a line");
}

int status_of(const std::string& program, const std::function<int()>& work) {
    try {
        return work();
    } catch (const std::exception& error) {
        std::cerr << program << ": " << error.what() << '\n';
        return 2;
    }
}

}  // namespace scanlight::peers
