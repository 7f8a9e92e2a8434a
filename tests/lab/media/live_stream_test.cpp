#include "lab/media/live_stream.h"

#include <doctest/doctest.h>

#include <chrono>
#include <functional>
#include <mutex>
#include <thread>

namespace {
// Whether it becomes true within seconds.
bool is_soon(const std::function<bool()>& is_true) {
    constexpr int looks = 2000;
    for (int i = 0; i < looks && !is_true(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return is_true();
}

/// What a recorded device does next.
struct Recording {
    std::mutex mutex;
    std::vector<Result<std::optional<Picture>>> steps;  // the last one first
    std::string notice;
    int openings = 0;
    bool is_missing = false;
};

class RecordedDevice final : public VideoCapture {
public:
    explicit RecordedDevice(Recording& recording) : m_recording(recording) {}

    Result<std::optional<Picture>> read(double) override {
        const std::lock_guard lock(m_recording.mutex);
        if (m_recording.steps.empty()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            return std::nullopt;
        }
        auto step = std::move(m_recording.steps.back());
        m_recording.steps.pop_back();
        return step;
    }
    std::string notice() const override {
        const std::lock_guard lock(m_recording.mutex);
        return m_recording.notice;
    }

private:
    Recording& m_recording;
};

LiveStream::Open opening(Recording& recording) {
    return [&recording]() -> Result<std::unique_ptr<VideoCapture>> {
        const std::lock_guard lock(recording.mutex);
        ++recording.openings;
        if (recording.is_missing)
            return fail({{}, 0, "it is not plugged in"});
        return std::make_unique<RecordedDevice>(recording);
    };
}

void play(Recording& recording, Result<std::optional<Picture>> step) {
    const std::lock_guard lock(recording.mutex);
    recording.steps.push_back(std::move(step));
}

Picture live_grey(float level) {
    return {{1, 1}, 3, Encoding::display, {level, level, level}};
}

bool shows(const LiveStream& stream, float level) {
    const SharedPicture picture = stream.newest();
    return picture && picture->pixels.front() == level;
}

std::string problem_of(LiveStream& stream) {
    std::string text;
    static_cast<void>(is_soon([&] {
        for (const Diagnostic& problem : stream.take_problems())
            text = problem.message;
        return !text.empty();
    }));
    return text;
}
}  // namespace

TEST_CASE("the newest picture of a live source is shown, and stays when the source is lost") {
    Recording recording;
    play(recording, live_grey(0.25f));
    LiveStream stream(opening(recording), "camera:/dev/video0", 0.0);
    REQUIRE(stream.wait_for_first(10.0));
    CHECK(shows(stream, 0.25f));
    play(recording, fail({{}, 0, "it was unplugged"}));
    CHECK(problem_of(stream) == "it was unplugged");
    CHECK(shows(stream, 0.25f));
    play(recording, live_grey(0.75f));  // opened again
    CHECK(is_soon([&] { return shows(stream, 0.75f); }));
    const std::lock_guard lock(recording.mutex);
    CHECK(recording.openings == 2);
}

TEST_CASE("a live source that is missing is reported once, and opened when it appears") {
    Recording recording;
    recording.is_missing = true;
    LiveStream stream(opening(recording), "camera:/dev/video0", 0.0);
    CHECK_FALSE(stream.wait_for_first(10.0));
    CHECK(problem_of(stream) == "it is not plugged in");
    CHECK(is_soon([&] {
        const std::lock_guard lock(recording.mutex);
        return recording.openings > 1;
    }));
    CHECK(stream.take_problems().empty());
    play(recording, live_grey(0.5f));
    {
        const std::lock_guard lock(recording.mutex);
        recording.is_missing = false;
    }
    CHECK(is_soon([&] { return shows(stream, 0.5f); }));
}

TEST_CASE("a notice of a live source is reported when it begins and when it ends") {
    Recording recording;
    recording.notice = "the window is minimised";
    LiveStream stream(opening(recording), "window:Editor", 0.0);
    CHECK(problem_of(stream) == "the window is minimised");
    CHECK(stream.take_problems().empty());
    CHECK_FALSE(stream.take_solved());
    {
        const std::lock_guard lock(recording.mutex);
        recording.notice.clear();
    }
    bool is_solved = false;
    CHECK(is_soon([&] { return is_solved = is_solved || stream.take_solved(); }));
    CHECK_FALSE(stream.take_solved());
}

TEST_CASE("pictures of a live source are converted before they are drawn") {
    Recording recording;
    LiveStream stream(opening(recording), "window:Editor", 0.0);
    stream.set_encoding(Encoding::linear);
    play(recording, live_grey(1.0f));
    REQUIRE(is_soon([&] { return stream.newest() != nullptr; }));
    CHECK(stream.newest()->encoding == Encoding::linear);
}

TEST_CASE("a film of a live source waits for the time of its frames") {
    Recording recording;
    play(recording, live_grey(0.5f));
    const auto start = std::chrono::steady_clock::now();
    LiveStream stream(opening(recording), "screen:", 0.0);
    REQUIRE(stream.wait_for_first(10.0));
    stream.wait_until(0.2);
    CHECK(std::chrono::steady_clock::now() - start >= std::chrono::milliseconds(200));
}
