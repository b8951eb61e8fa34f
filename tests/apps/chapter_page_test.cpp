// docs/chapter.md, the chapter row by row: what its rows name is there.

#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/apps/shell.h"

namespace scanlight::apps {
namespace {

namespace fs = std::filesystem;

fs::path house() {
    return fs::path(SCANLIGHT_TESTS_DIR).parent_path();
}

std::string page() {
    return contents_of((house() / "docs" / "chapter.md").string());
}

/// The parts of a text that stand between `open` and the next `close`.
std::vector<std::string> all_between(const std::string& text, const std::string& open,
                                     const std::string& close) {
    std::vector<std::string> found;
    for (std::size_t at = text.find(open); at != text.npos; at = text.find(open, at)) {
        const std::size_t begin = at + open.size();
        const std::size_t end = text.find(close, begin);
        if (end == text.npos) break;
        found.push_back(text.substr(begin, end - begin));
        at = end + close.size();
    }
    return found;
}

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream in(text);
    return {std::istream_iterator<std::string>(in), {}};
}

/// A line of a table.
struct Row {
    std::string technique, formula, file, test, picture, command;
};

std::vector<std::string> cells_of(const std::string& line) {
    std::istringstream in(line.substr(1));
    std::vector<std::string> cells;
    for (std::string cell; std::getline(in, cell, '|');)
        cells.push_back(cell);
    return cells;
}

std::vector<Row> rows() {
    std::istringstream in(page());
    std::vector<Row> result;
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with("| ") || line.starts_with("| technique ")) continue;
        const auto cells = cells_of(line);
        EXPECT_EQ(cells.size(), 6u) << line;
        if (cells.size() != 6) continue;
        result.push_back({cells[0], cells[1], cells[2], cells[3], cells[4], cells[5]});
    }
    return result;
}

struct Link {
    std::string text;
    fs::path file;
};

/// [text](target), the target as it is seen from the page.
std::vector<Link> links_in(const std::string& text) {
    std::vector<Link> links;
    for (const std::string& link : all_between(text, "[", ")")) {
        const std::size_t middle = link.find("](");
        EXPECT_NE(middle, link.npos) << link;
        if (middle == link.npos) continue;
        const fs::path target = link.substr(middle + 2);
        links.push_back({link.substr(0, middle), (house() / "docs" / target).lexically_normal()});
    }
    return links;
}

TEST(ChapterPage, HasTheTechniquesUpToTextures) {
    EXPECT_EQ(rows().size(), 55u);
}

TEST(ChapterPage, LinksLeadToFiles) {
    for (const Link& link : links_in(page()))
        EXPECT_TRUE(fs::is_regular_file(link.file)) << link.file;
    for (const Row& row : rows())
        EXPECT_FALSE(links_in(row.file).empty()) << row.technique;
}

/// TEST, TEST_F or TEST_P, as clang-format writes it; `name` is "Suite.Name".
bool has_test(const std::string& source, const std::string& name) {
    const std::size_t dot = name.find('.');
    if (dot == name.npos) return false;
    const std::string arguments = "(" + name.substr(0, dot) + ", " + name.substr(dot + 1) + ")";
    for (const std::string macro : {"TEST", "TEST_F", "TEST_P"}) {
        if (source.find("\n" + macro + arguments) != source.npos) return true;
    }
    return false;
}

TEST(ChapterPage, TestsAreInTheirFiles) {
    for (const Row& row : rows()) {
        const auto links = links_in(row.test);
        EXPECT_FALSE(links.empty()) << row.technique;
        for (const Link& link : links) {
            const auto names = all_between(link.text, "`", "`");
            ASSERT_EQ(names.size(), 1u) << link.text << " is no test's name";
            EXPECT_TRUE(has_test(contents_of(link.file.string()), names[0]))
                << link.text << " in " << link.file;
        }
    }
}

TEST(ChapterPage, PicturesAreGoldens) {
    for (const Row& row : rows()) {
        const auto links = links_in(row.picture);
        EXPECT_EQ(links.empty(), row.picture == " - ") << row.technique;
        for (const Link& link : links) {
            const fs::path goldens = house() / "tests" / "goldens";
            const fs::path name = link.text + ".png";
            EXPECT_TRUE(link.file == goldens / name || link.file == goldens / "lessons" / name)
                << link.file;
            EXPECT_TRUE(fs::is_regular_file(link.file)) << link.file;
        }
    }
}

/// Whether a help text has an option, and not only a longer one.
bool has_option(const std::string& help, const std::string& option) {
    constexpr const char* of_names = "abcdefghijklmnopqrstuvwxyz0123456789-";
    for (std::size_t at = help.find(option); at != help.npos; at = help.find(option, at + 1)) {
        const std::size_t end = help.find_first_not_of(of_names, at);
        if (end == at + option.size() && at > 0 && (help[at - 1] == ' ' || help[at - 1] == ','))
            return true;
    }
    return false;
}

/// -o or --option, without its =value; nothing of any other word, such as the number -1.
std::string option_of(const std::string& word) {
    const bool is_option =
        word.size() > 1 && word[0] == '-' && !std::isdigit(static_cast<unsigned char>(word[1]));
    return is_option ? word.substr(0, word.find('=')) : "";
}

TEST(ChapterPage, CommandsAreKnownWithTheirOptions) {
    const Shell shell;
    const std::string verbs = shell.run("scanlight --help").out;
    const std::string dev = contents_of((house() / "dev").string());
    std::map<std::string, std::string> help;
    for (const Row& row : rows()) {
        const auto commands = all_between(row.command, "`", "`");
        EXPECT_FALSE(commands.empty()) << row.technique;
        for (const std::string& command : commands) {
            const auto words = words_of(command);
            ASSERT_GE(words.size(), 2u) << command;
            const std::string& verb = words[1];
            if (words[0] == "./dev") {
                EXPECT_NE(dev.find("\n./dev " + verb + " "), dev.npos) << command;
                continue;
            }
            ASSERT_EQ(words[0], "scanlight") << command;
            ASSERT_NE(verbs.find("\n  " + verb + " "), verbs.npos) << command;
            if (!help.contains(verb)) help[verb] = shell.run("scanlight " + verb + " --help").out;
            for (const std::string& word : words) {
                const std::string option = option_of(word);
                EXPECT_TRUE(option.empty() || has_option(help[verb], option))
                    << option << ": " << command;
            }
        }
    }
}

}  // namespace
}  // namespace scanlight::apps
