#include <cstdint>
#include <exception>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tests/same_bits/hash.h"
#include "tests/same_bits/test_scene.h"
#include "tests/same_bits/ways.h"

// Prints two hashes of each scene, or compares all ways to draw it with hashes on record: one of
// its colours and depths, one of what its shadows count in the stencil; without shadows, of
// nothing.

namespace scanlight::same_bits {

namespace {

struct Hashes {
    std::uint64_t picture = 0;
    std::uint64_t stencils = 0;

    friend bool operator==(const Hashes&, const Hashes&) = default;
};

using Record = std::map<std::string, Hashes>;

Hashes hashes_of(const TestScene& test, auto&... way) {
    return {hash_of(draw(test, way...).framebuffer), hash_of(count_shadows(test, way...))};
}

std::string text_of(const Hashes& hashes) {
    std::ostringstream text;
    text << std::hex << std::setfill('0') << std::setw(16) << hashes.picture << ' ' << std::setw(16)
         << hashes.stencils;
    return text.str();
}

void print_hashes() {
    for (const auto& [name, make] : all_scenes())
        std::cout << text_of(hashes_of(make())) << ' ' << name << '\n';
}

Record read_hashes(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error(path + ": can't be read");
    Record record;
    std::string name;
    Hashes hashes;
    while (file >> std::hex >> hashes.picture >> hashes.stencils >> name)
        record[name] = hashes;
    if (!file.eof()) throw std::runtime_error(path + ": not lines of two hashes and a name");
    return record;
}

/// Compares pictures with the hashes on record, and keeps the number of those that differ.
class Check {
public:
    explicit Check(Record recorded) : recorded_(std::move(recorded)) {}

    void scene(const NamedScene& scene) {
        const auto found = recorded_.find(scene.name);
        if (found == recorded_.end()) return complain(scene.name, "not on record");
        const TestScene test = scene.make();
        compare(scene.name, "the scanline walk", hashes_of(test), found->second);
        for (render::Renderer& renderer : renderers_)
            compare(scene.name, name_of(renderer), hashes_of(test, renderer), found->second);
        recorded_.erase(found);
    }

    /// Nothing on record may be left over.
    void finish() {
        for (const auto& [name, hashes] : recorded_)
            complain(name, "on record, but no scene");
    }

    int faults() const { return faults_; }

private:
    void compare(const std::string& scene, const std::string& way, const Hashes& hashes,
                 const Hashes& recorded) {
        if (hashes == recorded) return;
        complain(scene, way + " gives " + text_of(hashes) + " instead of " + text_of(recorded));
    }
    void complain(const std::string& scene, const std::string& fault) {
        ++faults_;
        std::cout << scene << ": " << fault << '\n';
    }

    Record recorded_;
    std::vector<render::Renderer> renderers_ = renderers(thread_counts);
    int faults_ = 0;
};

/// One line: what was compared, and the outcome.
void print_summary(std::size_t scenes, int faults) {
    std::cout << "scalar";
    for (const std::string_view set : render::instruction_sets())
        std::cout << ' ' << set;
    std::cout << " | ";
    for (const int threads : thread_counts)
        std::cout << threads << ' ';
    std::cout << "| " << scenes << " | "
              << (faults == 0 ? "same bits" : std::to_string(faults) + " DIFFERENT") << '\n';
}

int check(const std::string& path) {
    Check check(read_hashes(path));
    const NamedScenes scenes = all_scenes();
    for (const NamedScene& scene : scenes)
        check.scene(scene);
    check.finish();
    print_summary(scenes.size(), check.faults());
    return check.faults() == 0 ? 0 : 1;
}

int run(const std::vector<std::string>& arguments) {
    if (arguments.size() == 2 && arguments[0] == "--check") return check(arguments[1]);
    if (!arguments.empty()) throw std::runtime_error("usage: scanlight-same-bits [--check FILE]");
    print_hashes();
    return 0;
}

}  // namespace

}  // namespace scanlight::same_bits

int main(int argc, char** argv) {
    try {
        return scanlight::same_bits::run({argv + 1, argv + argc});
    } catch (const std::exception& error) {
        std::cerr << "scanlight-same-bits: " << error.what() << '\n';
        return 2;
    }
}
