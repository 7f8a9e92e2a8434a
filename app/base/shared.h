#pragma once

#include <atomic>
#include <memory>
#include <utility>

/// A value whose copies are one in memory until one of them is changed. Copies may belong to
/// different threads.
template <class T>
class Shared {
public:
    Shared() = default;
    explicit Shared(T value) : m_value(std::make_shared<T>(std::move(value))) {}

    const T& operator*() const {
        static const T nothing{};
        return m_value ? *m_value : nothing;
    }
    const T* operator->() const { return &**this; }
    /// To be changed: shared with nobody from here on.
    T& own() {
        if (!m_value)
            m_value = std::make_shared<T>();
        else if (m_value.use_count() > 1)
            m_value = std::make_shared<T>(*m_value);
        // What another thread read of it before it let go has been read.
        std::atomic_thread_fence(std::memory_order_acquire);
        return *m_value;
    }

    bool operator==(const Shared& other) const {
        return m_value == other.m_value || **this == *other;
    }

private:
    std::shared_ptr<T> m_value;  // null: as if made without arguments
};
