#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace scanlight::mesh {

/// What there is to say of a file, for a person: each sentence once, with where it was first true
/// and how often it was; at most twenty different ones.
template <class Where>
class Sentences {
public:
    struct Entry {
        std::string sentence;
        Where first;
        std::size_t count;
    };

    void add(const Where& where, const std::string& sentence) {
        const auto known = std::ranges::find(entries_, sentence, &Entry::sentence);
        if (known != entries_.end()) {
            ++known->count;
        } else if (entries_.size() < most) {
            entries_.push_back({sentence, where, 1});
        }
    }

    auto begin() const { return entries_.begin(); }
    auto end() const { return entries_.end(); }

private:
    static constexpr std::size_t most = 20;

    std::vector<Entry> entries_;
};

}  // namespace scanlight::mesh
