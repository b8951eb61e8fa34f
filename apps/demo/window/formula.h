#pragma once

#include <functional>
#include <string>
#include <vector>

namespace scanlight::apps::window {

// A formula of the course, which stands there as MathML, laid out for a window.

enum class LetterSize { normal, low };  // as of sub- and superscripts

/// How large the letters are, in pixels.
struct Letters {
    std::function<double(const std::string& text, LetterSize size)> width;
    double ascent[2];   // by LetterSize: from the top of a line to its baseline
    double descent[2];  // and on to its bottom
};

enum class Weight { plain, bold };

/// Pixels from where a formula begins on its baseline; y downward.
struct FormulaText {
    double x = 0.0;
    double y = 0.0;  // of its own baseline
    std::string text;
    LetterSize size = LetterSize::normal;
    Weight weight = Weight::plain;
};

/// Of a fraction.
struct FormulaRule {
    double begin = 0.0;
    double end = 0.0;
    double y = 0.0;
};

struct Formula {
    double width = 0.0;
    double ascent = 0.0;   // above the baseline
    double descent = 0.0;  // below it
    std::vector<FormulaText> texts;
    std::vector<FormulaRule> rules;
};

/// Its lines, for it is broken at each space as wide as a letter M (1em). Knows math, mrow, mi, mn,
/// mo, msub, msup, mfrac, munder and mspace; throws std::invalid_argument for anything else.
std::vector<Formula> formula_lines(const std::string& mathml, const Letters& letters);

}  // namespace scanlight::apps::window
