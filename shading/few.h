#pragma once

#include <cstddef>
#include <new>
#include <type_traits>

namespace scanlight::shading {

/// How many vectors of numbers go through a long computation together, each step of it for all of
/// them: a step is short enough for a processor to work on several at a time.
inline constexpr int few = 4;

/// So many things, or less, each made where it stays: to copy vectors by the dozen would take its
/// time.
template <class T>
class Few {
public:
    static_assert(std::is_trivially_copyable_v<T>);

    /// There must be room. `make` returns the thing.
    template <class Make>
    void add(Make&& make) {
        ::new (static_cast<void*>(memory_ + static_cast<std::size_t>(count_) * sizeof(T)))
            T(make());
        ++count_;
    }
    bool is_full() const { return count_ == few; }
    int count() const { return count_; }
    T& operator[](int i) {
        return *std::launder(
            reinterpret_cast<T*>(memory_ + static_cast<std::size_t>(i) * sizeof(T)));
    }
    const T& operator[](int i) const {
        return *std::launder(
            reinterpret_cast<const T*>(memory_ + static_cast<std::size_t>(i) * sizeof(T)));
    }

private:
    alignas(T) std::byte memory_[few * sizeof(T)];
    int count_ = 0;
};

/// make(0), make(1), …: `count` of them.
template <class Make>
auto few_of(int count, Make&& make) {
    Few<std::remove_cvref_t<decltype(make(0))>> made;
    for (int i = 0; i < count; ++i)
        made.add([&] { return make(i); });
    return made;
}

}  // namespace scanlight::shading
