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

// Prints the hash of each scene's picture, or compares all ways to draw it with hashes on record.

namespace scanlight::same_bits {

namespace {

using Hashes = std::map<std::string, std::uint64_t>;

std::string text_of(std::uint64_t hash) {
    std::ostringstream text;
    text << std::hex << std::setw(16) << std::setfill('0') << hash;
    return text.str();
}

void print_hashes() {
    for (const auto& [name, make] : all_scenes())
        std::cout << text_of(hash_of(draw(make()).framebuffer)) << ' ' << name << '\n';
}

Hashes read_hashes(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error(path + ": can't be read");
    Hashes hashes;
    std::string name;
    std::uint64_t hash = 0;
    while (file >> std::hex >> hash >> name)
        hashes[name] = hash;
    if (!file.eof()) throw std::runtime_error(path + ": not lines of a hash and a name");
    return hashes;
}

/// Compares pictures with the hashes on record, and keeps the number of those that differ.
class Check {
public:
    explicit Check(Hashes recorded) : recorded_(std::move(recorded)) {}

    void scene(const NamedScene& scene) {
        const auto found = recorded_.find(scene.name);
        if (found == recorded_.end()) return complain(scene.name, "not on record");
        const TestScene test = scene.make();
        compare(scene.name, "the scanline walk", hash_of(draw(test).framebuffer), found->second);
        for (render::Renderer& renderer : renderers_) {
            const std::uint64_t hash = hash_of(draw(test, renderer).framebuffer);
            compare(scene.name, name_of(renderer), hash, found->second);
        }
        recorded_.erase(found);
    }

    /// Nothing on record may be left over.
    void finish() {
        for (const auto& [name, hash] : recorded_)
            complain(name, "on record, but no scene");
    }

    int faults() const { return faults_; }

private:
    void compare(const std::string& scene, const std::string& way, std::uint64_t hash,
                 std::uint64_t recorded) {
        if (hash == recorded) return;
        complain(scene, way + " gives " + text_of(hash) + " instead of " + text_of(recorded));
    }
    void complain(const std::string& scene, const std::string& fault) {
        ++faults_;
        std::cout << scene << ": " << fault << '\n';
    }

    Hashes recorded_;
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
