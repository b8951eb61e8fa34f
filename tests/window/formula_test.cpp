#include "apps/demo/window/formula.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "apps/demo/lesson.h"
#include "apps/demo/texts.h"

namespace scanlight::apps::window {
namespace {

/// Ten pixels a byte, five where they are low.
Letters letters() {
    const auto width = [](const std::string& text, LetterSize size) {
        return static_cast<double>(text.size()) * (size == LetterSize::normal ? 10.0 : 5.0);
    };
    return {width, {12.0, 8.0}, {4.0, 2.0}};
}

Formula only_line(const std::string& inner) {
    const auto lines = formula_lines("<math>" + inner + "</math>", letters());
    EXPECT_EQ(lines.size(), 1u);
    return lines.front();
}

TEST(Formula, ASubscriptIsLowAndBehind) {
    const Formula f = only_line("<msub><mi>I</mi><mi>a</mi></msub>");
    ASSERT_EQ(f.texts.size(), 2u);
    EXPECT_EQ(f.texts[1].text, "a");
    EXPECT_EQ(f.texts[1].size, LetterSize::low);
    EXPECT_EQ(f.texts[1].x, 10.0);
    EXPECT_GT(f.texts[1].y, 0.0);
    EXPECT_EQ(f.width, 15.0);
}

TEST(Formula, AFractionHasItsLineBetween) {
    const Formula f = only_line("<mfrac><mi>abc</mi><mn>2</mn></mfrac>");
    ASSERT_EQ(f.rules.size(), 1u);
    EXPECT_LT(f.texts[0].y + 4.0, f.rules[0].y);
    EXPECT_GT(f.texts[1].y - 12.0, f.rules[0].y);
    EXPECT_NEAR(f.texts[0].x + 15.0, f.texts[1].x + 5.0, 1e-9);  // above its middle
    EXPECT_GE(f.ascent, 4.0 - f.texts[0].y);
}

TEST(Formula, VectorsAreBold) {
    EXPECT_EQ(only_line("<mi mathvariant=\"bold\">N</mi>").texts[0].weight, Weight::bold);
    EXPECT_EQ(only_line("<mi>N</mi>").texts[0].weight, Weight::plain);
}

TEST(Formula, WhatItDoesNotKnowIsSaid) {
    EXPECT_THROW(only_line("<msqrt><mi>x</mi></msqrt>"), std::invalid_argument);
    EXPECT_THROW(formula_lines("<math>", letters()), std::invalid_argument);
}

/// Everything between tags, without blanks; the one entity there is as it is read.
std::string letters_of(const std::string& mathml) {
    std::string text;
    bool is_tag = false;
    for (const char c : mathml) {
        if (c == '<') is_tag = true;
        if (!is_tag && c != ' ') text += c;
        if (c == '>') is_tag = false;
    }
    const std::size_t less = text.find("&lt;");
    return less == std::string::npos ? text : text.replace(less, 4, "<");
}

TEST(Formula, ThoseOfTheCourseKeepEachLetter) {
    for (const demo::Lesson& lesson : demo::lessons()) {
        const std::string& mathml = demo::texts().chapters().at(lesson.name).formula;
        std::string shown;
        for (const Formula& line : formula_lines(mathml, letters())) {
            for (const FormulaText& text : line.texts)
                shown += text.text;
            for (const FormulaText& text : line.texts)
                EXPECT_LE(text.x, line.width) << lesson.name;
        }
        EXPECT_EQ(shown, letters_of(mathml)) << lesson.name;
    }
}

}  // namespace
}  // namespace scanlight::apps::window
