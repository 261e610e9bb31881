#pragma once

#include <cstring>
#include <stdexcept>
#include <type_traits>
#include <unordered_map>

namespace kerf {

/// A value whose bytes in memory are all of it: numbers, vectors of Eigen, structs of these. Not of
/// optional values, whose bytes are anything where there is none: they need archive().
template <class T>
concept Flat = std::is_trivially_destructible_v<T> && !std::is_pointer_v<T>;

/// The bytes of a value, 0 between its members (where the compiler is GCC): so equal values have
/// equal bytes.
template <Flat T>
std::array<std::byte, sizeof(T)> plainBytes(const T& value) {
    T copy = value;
#if defined(__has_builtin)
#if __has_builtin(__builtin_clear_padding)
    __builtin_clear_padding(&copy);
#endif
#endif
    std::array<std::byte, sizeof(T)> bytes;
    std::memcpy(bytes.data(), static_cast<const void*>(&copy), sizeof copy);  // it is Flat
    return bytes;
}

/// Visits what values consist of, in a fixed order, to write them as bytes or to read them again.
/// A class takes part by a function template `archive(io)` that calls `io` with all its members.
/// `Medium` has raw(data, bytes), plain(values, number), count(size), which returns the number of
/// elements, and kReads.
template <class Medium>
class ByteArchive : public Medium {
  public:
    using Medium::Medium;

    template <class... T>
    void operator()(T&... values) {
        static_assert(!Medium::kReads || !(std::is_const_v<T> || ...), "nothing could be read");
        (visit(const_cast<std::remove_const_t<T>&>(values)), ...);
    }

  private:
    template <class T>
    void visit(T& value) {
        if constexpr (requires { value.archive(*this); }) {
            value.archive(*this);
        } else {
            static_assert(Flat<T>, "this needs archive()");
            Medium::plain(&value, 1);
        }
    }
    template <class T>
    void visit(std::vector<T>& list) {
        resize(list);
        if constexpr (Flat<T> && !requires(T & t) { t.archive(*this); }) {
            Medium::plain(list.data(), list.size());
        } else {
            visitEach(list);
        }
    }
    template <class T, std::size_t size>
    void visit(std::array<T, size>& list) {
        visitEach(list);
    }
    /// Of whatever bytes come, it is true or false.
    void visit(bool& value) {
        auto byte = static_cast<std::uint8_t>(value ? 1 : 0);
        Medium::plain(&byte, 1);
        value = byte != 0;
    }
    void visit(std::string& text) {
        resize(text);
        Medium::raw(text.data(), text.size());
    }
    template <class T>
    void visit(std::optional<T>& value) {
        if (Medium::count(value.has_value() ? 1 : 0) == 0) {
            value.reset();
            return;
        }
        if constexpr (Medium::kReads) {
            value.emplace();
        }
        visit(*value);
    }
    template <class Key, class T>
    void visit(std::map<Key, T>& table) {
        visitAs<std::vector<std::pair<Key, T>>>(table);
    }
    template <class Key, class T>
    void visit(std::unordered_map<Key, T>& table) {
        visitAs<std::map<Key, T>>(table);  // in an order of its own, whatever came first
    }
    template <class T>
    void visit(std::set<T>& values) {
        visitAs<std::vector<T>>(values);
    }
    template <class First, class Second>
    void visit(std::pair<First, Second>& both) {
        visit(both.first);
        visit(both.second);
    }

    template <class List>
    void visitEach(List& list) {
        for (auto& element : list) {
            visit(element);
        }
    }
    /// By way of a list.
    template <class List, class Container>
    void visitAs(Container& container) {
        List list(container.begin(), container.end());
        visit(list);
        if constexpr (Medium::kReads) {
            container = Container(list.begin(), list.end());
        }
    }
    template <class List>
    void resize(List& list) {
        const std::size_t size = Medium::count(list.size());
        if constexpr (Medium::kReads) {
            list.resize(size);
        }
    }
};

/// Appends to `bytes`.
class ToBytes {
  public:
    static constexpr bool kReads = false;

    std::vector<std::byte> bytes;

    void raw(const void* data, std::size_t size) {
        const auto* from = static_cast<const std::byte*>(data);
        bytes.insert(bytes.end(), from, from + size);
    }
    std::size_t count(std::size_t size) {
        raw(&size, sizeof size);
        return size;
    }
    template <Flat T>
    void plain(const T* values, std::size_t number) {
        if constexpr (std::has_unique_object_representations_v<T> || std::is_floating_point_v<T>) {
            raw(values, number * sizeof(T));
        } else {
            for (std::size_t i = 0; i < number; ++i) {
                const auto each = plainBytes(values[i]);
                raw(each.data(), each.size());
            }
        }
    }
};

/// Takes from bytes, which must outlive it. Throws std::out_of_range where they end too early.
class FromBytes {
  public:
    static constexpr bool kReads = true;

    explicit FromBytes(std::span<const std::byte> bytes) : bytes_(bytes) {}

    bool isAtEnd() const { return at_ == bytes_.size(); }
    void raw(void* data, std::size_t size) {
        if (size > bytes_.size() - at_) {
            throw std::out_of_range("too few bytes");
        }
        if (size > 0) {
            std::memcpy(data, bytes_.data() + at_, size);
        }
        at_ += size;
    }
    template <Flat T>
    void plain(T* values, std::size_t number) {
        raw(values, number * sizeof(T));
    }
    /// A count cannot exceed the bytes that follow.
    std::size_t count(std::size_t) {
        std::size_t size = 0;
        raw(&size, sizeof size);
        if (size > bytes_.size() - at_) {
            throw std::out_of_range("too few bytes");
        }
        return size;
    }

  private:
    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
};

using ByteWriter = ByteArchive<ToBytes>;
using ByteReader = ByteArchive<FromBytes>;

}  // namespace kerf
