// What hostile files have in common, whatever their format.

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "tests/mesh/reading.h"
#include "tests/mesh/soup_invariants.h"
#include "tests/raster/temporary_folder.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SCANLIGHT_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define SCANLIGHT_SANITIZED
#endif
#endif

namespace scanlight::mesh {
namespace {

/// The seeds of the fuzzers use every feature of their format.
struct Seed {
    const char* ending;
    const char* name;
};

constexpr Seed seeds[] = {{"obj", "forms.obj"},  {"obj", "cr.obj"},     {"mtl", "all.mtl"},
                          {"ply", "ascii.ply"},  {"ply", "little.ply"}, {"ply", "big.ply"},
                          {"off", "plain.off"},  {"off", "all.off"},    {"off", "grown.off"},
                          {"stl", "binary.stl"}, {"stl", "text.stl"}};

std::string contents(const Seed& seed) {
    return raster::contents_of(std::string(SCANLIGHT_TESTS_DIR) + "/fuzz/seeds/" + seed.ending +
                               "/" + seed.name);
}

TEST(BadInput, SeedsAreWhole) {
    for (const Seed& seed : seeds) {
        const std::string bytes = contents(seed);
        ASSERT_FALSE(bytes.empty()) << seed.name;
        EXPECT_EQ(read_error(seed.ending, bytes), "") << seed.name;
    }
}

TEST(BadInput, TruncationAtAnyByteGivesAnErrorOrAWholeMesh) {
    for (const Seed& seed : seeds) {
        const std::string bytes = contents(seed);
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            // A copy of its own, so that reading past its end is seen by AddressSanitizer.
            const std::vector<char> part(bytes.begin(),
                                         bytes.begin() + static_cast<std::ptrdiff_t>(size));
            try {
                const PolygonSoup soup = read(seed.ending, {part.data(), part.size()});
                EXPECT_EQ(broken_promise(soup), "") << seed.name << " cut at " << size;
            } catch (const FileError& error) {
                EXPECT_TRUE(std::string_view(error.what()).starts_with("file")) << error.what();
            }
        }
    }
}

TEST(BadInput, TruncatedBinaryFilesAreNeverTakenAsWhole) {
    for (const Seed& seed :
         {Seed{"ply", "little.ply"}, Seed{"ply", "big.ply"}, Seed{"stl", "binary.stl"}}) {
        const std::string bytes = contents(seed);
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            EXPECT_NE(read_error(seed.ending, bytes.substr(0, size)), "")
                << seed.name << " " << size;
        }
    }
}

struct Field {
    const char* ending;
    std::string before;
    std::string after;
};

std::vector<Field> number_fields() {
    const std::string coordinates = "property float x\nproperty float y\nproperty float z\n";
    const std::string vertex = "element vertex 1\n" + coordinates;
    const auto ply = [](const std::string& declarations, const std::string& body) {
        return text_ply(declarations, body);
    };
    const std::string all =
        vertex +
        "property float nx\nproperty float ny\nproperty float nz\nproperty float "
        "red\nproperty float green\nproperty float blue\nproperty double s\n"
        "property double t\n";
    const std::string face =
        "element vertex 1\n" + coordinates +
        "element face 1\nproperty list uchar int vertex_indices\nproperty float "
        "red\nproperty float green\nproperty float blue\n";
    const std::string facet = "solid\nfacet normal 0 0 1\nouter loop\nvertex ";
    const std::string tail = "\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n";
    return {
        {"obj", "v ", " 0 0\n"},
        {"obj", "v 0 ", " 0\n"},
        {"obj", "v 0 0 ", "\n"},
        {"obj", "v 0 0 0 ", " 0 0\n"},
        {"obj", "v 0 0 0 0 ", " 0\n"},
        {"obj", "v 0 0 0 0 0 ", "\n"},
        {"obj", "vn ", " 0 1\n"},
        {"obj", "vn 0 ", " 1\n"},
        {"obj", "vn 0 0 ", "\n"},
        {"obj", "vt ", " 0\n"},
        {"obj", "vt 0 ", "\n"},
        {"obj", "v 0 0 0 ", "\n"},
        {"mtl", "newmtl a\nKa ", " 0 0\n"},
        {"mtl", "newmtl a\nKd 0 ", " 0\n"},
        {"mtl", "newmtl a\nKs 0 0 ", "\n"},
        {"mtl", "newmtl a\nNs ", "\n"},
        {"mtl", "newmtl a\nNi ", "\n"},
        {"mtl", "newmtl a\nd ", "\n"},
        {"mtl", "newmtl a\nTr ", "\n"},
        {"mtl", "newmtl a\nKd ", "\n"},
        {"ply", ply(vertex, ""), " 0 0\n"},
        {"ply", ply(vertex, "0 "), " 0\n"},
        {"ply", ply(vertex, "0 0 "), "\n"},
        {"ply", ply(all, "0 0 0 "), " 0 1 0 0 0 0 0\n"},
        {"ply", ply(all, "0 0 0 0 "), " 1 0 0 0 0 0\n"},
        {"ply", ply(all, "0 0 0 0 0 "), " 0 0 0 0 0\n"},
        {"ply", ply(all, "0 0 0 0 0 1 "), " 0 0 0 0\n"},
        {"ply", ply(all, "0 0 0 0 0 1 0 "), " 0 0 0\n"},
        {"ply", ply(all, "0 0 0 0 0 1 0 0 "), " 0 0\n"},
        {"ply", ply(all, "0 0 0 0 0 1 0 0 0 "), " 0\n"},
        {"ply", ply(all, "0 0 0 0 0 1 0 0 0 0 "), "\n"},
        {"ply", ply(face, "0 0 0\n1 0 "), " 0 0\n"},
        {"ply", ply(face, "0 0 0\n1 0 0 "), " 0\n"},
        {"ply", ply(face, "0 0 0\n1 0 0 0 "), "\n"},
        {"off", "OFF\n1 0\n", " 0 0\n"},
        {"off", "OFF\n1 0\n0 ", " 0\n"},
        {"off", "OFF\n1 0\n0 0 ", "\n"},
        {"off", "NOFF\n1 0\n0 0 0 ", " 0 1\n"},
        {"off", "COFF\n1 0\n0 0 0 ", " 0 1.0\n"},
        {"off", "COFF\n1 0\n0 0 0 0 ", " 0.0 1\n"},
        {"off", "STOFF\n1 0\n0 0 0 ", " 0\n"},
        {"off", "OFF\n1 1\n0 0 0\n1 0 ", " 0.0 0\n"},
        {"off", "OFF\n1 1\n0 0 0\n1 0 0 0.5 ", "\n"},
        {"stl", facet, " 0 0" + tail},
        {"stl", facet + "0 ", " 0" + tail},
        {"stl", facet + "0 0 ", tail},
    };
}

TEST(BadInput, NumbersThatAreNotFiniteAreRefusedInEveryField) {
    for (const Field& field : number_fields()) {
        for (const char* number :
             {"nan", "-nan", "NAN", "inf", "-inf", "Infinity", "1e39", "-1e39", "1e400"}) {
            const std::string bytes = field.before + number + field.after;
            EXPECT_NE(read_error(field.ending, bytes), "") << field.ending << ": " << bytes;
        }
    }
}

TEST(BadInput, LargeAndTinyNumbersAreTaken) {
    for (const Field& field : number_fields()) {
        for (const char* number : {"1e38", "-3.4e38", "1e-45", "1e-50", "-0", "0.5"}) {
            const std::string bytes = field.before + number + field.after;
            EXPECT_EQ(read_error(field.ending, bytes), "") << field.ending << ": " << bytes;
        }
    }
}

std::vector<std::pair<const char*, std::string>> files_with_false_counts() {
    std::vector<std::pair<const char*, std::string>> files;
    const std::string three = "0 0 0\n1 0 0\n0 1 0\n";
    for (const std::string count : {"4", "1000", "2147483647", "4000000000", "4294967295",
                                    "4294967296", "999999999999", "9223372036854775807"}) {
        files.emplace_back("off", "OFF\n" + count + " 0 0\n" + three);
        files.emplace_back("off", "OFF\n3 " + count + " 0\n" + three + "3 0 1 2\n");
        files.emplace_back("off", "OFF\n3 1 0\n" + three + count + " 0 1 2\n");
        files.emplace_back("ply",
                           text_ply("element vertex " + count +
                                        "\nproperty float x\nproperty float y\nproperty float z\n",
                                    three));
        files.emplace_back("ply", text_ply(ply_points + "element face " + count +
                                               "\nproperty list uchar int vertex_indices\n",
                                           ply_triangle));
        files.emplace_back(
            "ply", text_ply(ply_points + "element face 1\nproperty list uint int vertex_indices\n",
                            three + count + " 0 1 2\n"));
        files.emplace_back(
            "ply", text_ply("element odd " + count + "\nproperty list uint int l\n", "1 1\n"));
        for (const char* order : {"little", "big"}) {
            const std::string start = std::string("ply\nformat binary_") + order + "_endian 1.0\n";
            files.emplace_back(
                "ply",
                start + "element vertex " + count +
                    "\nproperty char x\nproperty char y\nproperty char z\nend_header\n012345678");
            files.emplace_back("ply", start + "element face " + count +
                                          "\nproperty list uchar char vertex_index\nend_header\n" +
                                          std::string(3, '\0'));
        }
    }
    for (const std::uint32_t count : {2u, 1000u, 85899346u, 0x7fffffffu, 0xffffffffu}) {
        files.emplace_back("stl", binary_stl(count, stl_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0})));
    }
    return files;
}

TEST(BadInput, CountsThatTheBytesCannotHoldAreRefused) {
    const auto files = files_with_false_counts();
    ASSERT_GE(files.size(), 40u);
    for (const auto& [ending, bytes] : files)
        EXPECT_NE(read_error(ending, bytes), "") << bytes;
}

#ifndef SCANLIGHT_SANITIZED  // whose shadow memory is beyond any such bound
std::size_t address_space() {
    std::ifstream status("/proc/self/statm");
    std::size_t pages = 0;
    status >> pages;
    return pages * 4096;
}

/// Reads in a process of its own that gets no more memory than the bound.
void read_within_bound(const char* ending, const std::string& bytes) {
    const rlim_t bound = address_space() + memory_bound(bytes.size());
    const rlimit limit{bound, bound};
    ::setrlimit(RLIMIT_AS, &limit);
    read_error(ending, bytes);
    std::_Exit(0);
}

std::string repeated(const std::string& text, std::size_t times) {
    std::string result;
    for (std::size_t i = 0; i < times; ++i)
        result += text;
    return result;
}

TEST(BadInputDeathTest, MemoryStaysWithinItsBound) {
    constexpr std::size_t many = 1 << 19;
    std::string names;
    for (std::size_t i = 0; i < many; ++i)
        names += "usemtl " + std::to_string(i) + "\n";
    const std::string empty_faces =
        "ply\nformat binary_little_endian 1.0\nelement face " + std::to_string(many) +
        "\nproperty list uchar char vertex_index\nproperty uchar red\nproperty uchar green\n"
        "property uchar blue\nend_header\n" +
        std::string(4 * many, '\0');
    const std::vector<std::pair<const char*, std::string>> files{
        {"obj", repeated("f\n", many)},
        {"obj", "v 0 0 0\nf" + repeated(" 1", many)},
        {"obj", names},
        {"obj", repeated("mtllib a\n", many)},
        {"obj", repeated("?\n", many)},
        {"mtl", repeated("newmtl a\n", many)},
        {"ply", empty_faces},
        {"off", "OFF\n0 " + std::to_string(many) + " 0\n" + repeated("0\n", many)},
    };
    for (const auto& [ending, bytes] : files) {
        EXPECT_EXIT(read_within_bound(ending, bytes), testing::ExitedWithCode(0), "")
            << bytes.substr(0, 60);
    }
    for (const auto& [ending, bytes] : files_with_false_counts()) {
        EXPECT_EXIT(read_within_bound(ending, bytes), testing::ExitedWithCode(0), "") << bytes;
    }
}
#endif

}  // namespace
}  // namespace scanlight::mesh
