#include "apps/scanlight/text_option.h"

#include <sstream>

#include "apps/scene/parse.h"

namespace scanlight::apps {

CLI::Validator within(double low, double high) {
    std::ostringstream range;
    range << "from " << low << " to " << high;
    const auto check = [low, high, expected = range.str()](const std::string& text) {
        const double number = parse_number(text, "value");
        return number >= low && number <= high ? "" : "'" + text + "': expected " + expected;
    };
    return CLI::Validator(check, range.str());
}

}  // namespace scanlight::apps
