#include "io/video/video_file.h"

#include "io/system/child_process.h"
#include "io/temporary_folder.h"
#include "problems_of.h"

#include <doctest/doctest.h>

#include <cstdlib>

namespace {
// An uncompressed video: picture n has luma 16 + 20 n and no colour. In limited range that is a
// grey of 20 n / 219.
std::string steps(int count, const char* rate) {
    std::string video = std::string("YUV4MPEG2 W16 H8 F") + rate + " Ip A1:1 C444\n";
    for (int n = 0; n < count; ++n)
        video += "FRAME\n" + std::string(128, static_cast<char>(16 + 20 * n)) +
                 std::string(256, static_cast<char>(128));
    return video;
}

std::unique_ptr<PictureReader> opened(const std::filesystem::path& file) {
    auto reader = open_video(file);
    REQUIRE_MESSAGE(reader.has_value(), problems_of(reader));
    return std::move(*reader);
}

double step_at(PictureReader& reader, std::int64_t number) {
    const auto picture = reader.read(number);
    REQUIRE_MESSAGE(picture.has_value(), problems_of(picture));
    REQUIRE(picture->has_value());
    CHECK((**picture).extent == Extent{16, 8});
    CHECK((**picture).encoding == Encoding::display);
    return (**picture).pixels[3 * 16 + 1] * 219.0 / 20.0;
}

struct WithoutPrograms {
    WithoutPrograms() : path(std::getenv("PATH")) { setenv("PATH", "/nowhere", 1); }
    ~WithoutPrograms() { setenv("PATH", path.c_str(), 1); }
    std::string path;
};
}  // namespace

TEST_CASE("pictures of a video are read by number, forwards, repeatedly and backwards") {
    const TemporaryFolder folder;
    const auto reader = opened(folder.write("-steps.y4m", steps(5, "30000:1001")));
    CHECK(reader->rate() == doctest::Approx(29.97003).epsilon(1e-6));
    CHECK_FALSE(reader->count().has_value());
    for (const std::int64_t number : {0, 1, 4, 2, 2, 3})
        CHECK(std::abs(step_at(*reader, number) - static_cast<double>(number)) < 0.06);
    CHECK_FALSE(reader->read(5).value().has_value());
    CHECK(reader->count() == 5);
    CHECK(std::abs(step_at(*reader, 1) - 1.0) < 0.06);
}

TEST_CASE("invalid, empty, missing and truncated videos give an error with the file") {
    const TemporaryFolder folder;
    const auto refused = [&](const std::filesystem::path& file) {
        const auto reader = open_video(file);
        REQUIRE_FALSE(reader.has_value());
        CHECK(reader.error().front().file == file);
        return reader.error().front().message;
    };
    CHECK(refused(folder.write("text.mp4", "no video")).starts_with("can't read the video: "));
    CHECK(refused(folder.write("empty.mp4", "")) == "the file is empty");
    CHECK(refused(folder / "none.mp4") == "file not found");
    const std::string whole = steps(3, "25:1");
    const auto cut = opened(folder.write("cut.y4m", whole.substr(0, whole.size() - 100)));
    CHECK(std::abs(step_at(*cut, 1) - 1.0) < 0.06);
    (void)cut->read(2);  // an error or a shorter video, depending on the version of FFmpeg
    CHECK(cut->count() == 2);
    CHECK(std::abs(step_at(*cut, 0)) < 0.06);
}

TEST_CASE("if FFmpeg is not installed, the error names its package") {
    const TemporaryFolder folder;
    const auto file = folder.write("steps.y4m", steps(1, "25:1"));
    const WithoutPrograms nothing;
    const auto reader = open_video(file);
    REQUIRE_FALSE(reader.has_value());
    CHECK(to_string(reader.error().front()) ==
          file.string() +
              ": error: reading videos needs the Debian package ffmpeg: the program "
              "'ffprobe' isn't installed");
}

TEST_CASE("a child process returns its output and errors, and ends with its owner") {
    auto echo = ChildProcess::start({"sh", "-c", "printf abc; echo oh no >&2; exit 3"});
    REQUIRE(echo.has_value());
    CHECK(echo->read_all(100) == "abc");
    CHECK_FALSE(echo->finish());
    CHECK(echo->complaint() == "oh no");
    auto endless = ChildProcess::start({"sh", "-c", "while :; do echo y; done"});
    REQUIRE(endless.has_value());
    CHECK(endless->read_all(4) == "y\ny\n");
}
