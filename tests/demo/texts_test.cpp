// The one table of words: each that a lesson shows is there, in both languages.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "apps/demo/lesson.h"
#include "apps/demo/settings.h"
#include "apps/demo/texts.h"
#include "tests/demo/all_screens.h"

namespace scanlight::demo {
namespace {

using Keys = std::set<std::string>;

void add_template(Keys& keys, const std::string& text) {
    for (std::size_t at = text.find("{{"); at != std::string::npos; at = text.find("{{", at + 2))
        keys.insert(text.substr(at + 2, text.find("}}", at) - at - 2));
}

void add_controls(Keys& keys, const Lesson& lesson) {
    for (const Control& control : lesson.controls) {
        keys.insert("control-" + control.name);
        if (const auto* choice = std::get_if<Choice>(&control.kind)) {
            for (const std::string& word : choice->words)
                keys.insert("word-" + word);
        }
    }
}

void add_plots(Keys& keys, const Screen& screen) {
    for (const Plot& plot : screen.plots) {
        keys.insert({plot.key, plot.x.key, plot.y.key});
        for (const Curve& curve : plot.curves)
            keys.insert(curve.key);
    }
}

void add_tables(Keys& keys, const Screen& screen) {
    for (const Table& table : screen.tables) {
        keys.insert(table.key);
        for (const std::string& column : table.columns)
            add_template(keys, column);
        for (const auto& row : table.rows) {
            for (const std::string& cell : row)
                add_template(keys, cell);
        }
    }
}

void add_screen(Keys& keys, const Screen& screen) {
    for (const Panel& panel : screen.panels)
        keys.insert(panel.key);
    for (const Number& number : screen.numbers)
        keys.insert(number.key);
    add_plots(keys, screen);
    add_tables(keys, screen);
}

/// All that a lesson says, wherever its controls stand.
Keys keys_of(const Lesson& lesson) {
    Keys keys{"title", "intro", "notice", "question", "answer", "letters"};
    add_controls(keys, lesson);
    for (const Settings& settings : ends_of_controls(lesson))
        add_screen(keys, lesson.draw(settings, small_panel, one_thread));
    return keys;
}

class TextsOf : public testing::TestWithParam<Lesson> {};

TEST_P(TextsOf, EachKeyIsThereInBothLanguages) {
    const Lesson& lesson = GetParam();
    for (const std::string& key : keys_of(lesson)) {
        for (const Language language : {Language::english, Language::chinese})
            EXPECT_NO_THROW(texts().of(lesson.name, key, language)) << key;
    }
    EXPECT_NE(texts().chapters().at(lesson.name).formula.find("<math"), std::string::npos);
}

TEST_P(TextsOf, NoWordIsLeftOver) {
    const Lesson& lesson = GetParam();
    Keys used = keys_of(lesson);
    used.insert("end");     // of a shadow volume, which few rays meet
    used.insert("remark");  // of some lessons
    for (const auto& [key, text] : texts().chapters().at(lesson.name).english)
        EXPECT_TRUE(used.contains(key)) << key;
}

INSTANTIATE_TEST_SUITE_P(Lessons, TextsOf, testing::ValuesIn(lessons()), lesson_test_name);

/// The programs of the demo: its C++ and its scripts.
std::string all_sources() {
    std::string text;
    using Folder = std::filesystem::recursive_directory_iterator;
    for (const auto& entry : Folder(SCANLIGHT_TESTS_DIR "/../apps/demo")) {
        const auto kind = entry.path().extension();
        if (kind != ".cpp" && kind != ".js") continue;
        std::ifstream file(entry.path());
        text.append(std::istreambuf_iterator<char>(file), {});
    }
    return text;
}

TEST(Texts, NoCommonWordIsLeftOver) {
    const std::string sources = all_sources();
    for (const char* name : {"page", "common"}) {
        for (const auto& [key, text] : texts().chapters().at(name).english)
            EXPECT_NE(sources.find("\"" + key + "\""), std::string::npos) << name << ": " << key;
    }
}

TEST(Texts, BothLanguagesHaveTheSameKeys) {
    for (const auto& [name, chapter] : texts().chapters()) {
        Keys english, chinese;
        for (const auto& [key, text] : chapter.english)
            english.insert(key);
        for (const auto& [key, text] : chapter.chinese)
            chinese.insert(key);
        EXPECT_EQ(english, chinese) << name;
    }
}

TEST(Texts, EveryChapterIsALesson) {
    std::set<std::string> names{"page", "common"};
    for (const Lesson& lesson : lessons())
        names.insert(lesson.name);
    for (const auto& [name, chapter] : texts().chapters())
        EXPECT_TRUE(names.contains(name)) << name;
}

TEST(Texts, TemplatesAreFilled) {
    EXPECT_EQ(texts().filled("a {{flat}} b {{phong}}.", "mach-bands", Language::english),
              "a Flat b Phong.");
    EXPECT_THROW(texts().of("mach-bands", "no such key", Language::english), std::out_of_range);
}

}  // namespace
}  // namespace scanlight::demo
