#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace scanlight::apps {

/// While it lives, options that are added to a command stand under this heading in its help.
class HelpHeading {
public:
    HelpHeading(CLI::App& app, const std::string& heading)
        : app_(app), before_(app.option_defaults()->get_group()) {
        app.option_defaults()->group(heading);
    }
    ~HelpHeading() { app_.option_defaults()->group(before_); }
    HelpHeading(const HelpHeading&) = delete;
    HelpHeading& operator=(const HelpHeading&) = delete;

private:
    CLI::App& app_;
    std::string before_;
};

}  // namespace scanlight::apps
