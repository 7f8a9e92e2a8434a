#include "lab/media/source.h"

#include "io/capture/open_capture.h"
#include "io/capture/video_stream.h"
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
constexpr double first_picture_seconds = 3.0;  // until a live source counts as missing
constexpr int most_waits_for_user = 40;        // of that time, while the user is asked
constexpr Extent missing_extent{640, 480};

// The pattern with its size, from the text of a pattern source.
std::string_view pattern_of(const SourceSpec& spec) {
    constexpr std::string_view prefix = "pattern:";
    return std::string_view(spec.picture).substr(prefix.size());
}

Result<Picture> read_still(const SourceSpec& spec) {
    return spec.is_pattern() ? make_pattern(pattern_of(spec)) : load_picture(spec.picture);
}

/// Every picture of a live input, one after the other.
class LiveReader final : public PictureReader {
public:
    explicit LiveReader(std::unique_ptr<VideoCapture> input) : m_input(std::move(input)) {}

    Result<std::optional<Picture>> read(std::int64_t number) override {
        constexpr double between_looks = 1.0;  // s
        while (m_next <= number && !m_count) {
            auto picture = m_input->read(between_looks);
            if (!picture && m_next == 0)
                return fail(picture.error());
            if (!picture)
                m_count = m_next;
            else if (*picture)
                m_latest = std::move(**picture);
            m_next += picture && *picture ? 1 : 0;
        }
        return m_count && number >= *m_count ? std::nullopt : std::optional(m_latest);
    }

    std::optional<std::int64_t> count() const override { return m_count; }
    double rate() const override { return m_input->rate(); }

private:
    std::unique_ptr<VideoCapture> m_input;
    Picture m_latest;
    std::int64_t m_next = 0;
    std::optional<std::int64_t> m_count;
};
}  // namespace

Result<void> Source::open_whole_pipe(const LiveSpec& live) {
    auto input = open_pipe(live, m_spec.rate, StreamPace::all);
    if (!input)
        return fail(input.error());
    auto reader = std::make_unique<LiveReader>(std::move(*input));
    LiveReader& opened = *reader;
    m_stream = std::make_unique<FrameStream>(std::move(reader), m_spec.picture, false);
    m_picture = m_stream->wait(0);
    m_own_rate = opened.rate();  // known when the first picture has come
    if (!m_picture)
        return fail(m_stream->take_problems());
    return {};
}

Result<void> Source::open_live(LiveReading reading) {
    const auto live = parse_live(m_spec.picture);
    if (!live)
        return fail(live.error());
    if (reading == LiveReading::complete && live->kind == LiveKind::pipe)
        return open_whole_pipe(*live);
    m_live = std::make_unique<LiveStream>(
        [live = *live, rate = m_spec.rate] { return open_capture(live, rate); }, m_spec.picture,
        m_spec.rate);
    int waits = reading == LiveReading::complete ? most_waits_for_user : 1;
    do
        m_picture = m_live->wait_for_first(first_picture_seconds);
    while (!m_picture && m_live->asks_user() && --waits > 0);
    m_is_late = !m_picture;
    if (m_picture)
        return {};
    if (reading == LiveReading::complete) {
        Diagnostics problems = m_live->take_problems();
        if (problems.empty())
            problems.push_back({m_spec.picture, 0, "no picture came within 3 s"});
        for (Diagnostic& problem : problems)
            problem.severity = Severity::error;
        return fail(std::move(problems));
    }
    Picture black{missing_extent, 3, Encoding::display, {}};
    black.pixels.resize(black.index(0, missing_extent.height));
    m_picture = std::make_shared<const Picture>(std::move(black));
    return {};
}

Result<Source> Source::open(const std::string& text, LiveReading live) {
    auto spec = parse_source(text);
    if (!spec)
        return fail(spec.error());
    Source source;
    source.m_spec = std::move(*spec);
    if (source.m_spec.is_live()) {
        if (auto opened = source.open_live(live); !opened)
            return fail(opened.error());
        source.find_prescale();
        return source;
    }
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
    if (m_spec.prescaled != 0 || m_spec.is_pattern() || m_has_looked_for_prescale || m_is_late)
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
        m_stream->set_loop(spec.loops && !spec.is_live());
    if (m_live)
        m_live->set_rate(spec.rate);
}

void Source::expect(Encoding encoding) {
    if (m_stream)
        m_stream->set_encoding(encoding);
    if (m_live)
        m_live->set_encoding(encoding);
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

void Source::follow_live() {
    SharedPicture picture = m_live->newest();
    m_is_late = picture == nullptr;
    if (picture)
        m_picture = std::move(picture);
    find_prescale();
}

bool Source::refresh() {
    const Extent before = extent();
    if (m_live)
        follow_live();
    return extent() != before;
}

SharedPicture Source::wait_for(double seconds) {
    if (m_live) {
        m_live->wait_until(seconds);
        follow_live();
        return original();
    }
    if (m_is_moving_pattern)
        draw_pattern(seconds);
    if (m_stream)
        if (SharedPicture picture = m_stream->wait(number_at(seconds)))
            m_picture = std::move(picture);
    m_is_late = false;
    return original();
}

SharedPicture Source::picture_at(double seconds) {
    if (m_live)
        follow_live();
    if (!m_stream)
        return m_live ? original() : wait_for(seconds);
    SharedPicture picture = m_stream->peek(number_at(seconds));
    m_is_late = picture == nullptr;
    if (picture)
        m_picture = std::move(picture);
    return original();
}

Diagnostics Source::take_problems() {
    Diagnostics problems = std::exchange(m_problems, {});
    const Diagnostics more = m_stream ? m_stream->take_problems()
                             : m_live ? m_live->take_problems()
                                      : Diagnostics();
    problems.insert(problems.end(), more.begin(), more.end());
    return problems;
}

bool is_source_file(const std::filesystem::path& file) {
    return is_picture_file(file) || is_video_file(file) || is_sequence_name(file);
}

Result<void> show_placed(const Picture& picture, const SourceSpec& spec, Extent viewport,
                         Executors& executors) {
    const bool is_whole = spec.fit == Fit::stretch ||
                          (spec.fit != Fit::integer &&
                           placed_extent(picture.extent, spec, viewport) == picture.extent);
    return executors.set_source(is_whole ? picture : placed(picture, spec, viewport),
                                placed_aspect(spec, picture.extent),
                                placed_raster(picture.extent, spec, viewport));
}
