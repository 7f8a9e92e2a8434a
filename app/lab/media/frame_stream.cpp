#include "lab/media/frame_stream.h"

#include "lab/rendering/sanitize.h"
#include "model/picture/encoding_curve.h"

#include <algorithm>
#include <utility>

FrameStream::FrameStream(std::unique_ptr<PictureReader> reader, std::filesystem::path name,
                         bool loops)
    : m_reader(std::move(reader)),
      m_name(std::move(name)),
      m_count(m_reader->count()),
      m_loops(loops) {
    m_thread = std::thread([this] { run(); });
}

FrameStream::~FrameStream() {
    {
        const std::lock_guard lock(m_mutex);
        m_is_ending = true;
    }
    m_wake.notify_all();
    m_thread.join();
}

std::int64_t FrameStream::resolved(std::int64_t number) const {
    number = std::max<std::int64_t>(number, 0);
    if (!m_count || *m_count < 1)
        return number;
    return m_loops ? number % *m_count : std::min(number, *m_count - 1);
}

SharedPicture FrameStream::find(std::int64_t number) {
    const auto found = m_pictures.find(resolved(number));
    return found == m_pictures.end() ? nullptr : found->second;
}

SharedPicture FrameStream::wait(std::int64_t number) {
    std::unique_lock lock(m_mutex);
    m_wanted = number;
    m_wake.notify_all();
    m_ready.wait(lock, [&] { return m_count == 0 || m_pictures.contains(resolved(number)); });
    return find(number);
}

SharedPicture FrameStream::peek(std::int64_t number) {
    const std::lock_guard lock(m_mutex);
    m_wanted = number;
    m_wake.notify_all();
    return find(number);
}

void FrameStream::set_loop(bool loops) {
    const std::lock_guard lock(m_mutex);
    m_loops = loops;
}

Diagnostics FrameStream::take_problems() {
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_problems, {});
}

// The requested picture first, then the following ones.
std::optional<std::int64_t> FrameStream::next_to_read() const {
    if (m_count == 0)
        return std::nullopt;
    for (std::size_t ahead = 0; ahead < m_most; ++ahead) {
        const std::int64_t number = resolved(m_wanted + static_cast<std::int64_t>(ahead));
        if (!m_pictures.contains(number))
            return number;
    }
    return std::nullopt;
}

void FrameStream::tell(Diagnostic problem) {
    if (std::ranges::find(m_told, problem) != m_told.end())
        return;
    m_told.push_back(problem);
    m_problems.push_back(std::move(problem));
}

// Removes pictures outside the next few.
void FrameStream::keep(std::int64_t number, Result<std::optional<Picture>> read) {
    constexpr std::size_t most_bytes = std::size_t{256} << 20;
    if (!read) {
        for (Diagnostic& problem : read.error())
            tell(std::move(problem));
    } else if (*read) {
        const std::size_t bytes = (*read)->pixels.size() * sizeof(float);
        m_most = std::clamp<std::size_t>(most_bytes / std::max<std::size_t>(bytes, 1), 2, 8);
        m_latest = std::make_shared<const Picture>(std::move(**read));
    }
    m_count = m_reader->count();
    std::erase_if(m_pictures, [this](const auto& kept) {
        for (std::size_t ahead = 0; ahead < m_most; ++ahead)
            if (resolved(m_wanted + static_cast<std::int64_t>(ahead)) == kept.first)
                return false;
        return true;
    });
    const bool is_past_the_end = m_count && number >= *m_count;
    if (!is_past_the_end)
        m_pictures[number] = m_latest;  // after an error, the previous picture
}

void FrameStream::run() {
    std::unique_lock lock(m_mutex);
    for (;;) {
        m_wake.wait(lock, [this] { return m_is_ending || next_to_read(); });
        if (m_is_ending)
            return;
        const std::int64_t number = *next_to_read();
        lock.unlock();
        auto read = m_reader->read(number);
        std::optional<Diagnostic> sanitized;
        std::optional<Diagnostic> note;
        if (read && *read)
            note = note_about(**read, m_name);
        if (read && *read && (*read)->encoding == Encoding::linear)
            sanitized = sanitize(**read, m_name);
        if (const auto encoding = m_encoding.load(); read && *read && encoding)
            recode(**read, *encoding);
        lock.lock();
        for (std::optional<Diagnostic>* amiss : {&sanitized, &note})
            if (*amiss)
                tell(std::move(**amiss));
        keep(number, std::move(read));
        m_ready.notify_all();
    }
}
