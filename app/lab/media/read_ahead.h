#pragma once

#include "model/look/picture.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>

/// Immutable, so that the drawing and the reading thread can share it.
using SharedPicture = std::shared_ptr<const Picture>;

/// The pictures of a film from the requested one on, a few at a time.
class ReadAhead {
public:
    /// `count` is the number of pictures; nullopt: not known yet.
    ReadAhead(std::optional<std::int64_t> count, bool loops) : m_count(count), m_loops(loops) {}

    void set_loop(bool loops) { m_loops = loops; }
    /// Requests the picture with this number, from 0. After the end it loops or holds the last one.
    void request(std::int64_t number) { m_requested = number; }
    /// Whether the requested picture was read, or there is none.
    bool is_ready() const { return m_count == 0 || m_pictures.contains(resolved(m_requested)); }
    /// The requested picture. If it is not readable, the previous one; null: not read yet.
    SharedPicture requested() const;

    /// The requested picture first, then the following ones; nullopt: all were read.
    std::optional<std::int64_t> next_to_read() const;
    /// Stores what was read, and removes pictures that are not among the next few. nullopt: not
    /// readable, or after the end.
    void add(std::int64_t number, std::optional<Picture> read, std::optional<std::int64_t> count);

private:
    std::int64_t resolved(std::int64_t number) const;
    bool is_near(std::int64_t number) const;

    std::map<std::int64_t, SharedPicture> m_pictures;
    SharedPicture m_latest;
    std::optional<std::int64_t> m_count;
    std::int64_t m_requested = 0;
    std::int64_t m_maximum = 4;  // maximum number kept
    bool m_loops;
};
