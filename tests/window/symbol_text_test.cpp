#include "apps/demo/window/symbol_text.h"

#include <gtest/gtest.h>

#include "apps/demo/lesson.h"
#include "apps/demo/texts.h"

namespace scanlight::apps::window {
namespace {

using Words = std::vector<std::string>;

std::string joined(const Words& words) {
    std::string text;
    for (const std::string& word : words)
        text += word;
    return text;
}

TEST(SymbolText, WhatFollowsALineIsLow) {
    using enum SymbolPiece::Place;
    EXPECT_EQ(pieces_of("x"), (std::vector<SymbolPiece>{{"x", on_line}}));
    EXPECT_EQ(pieces_of("K_s'"),
              (std::vector<SymbolPiece>{{"K", on_line}, {"s", low}, {"'", on_line}}));
    EXPECT_EQ(pieces_of("n_eye："),
              (std::vector<SymbolPiece>{{"n", on_line}, {"eye", low}, {"：", on_line}}));
}

TEST(SymbolText, LinesBreakBetweenWords) {
    EXPECT_EQ(words_of("x_y: where an edge"), (Words{"x_y: ", "where ", "an ", "edge"}));
    EXPECT_EQ(words_of(""), (Words{""}));
}

TEST(SymbolText, ChineseBreaksAnywhereButBeforeAMarkThatCloses) {
    EXPECT_EQ(words_of("x_y：边与 y 交。"), (Words{"x_y：", "边", "与 ", "y ", "交。"}));
    EXPECT_EQ(words_of("相交处（x_a、x_b）的"),
              (Words{"相", "交", "处", "（x_a、", "x_b）", "的"}));
}

TEST(SymbolText, NoLetterIsLost) {
    for (const demo::Lesson& lesson : demo::lessons()) {
        for (const auto language : {demo::Language::english, demo::Language::chinese}) {
            const std::string& text = demo::texts().of(lesson.name, "letters", language);
            EXPECT_EQ(joined(words_of(text)), text);
        }
    }
}

}  // namespace
}  // namespace scanlight::apps::window
