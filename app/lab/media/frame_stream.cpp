#include "lab/media/frame_stream.h"

#include "lab/rendering/sanitize.h"
#include "model/picture/encoding_curve.h"

#include <algorithm>
#include <utility>

FrameStream::FrameStream(std::unique_ptr<PictureReader> reader, std::filesystem::path name,
                         bool loops)
    : m_reader(std::move(reader)), m_name(std::move(name)), m_pictures(m_reader->count(), loops) {
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

SharedPicture FrameStream::wait(std::int64_t number) {
    std::unique_lock lock(m_mutex);
    m_pictures.request(number);
    m_wake.notify_all();
    m_ready.wait(lock, [this] { return m_pictures.is_ready(); });
    return m_pictures.requested();
}

SharedPicture FrameStream::peek(std::int64_t number) {
    const std::lock_guard lock(m_mutex);
    m_pictures.request(number);
    m_wake.notify_all();
    return m_pictures.requested();
}

void FrameStream::set_loop(bool loops) {
    const std::lock_guard lock(m_mutex);
    m_pictures.set_loop(loops);
}

Diagnostics FrameStream::take_problems() {
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_problems, {});
}

void FrameStream::report(Diagnostic problem) {
    if (std::ranges::find(m_reported, problem) != m_reported.end())
        return;
    m_reported.push_back(problem);
    m_problems.push_back(std::move(problem));
}

void FrameStream::add(std::int64_t number, Result<std::optional<Picture>> read) {
    if (!read)
        for (Diagnostic& problem : read.error())
            report(std::move(problem));
    m_pictures.add(number, read ? std::move(*read) : std::nullopt, m_reader->count());
}

void FrameStream::run() {
    std::unique_lock lock(m_mutex);
    for (;;) {
        m_wake.wait(lock, [this] { return m_is_ending || m_pictures.next_to_read(); });
        if (m_is_ending)
            return;
        const std::int64_t number = *m_pictures.next_to_read();
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
                report(std::move(**amiss));
        add(number, std::move(read));
        m_ready.notify_all();
    }
}
