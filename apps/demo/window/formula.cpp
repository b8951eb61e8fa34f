#include "apps/demo/window/formula.h"

#include <tinyxml2.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace scanlight::apps::window {

namespace {

using Element = tinyxml2::XMLElement;

constexpr double axis = 5.0;  // of fractions, above the baseline; all in pixels
constexpr double rule_gap = 3.0;
constexpr double subscript_drop = 4.0;
constexpr double superscript_rise = 7.0;
constexpr double thin_space = 3.0;

std::string_view name_of(const Element& element) {
    return element.Name();
}

std::vector<const Element*> children_of(const Element& element) {
    std::vector<const Element*> children;
    for (const Element* child = element.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement())
        children.push_back(child);
    return children;
}

/// `part` becomes one with `whole`, its beginning there.
void place(Formula& whole, const Formula& part, double x, double y) {
    for (FormulaText text : part.texts) {
        text.x += x;
        text.y += y;
        whole.texts.push_back(std::move(text));
    }
    for (const FormulaRule& rule : part.rules)
        whole.rules.push_back({rule.begin + x, rule.end + x, rule.y + y});
    whole.width = std::max(whole.width, x + part.width);
    whole.ascent = std::max(whole.ascent, part.ascent - y);
    whole.descent = std::max(whole.descent, part.descent + y);
}

/// Of room on either side of an operator.
double room_about(std::string_view mark) {
    for (const std::string_view wide : {"=", "+", "−", "≤", "≈"}) {
        if (mark == wide) return 4.0;
    }
    return mark == "⋅" || mark == "∑" ? 2.0 : 0.0;
}

double room_after(std::string_view mark) {
    return mark == "," ? 4.0 : room_about(mark);
}

class Setter {
public:
    explicit Setter(const Letters& letters) : letters_(letters) {}

    Formula row(const std::vector<const Element*>& parts, LetterSize size) const {
        Formula whole;
        for (const Element* part : parts)
            place(whole, set(*part, size), whole.width, 0.0);
        return whole;
    }

private:
    Formula set(const Element& element, LetterSize size) const {
        const std::string_view name = name_of(element);
        const auto parts = children_of(element);
        if (name == "mrow") return row(parts, size);
        if (name == "mi" || name == "mn") return word(element, size);
        if (name == "mo") return mark(element, size);
        if (name == "mspace") return {thin_space, 0.0, 0.0, {}, {}};
        if (parts.size() == 2) return pair(name, *parts[0], *parts[1], size);
        throw std::invalid_argument("no formula has <" + std::string(name) + ">");
    }

    Formula pair(std::string_view name, const Element& first, const Element& second,
                 LetterSize size) const {
        if (name == "msub") return with_script(set(first, size), set(second, LetterSize::low), 1);
        if (name == "msup") return with_script(set(first, size), set(second, LetterSize::low), -1);
        if (name == "mfrac") return fraction(set(first, size), set(second, size));
        if (name == "munder") return with_below(set(first, size), set(second, LetterSize::low));
        throw std::invalid_argument("no formula has <" + std::string(name) + ">");
    }

    Formula word(const Element& element, LetterSize size) const {
        const std::string text = element.GetText() != nullptr ? element.GetText() : "";
        const char* variant = element.Attribute("mathvariant");
        const bool is_bold = variant != nullptr && std::string_view(variant) == "bold";
        const auto i = static_cast<std::size_t>(size);
        return {letters_.width(text, size) + (is_bold ? 1.0 : 0.0),
                letters_.ascent[i],
                letters_.descent[i],
                {{0.0, 0.0, text, size, is_bold ? Weight::bold : Weight::plain}},
                {}};
    }

    Formula mark(const Element& element, LetterSize size) const {
        const Formula inner = word(element, size);
        const std::string& text = inner.texts.front().text;
        const double share = size == LetterSize::normal ? 1.0 : 0.4;
        Formula whole;
        place(whole, inner, share * room_about(text), 0.0);
        whole.width += share * room_after(text);
        return whole;
    }

    /// `side` is 1 for below the line, -1 for above.
    static Formula with_script(const Formula& base, const Formula& script, int side) {
        const double drop = side > 0 ? std::max(subscript_drop, base.descent - 2.0)
                                     : -std::max(superscript_rise, base.ascent - 7.0);
        Formula whole;
        place(whole, base, 0.0, 0.0);
        place(whole, script, base.width, drop);
        return whole;
    }

    static Formula fraction(const Formula& above, const Formula& below) {
        const double width = std::max(above.width, below.width) + 4.0;
        Formula whole;
        place(whole, above, (width - above.width) / 2, -axis - rule_gap - above.descent);
        place(whole, below, (width - below.width) / 2, -axis + rule_gap + below.ascent);
        whole.rules.push_back({1.0, width - 1.0, -axis});
        whole.width = width + 2.0;
        return whole;
    }

    static Formula with_below(const Formula& base, const Formula& under) {
        const double width = std::max(base.width, under.width);
        Formula whole;
        place(whole, base, (width - base.width) / 2, 0.0);
        place(whole, under, (width - under.width) / 2, base.descent + under.ascent - 2.0);
        return whole;
    }

    const Letters& letters_;
};

/// Where a line ends.
bool is_wide_space(const Element& element) {
    const char* width = element.Attribute("width");
    return name_of(element) == "mspace" && width != nullptr && std::string_view(width) == "1em";
}

/// What stands between wide spaces.
std::vector<std::vector<const Element*>> lines_of(const Element& math) {
    std::vector<std::vector<const Element*>> lines(1);
    const auto parts = children_of(math);
    const bool is_row = parts.size() == 1 && name_of(*parts.front()) == "mrow";
    for (const Element* part : is_row ? children_of(*parts.front()) : parts) {
        if (is_wide_space(*part)) {
            lines.emplace_back();
        } else {
            lines.back().push_back(part);
        }
    }
    return lines;
}

}  // namespace

std::vector<Formula> formula_lines(const std::string& mathml, const Letters& letters) {
    tinyxml2::XMLDocument document;
    if (document.Parse(mathml.c_str(), mathml.size()) != tinyxml2::XML_SUCCESS)
        throw std::invalid_argument(std::string("a formula: ") + document.ErrorStr());
    std::vector<Formula> lines;
    for (const auto& parts : lines_of(*document.RootElement()))
        lines.push_back(Setter(letters).row(parts, LetterSize::normal));
    return lines;
}

}  // namespace scanlight::apps::window
