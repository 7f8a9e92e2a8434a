#include "lab/media/read_ahead.h"

#include <algorithm>
#include <utility>

std::int64_t ReadAhead::resolved(std::int64_t number) const {
    number = std::max<std::int64_t>(number, 0);
    if (!m_count || *m_count < 1)
        return number;
    return m_loops ? number % *m_count : std::min(number, *m_count - 1);
}

SharedPicture ReadAhead::requested() const {
    const auto found = m_pictures.find(resolved(m_requested));
    return found == m_pictures.end() ? nullptr : found->second;
}

std::optional<std::int64_t> ReadAhead::next_to_read() const {
    if (m_count == 0)
        return std::nullopt;
    for (std::int64_t ahead = 0; ahead < m_maximum; ++ahead)
        if (const auto number = resolved(m_requested + ahead); !m_pictures.contains(number))
            return number;
    return std::nullopt;
}

bool ReadAhead::is_near(std::int64_t number) const {
    for (std::int64_t ahead = 0; ahead < m_maximum; ++ahead)
        if (resolved(m_requested + ahead) == number)
            return true;
    return false;
}

void ReadAhead::add(std::int64_t number, std::optional<Picture> read,
                    std::optional<std::int64_t> count) {
    constexpr std::size_t max_bytes = std::size_t{256} << 20;
    if (read) {
        const std::size_t bytes = std::max<std::size_t>(read->pixels.size() * sizeof(float), 1);
        m_maximum = static_cast<std::int64_t>(std::clamp<std::size_t>(max_bytes / bytes, 2, 8));
        m_latest = std::make_shared<const Picture>(std::move(*read));
    }
    m_count = count;
    std::erase_if(m_pictures, [this](const auto& kept) { return !is_near(kept.first); });
    const bool is_past_the_end = m_count && number >= *m_count;
    if (!is_past_the_end)
        m_pictures[number] = m_latest;  // after an error, the previous picture
}
