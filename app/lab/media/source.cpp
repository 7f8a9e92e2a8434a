#include "lab/media/source.h"

#include "io/pictures/picture_file.h"
#include "io/pictures/picture_sequence.h"
#include "io/video/video_file.h"
#include "lab/rendering/executors.h"
#include "lab/rendering/sanitize.h"
#include "lab/storage/media.h"
#include "model/picture/placing.h"
#include "model/picture/prescaled.h"
#include "signals/patterns/patterns.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace {
constexpr double usual_rate = 60.0;

// The pattern with its size, from the text of a pattern source.
std::string_view pattern_of(const SourceSpec& spec) {
    constexpr std::string_view prefix = "pattern:";
    return std::string_view(spec.picture).substr(prefix.size());
}

Result<Picture> read_still(const SourceSpec& spec) {
    return spec.is_pattern() ? make_pattern(pattern_of(spec)) : load_picture(spec.picture);
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
        source.find_prescale();
        return source;
    }
    auto picture = read_still(source.m_spec);
    if (!picture)
        return fail(picture.error());
    if (auto note = note_about(*picture, file))
        source.m_problems.push_back(std::move(*note));
    if (auto sanitized = sanitize(*picture, file))
        source.m_problems.push_back(std::move(*sanitized));
    source.m_picture = std::make_shared<const Picture>(std::move(*picture));
    source.find_prescale();
    source.m_is_moving_pattern = is_pattern && is_moving_pattern(pattern_of(source.m_spec));
    return source;
}

int Source::prescale() const {
    return m_spec.prescaled > 0 ? m_spec.prescaled : m_found_prescale;
}

Extent Source::extent() const {
    return extent_without_prescale(m_picture->extent, prescale());
}

// The factor of the first picture is used for the whole film.
void Source::find_prescale() {
    if (m_spec.prescaled != 0 || m_spec.is_pattern() || m_has_looked_for_prescale)
        return;
    m_found_prescale = found_prescale(*m_picture);
    m_has_looked_for_prescale = true;
}

SharedPicture Source::original() {
    const int times = prescale();
    if (times == 1)
        return m_picture;
    if (!m_original || m_original_of != m_picture || m_original_times != times) {
        m_original = std::make_shared<const Picture>(without_prescale(*m_picture, times));
        m_original_of = m_picture;
        m_original_times = times;
    }
    return m_original;
}

void Source::set_spec(const SourceSpec& spec) {
    m_spec = spec;
    find_prescale();
    if (m_stream)
        m_stream->set_loop(spec.loops);
}

void Source::expect(Encoding encoding) {
    if (m_stream)
        m_stream->set_encoding(encoding);
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

// Cannot fail, because the same text was drawn before. An unchanged picture keeps its pointer, so
// it is not uploaded again.
void Source::draw_pattern(double seconds) {
    if (std::exchange(m_pattern_seconds, seconds) == seconds)
        return;
    if (auto picture = make_pattern(pattern_of(m_spec), seconds);
        picture && picture->pixels != m_picture->pixels)
        m_picture = std::make_shared<const Picture>(std::move(*picture));
}

SharedPicture Source::wait_for(double seconds) {
    if (m_is_moving_pattern)
        draw_pattern(seconds);
    if (m_stream)
        if (SharedPicture picture = m_stream->wait(number_at(seconds)))
            m_picture = std::move(picture);
    m_is_late = false;
    return original();
}

SharedPicture Source::picture_at(double seconds) {
    if (!m_stream)
        return wait_for(seconds);
    SharedPicture picture = m_stream->peek(number_at(seconds));
    m_is_late = picture == nullptr;
    if (picture)
        m_picture = std::move(picture);
    return original();
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

Result<void> show_placed(const Picture& picture, const SourceSpec& spec, Extent viewport,
                         Executors& executors) {
    const bool is_whole = spec.fit == Fit::stretch;
    return executors.set_source(is_whole ? picture : placed(picture, spec, viewport),
                                placed_aspect(spec, picture.extent),
                                placed_raster(picture.extent, spec, viewport));
}
