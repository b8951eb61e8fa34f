#include "apps/demo/report.h"

#include <algorithm>
#include <vector>

#include "apps/demo/settings.h"
#include "apps/scanlight/text_table.h"

namespace scanlight::demo {

namespace {

/// What some lessons add to their formula.
std::string remark_text(const Lesson& lesson, Language language) {
    const auto* remark = texts().find(lesson.name, "remark", language);
    return remark == nullptr ? "" : *remark + "\n\n";
}

std::string controls_text(const Lesson& lesson, const Settings& settings, Language language) {
    std::string text;
    for (const Control& control : lesson.controls) {
        text += "  --set " + control.name + "=" + text_of(control, settings) + "   " +
                texts().of(lesson.name, "control-" + control.name, language) + "\n";
    }
    return text;
}

std::string numbers_text(const Lesson& lesson, const Screen& screen, Language language) {
    std::string text;
    for (const Number& number : screen.numbers) {
        text += "  " + texts().of(lesson.name, number.key, language) + ": " +
                apps::fixed(number.value, number.digits) +
                (number.unit.empty() ? "" : " " + number.unit) + "\n";
    }
    return text;
}

std::string table_text(const Lesson& lesson, const Table& table, Language language) {
    const auto words = [&](std::vector<std::string> cells) {
        for (std::string& cell : cells)
            cell = texts().filled(cell, lesson.name, language);
        return cells;
    };
    apps::TextTable text(words(table.columns));
    for (const auto& row : table.rows)
        text.add_row(words(row));
    return texts().of(lesson.name, table.key, language) + "\n" + text.text("  ") + "\n";
}

std::string commands_text(const Screen& screen) {
    std::string text;
    for (const Panel& panel : screen.panels)
        text += panel.command + "\n";
    return text;
}

std::string places_text(const Lesson& lesson, Language language) {
    std::string text = texts().of("page", "source-head", language) + ":\n";
    for (const SourcePlace& place : lesson.places)
        text += "  " + place.file + ": " + place.function + "\n";
    return text + "\n";
}

std::string files_text(const Lesson& lesson, Language language) {
    std::string text;
    for (const BroughtFile& file : lesson.files)
        text += "\n" + texts().of("page", "file-head", language) + " " + file.path + "\n\n" +
                std::string(file.content);
    return text;
}

}  // namespace

std::string list_text(Language language) {
    std::string text;
    for (const Lesson& lesson : lessons()) {
        const std::string gap(18 - std::min<std::size_t>(17, lesson.name.size()), ' ');
        text += lesson.name + gap + texts().of(lesson.name, "title", language) + "\n";
    }
    return text;
}

std::string lesson_text(const Lesson& lesson, const Settings& settings, const Screen& screen,
                        Language language) {
    const auto words = [&](const std::string& key) {
        return texts().of(lesson.name, key, language) + "\n\n";
    };
    std::string text = words("title") + words("intro") + words("notice") + words("question") +
                       words("answer") + words("letters") + remark_text(lesson, language) +
                       controls_text(lesson, settings, language) + "\n" +
                       numbers_text(lesson, screen, language) + "\n" +
                       places_text(lesson, language);
    for (const Table& table : screen.tables)
        text += table_text(lesson, table, language);
    return text + commands_text(screen) + files_text(lesson, language);
}

}  // namespace scanlight::demo
