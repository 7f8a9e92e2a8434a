#pragma once

#include <atomic>
#include <concepts>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>

/// A copy-on-write value, readable as a T: copies share memory until one of them changes. Copies
/// may belong to different threads.
template <class T>
class Shared {
public:
    Shared() = default;
    Shared(T value) : m_value(std::make_shared<T>(std::move(value))) {}
    Shared(const char* text) requires std::same_as<T, std::string> : Shared(std::string(text)) {}

    operator const T&() const { return **this; }
    operator std::string_view() const requires std::same_as<T, std::string> { return **this; }
    const T& operator*() const {
        static const T nothing{};
        return m_value ? *m_value : nothing;
    }
    const T* operator->() const { return &**this; }
    /// Write access; makes an unshared copy first if needed.
    T& own() {
        if (!m_value)
            m_value = std::make_shared<T>();
        else if (m_value.use_count() > 1)
            m_value = std::make_shared<T>(*m_value);
        // Reads by threads that released their copies happen before the caller's writes.
        std::atomic_thread_fence(std::memory_order_acquire);
        return *m_value;
    }

    bool operator==(const Shared& other) const {
        return m_value == other.m_value || **this == *other;
    }

private:
    std::shared_ptr<T> m_value;  // null: a default-constructed value
};

using SharedText = Shared<std::string>;

inline std::ostream& operator<<(std::ostream& stream, const SharedText& text) {
    return stream << *text;
}
