// How fast mesh files are read: ours, OpenMesh's reader and tinyobjloader, in turns in one run.
// Each reading is a process of its own, so that its peak memory is its own too.

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <nlohmann/json.hpp>

#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include "mesh/build.h"
#include "mesh/load.h"

namespace {

using scanlight::mesh::build;
using scanlight::mesh::load;

constexpr std::uint32_t columns = 1000;
constexpr std::uint32_t rows = 500;
constexpr std::uint32_t triangles = 2 * columns * rows;

using Triangle = std::array<std::uint32_t, 3>;
using Point = std::array<float, 3>;

/// Hilly ground, its points shaken so that no coordinate is short to write.
std::vector<Point> ground_points() {
    std::mt19937 random(1);
    const auto shake = [&] { return static_cast<float>(random() % 1000000) * 1e-7f; };
    std::vector<Point> points;
    for (std::uint32_t row = 0; row <= rows; ++row) {
        for (std::uint32_t column = 0; column <= columns; ++column) {
            points.push_back({static_cast<float>(column) * 0.1f + shake(),
                              static_cast<float>(row) * 0.1f + shake(), shake()});
        }
    }
    return points;
}

std::vector<Triangle> ground_triangles() {
    std::vector<Triangle> faces;
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t a = row * (columns + 1) + column;
            const std::uint32_t b = a + columns + 1;
            faces.push_back({a, a + 1, b});
            faces.push_back({b, a + 1, b + 1});
        }
    }
    return faces;
}

template <class Number>
void append(std::string& text, Number number) {
    char digits[32];
    const auto written = std::to_chars(std::begin(digits), std::end(digits), number);
    text.append(" ").append(digits, written.ptr);
}

std::string ground_obj() {
    std::string text;
    for (const Point& point : ground_points()) {
        text += "v";
        for (const float value : point)
            append(text, value);
        text += "\n";
    }
    for (const Triangle& face : ground_triangles()) {
        text += "f";
        for (const std::uint32_t corner : face)
            append(text, corner + 1);
        text += "\n";
    }
    return text;
}

std::string ground_ply() {
    const std::vector<Point> points = ground_points();
    const std::vector<Triangle> faces = ground_triangles();
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(points.size()) +
        "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
        std::to_string(faces.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
    bytes.append(reinterpret_cast<const char*>(points.data()), points.size() * sizeof(Point));
    for (const Triangle& face : faces) {
        bytes += '\3';
        bytes.append(reinterpret_cast<const char*>(face.data()), sizeof(Triangle));
    }
    return bytes;
}

void expect(bool right, const std::string& reader) {
    if (!right) throw std::runtime_error(reader + " did not read the whole mesh");
}

void read_with_scanlight(const std::string& path) {
    expect(load(path).face_count() == triangles, "scanlight");
}

void read_and_build(const std::string& path) {
    expect(build(load(path)).report.drawn == triangles, "scanlight's build");
}

void read_with_openmesh(const std::string& path) {
    OpenMesh::PolyMesh_ArrayKernelT<> mesh;
    OpenMesh::IO::read_mesh(mesh, path);
    expect(mesh.n_faces() == triangles, "OpenMesh");
}

void read_with_tinyobjloader(const std::string& path) {
    tinyobj::ObjReader reader;
    tinyobj::ObjReaderConfig config;
    config.triangulate = false;
    reader.ParseFromFile(path, config);
    expect(reader.GetShapes().at(0).mesh.num_face_vertices.size() == triangles, "tinyobjloader");
}

struct Sample {
    double seconds;
    double peak_mib;
};

using Read = std::function<void(const std::string&)>;

[[noreturn]] void time_in_child(const Read& read, const std::string& path, int answer) {
    const auto start = std::chrono::steady_clock::now();
    int code = EXIT_SUCCESS;
    try {
        read(path);
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        code = EXIT_FAILURE;
    }
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    const double seconds = elapsed.count();
    if (::write(answer, &seconds, sizeof seconds) != sizeof seconds) code = EXIT_FAILURE;
    ::_exit(code);
}

/// Linux counts `ru_maxrss` in KiB.
Sample measure(const Read& read, const std::string& path) {
    int ends[2];
    if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("no process");
    if (child == 0) time_in_child(read, path, ends[1]);
    ::close(ends[1]);
    double seconds = 0;
    const bool answered = ::read(ends[0], &seconds, sizeof seconds) == sizeof seconds;
    ::close(ends[0]);
    int status = 0;
    rusage usage{};
    ::wait4(child, &status, 0, &usage);
    if (!answered || status != 0) throw std::runtime_error("a reader failed on " + path);
    return {seconds, static_cast<double>(usage.ru_maxrss) / 1024};
}

struct Contender {
    std::string format;
    std::string reader;
    std::string path;
    Read read;
    std::vector<Sample> samples;

    double median_seconds() const { return median(&Sample::seconds); }
    double median_peak_mib() const { return median(&Sample::peak_mib); }

private:
    double median(double Sample::*number) const {
        std::vector<double> values;
        for (const Sample& sample : samples)
            values.push_back(sample.*number);
        std::ranges::sort(values);
        return values[values.size() / 2];
    }
};

/// A folder for the files of one run.
class Folder {
public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "scanlight-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
        path_ = name;
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::string put(const std::string& name, const std::string& bytes) const {
        const std::string path = (path_ / name).string();
        std::ofstream(path, std::ios::binary) << bytes;
        return path;
    }

private:
    std::filesystem::path path_;
};

/// Scanlight's own reader stands first of each format: the ratios are to it.
std::vector<Contender> contenders(const std::string& ply, const std::string& obj) {
    return {
        {"PLY", "scanlight", ply, read_with_scanlight, {}},
        {"PLY", "OpenMesh", ply, read_with_openmesh, {}},
        {"PLY", "scanlight, half-edges and normals too", ply, read_and_build, {}},
        {"OBJ", "scanlight", obj, read_with_scanlight, {}},
        {"OBJ", "OpenMesh", obj, read_with_openmesh, {}},
        {"OBJ", "tinyobjloader", obj, read_with_tinyobjloader, {}},
        {"OBJ", "scanlight, half-edges and normals too", obj, read_and_build, {}},
    };
}

double ratio_to_ours(const Contender& contender, const std::vector<Contender>& all) {
    const auto ours = std::ranges::find(all, contender.format, &Contender::format);
    return contender.median_seconds() / ours->median_seconds();
}

void print(const std::vector<Contender>& all, int rounds) {
    std::printf("Reading %u triangles; medians of %d rounds, readers in turns\n\n", triangles,
                rounds);
    std::printf("%-7s %-40s %9s %8s %9s\n", "format", "reader", "seconds", "ratio", "peak MiB");
    for (const Contender& contender : all) {
        std::printf("%-7s %-40s %9.3f %8.2f %9.0f\n", contender.format.c_str(),
                    contender.reader.c_str(), contender.median_seconds(),
                    ratio_to_ours(contender, all), contender.median_peak_mib());
    }
}

nlohmann::json as_json(const std::vector<Contender>& all, int rounds) {
    nlohmann::json result{{"triangles", triangles}, {"rounds", rounds}};
    for (const Contender& contender : all) {
        result["readers"].push_back({{"format", contender.format},
                                     {"reader", contender.reader},
                                     {"seconds", contender.median_seconds()},
                                     {"ratio", ratio_to_ours(contender, all)},
                                     {"peak_mib", contender.median_peak_mib()}});
    }
    return result;
}

void run(int rounds, const std::string& json_path) {
    const Folder folder;
    const std::string ply = folder.put("ground.ply", ground_ply());
    const std::string obj = folder.put("ground.obj", ground_obj());
    std::vector<Contender> all = contenders(ply, obj);
    for (int round = 0; round < rounds; ++round) {
        for (Contender& contender : all) {
            contender.samples.push_back(measure(contender.read, contender.path));
        }
    }
    print(all, rounds);
    if (!json_path.empty()) std::ofstream(json_path) << as_json(all, rounds).dump(2) << "\n";
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Measures how fast mesh files are read", "scanlight-bench-load");
    int rounds = 7;
    std::string json_path;
    app.add_option("--rounds", rounds, "Times each reader reads")->check(CLI::Range(1, 1000));
    app.add_option("--json", json_path, "Also write the numbers to this file");
    CLI11_PARSE(app, argc, argv);
    try {
        run(rounds, json_path);
    } catch (const std::exception& error) {
        std::cerr << "scanlight-bench-load: " << error.what() << "\n";
        return 2;
    }
}
