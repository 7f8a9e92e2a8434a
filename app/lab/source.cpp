#include "lab/source.h"

#include "io/picture_file.h"
#include "io/picture_sequence.h"
#include "io/video_file.h"
#include "lab/media.h"
#include "lab/mend.h"
#include "signals/patterns.h"

#include <algorithm>
#include <cmath>

namespace {
constexpr double usual_rate = 60.0;

Result<Picture> read_still(const SourceSpec& spec) {
    constexpr std::string_view prefix = "pattern:";
    return spec.is_pattern() ? make_pattern(std::string_view(spec.picture).substr(prefix.size()))
                             : load_picture(spec.picture);
}
}  // namespace

Result<Source> Source::open(const std::string& text) {
    auto spec = parse_source(text);
    if (!spec)
        return fail(spec.error());
    Source source;
    source.m_spec = std::move(*spec);
    const std::filesystem::path file = source.m_spec.picture;
    const bool is_pattern = source.m_spec.is_pattern();
    std::error_code error;
    const bool is_video = !is_pattern && is_video_file(file);
    const bool is_sequence =
        !is_pattern && !is_video && is_sequence_name(file) && !std::filesystem::exists(file, error);
    if (is_video || is_sequence) {
        auto reader = is_video ? open_video(file) : open_sequence(file);
        if (!reader)
            return fail(reader.error());
        source.m_own_rate = (*reader)->rate();
        source.m_stream =
            std::make_unique<FrameStream>(std::move(*reader), file, source.m_spec.loops);
        source.m_picture = source.m_stream->wait(0);
        if (!source.m_picture)
            return fail(source.m_stream->take_problems());
        return source;
    }
    auto picture = read_still(source.m_spec);
    if (!picture)
        return fail(picture.error());
    if (auto mended = mend(*picture, file))
        source.m_problems.push_back(std::move(*mended));
    source.m_picture = std::make_shared<const Picture>(std::move(*picture));
    return source;
}

void Source::set_spec(const SourceSpec& spec) {
    m_spec = spec;
    if (m_stream)
        m_stream->set_loop(spec.loops);
}

double Source::rate() const {
    return m_spec.rate > 0.0 ? m_spec.rate : own_rate();
}

double Source::own_rate() const {
    return m_own_rate > 0.0 ? m_own_rate : usual_rate;
}

std::int64_t Source::number_at(double seconds) const {
    constexpr double rounding = 1e-6;  // of seconds * rate, which should be whole
    return std::max<std::int64_t>(
        static_cast<std::int64_t>(std::ceil(seconds * rate() - rounding)) - 1, 0);
}

SharedPicture Source::wait_for(double seconds) {
    if (m_stream)
        if (SharedPicture picture = m_stream->wait(number_at(seconds)))
            m_picture = std::move(picture);
    m_is_late = false;
    return m_picture;
}

SharedPicture Source::picture_at(double seconds) {
    if (!m_stream)
        return m_picture;
    SharedPicture picture = m_stream->peek(number_at(seconds));
    m_is_late = picture == nullptr;
    if (picture)
        m_picture = std::move(picture);
    return m_picture;
}

Diagnostics Source::take_problems() {
    Diagnostics problems = std::exchange(m_problems, {});
    if (m_stream) {
        const Diagnostics more = m_stream->take_problems();
        problems.insert(problems.end(), more.begin(), more.end());
    }
    return problems;
}

bool is_source_file(const std::filesystem::path& file) {
    return is_picture_file(file) || is_video_file(file) || is_sequence_name(file);
}
