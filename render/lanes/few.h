#pragma once

#include <cstddef>
#include <new>
#include <type_traits>

namespace scanlight::render {

/// Up to `most` things, each made where it stays: to copy vectors by the dozen would take its time.
template <class T, int most>
class Few {
public:
    static_assert(std::is_trivially_destructible_v<T>);

    /// There must be room. `make` returns the thing.
    template <class Make>
    void add(Make&& make) {
        ::new (static_cast<void*>(memory_ + static_cast<std::size_t>(count_) * sizeof(T)))
            T(make());
        ++count_;
    }
    bool is_full() const { return count_ == most; }
    int count() const { return count_; }
    const T& operator[](int i) const {
        return *std::launder(
            reinterpret_cast<const T*>(memory_ + static_cast<std::size_t>(i) * sizeof(T)));
    }

private:
    alignas(T) std::byte memory_[most * sizeof(T)];
    int count_ = 0;
};

}  // namespace scanlight::render
