#include "lab/offline/export_plan.h"

#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <fstream>

namespace {
/// A form for a look without a signal.
class Planning {
public:
    Planning() {
        form.folder = m_folder.path();
        form.file = "a.mp4";
    }
    ExportPlan plan() const {
        return planned_export(form, {.document = m_document,
                                     .queue = m_queue,
                                     .render_size = {640, 480},
                                     .signal = signal,
                                     .sound_seconds = sound_seconds,
                                     .frame_milliseconds = 10.0,
                                     .plays_cues = plays_cues});
    }
    std::string problem(ExportField field) const { return plan().problem_of(field); }

    ExportForm form;
    Spec signal;
    double sound_seconds = 0.0;
    bool plays_cues = false;
    std::filesystem::path path(const char* name) const { return m_folder / name; }

private:
    TemporaryFolder m_folder;
    Look m_look;
    Document m_document{m_look};
    ExportQueue m_queue;
};
}  // namespace

TEST_CASE("the defaults of the form can be exported") {
    const Planning planning;
    const ExportPlan plan = planning.plan();
    CHECK(plan.is_good());
    CHECK(plan.settings.file == planning.path("a.mp4"));
    CHECK(plan.settings.size.is_empty());
    CHECK(plan.frames == 600);
    CHECK(plan.work_seconds == doctest::Approx(6.0));
    CHECK(!plan.replaces);
}

TEST_CASE("each field reports its own problem") {
    Planning planning;
    planning.form.fps = "abc";
    planning.form.start = "-1";
    planning.form.length = "0";
    planning.form.size = "5";
    CHECK(planning.problem(ExportField::fps) == "Type a number from 1 to 1000.");
    CHECK(planning.problem(ExportField::start) == "Type seconds or M:SS from 0 s to 86400 s.");
    CHECK(planning.problem(ExportField::length) == "Type seconds or M:SS from 0.001 s to 86400 s.");
    CHECK(planning.problem(ExportField::size).find("Type a size such as 1280x720") == 0);

    Planning films;
    films.form.codec = "ffv1";
    CHECK(films.problem(ExportField::codec) == "'.mp4' can't hold FFV1 (lossless). Use .mkv.");
    films.form.codec = "";
    films.form.sound = "flac";
    CHECK(films.problem(ExportField::sound) == "'.mp4' can't hold FLAC (lossless). Use .mkv.");
    films.form.sound = "";
    films.form.quality = "60";
    CHECK(films.problem(ExportField::quality) ==
          "The quality of H.264 is 1 to 51 (CRF, lower is better), got 60.");
    films.form.quality = "";
    films.form.keeps_alpha = true;
    CHECK(films.problem(ExportField::alpha).find("has no transparency") != std::string::npos);
    films.form.keeps_alpha = false;
    films.form.file = "a.avi";
    CHECK(films.problem(ExportField::file).find("must end in") != std::string::npos);
    films.form.file = "a.png";
    CHECK(films.problem(ExportField::file) == "Image sequences need %04d in the name.");
    films.form.file = " ";
    CHECK(films.problem(ExportField::file) == "Type a file name.");
    films.form.file = "a.mp4";
    CHECK(films.plan().is_good());
}

TEST_CASE("a start after the sound and a small picture are refused") {
    Planning planning;
    planning.sound_seconds = 2.0;
    planning.form.start = "2";
    CHECK(planning.problem(ExportField::start) == "The sound ends at 2 s. Type an earlier start.");
    planning.form.start = "0.5";
    CHECK(planning.plan().frames == 90);
    planning.form.codec = "av1";
    planning.form.size = "48x48";
    CHECK(planning.problem(ExportField::size) ==
          "AV1 (10 bit) needs at least 64 x 64 px, got 48 x 48.");
}

TEST_CASE("a loop is refused while cues play") {
    Planning planning;
    planning.plays_cues = true;
    CHECK(planning.plan().is_good());
    planning.form.loops = true;
    CHECK(planning.problem(ExportField::length) == "Cues don't repeat. Turn off Play cues first.");
    planning.plays_cues = false;
    CHECK(planning.plan().is_good());
}

TEST_CASE("lossy sound that is drawn as XY gets a note") {
    Planning planning;
    planning.signal = {.kind = "audio", .settings = {{"mode", std::string("xy")}}};
    planning.sound_seconds = 2.0;
    CHECK(planning.plan().note.find("AAC changes the sound") == 0);
    planning.form.file = "a.mov";
    CHECK(planning.plan().note == "");
}

TEST_CASE("a file that exists is replaced, which the plan says") {
    Planning planning;
    std::ofstream(planning.path("a.mp4")) << "old";
    CHECK(planning.plan().replaces);
    std::ofstream(planning.path("f_0000.png")) << "old";
    planning.form.file = "f_%04d.png";
    CHECK(planning.plan().replaces);
}

TEST_CASE("the list of file types changes the ending of the name") {
    CHECK(export_kind_of("a.MKV") == 2);
    CHECK(!export_kind_of("a"));
    const auto& kinds = export_kinds();
    CHECK(with_export_kind("a.mp4", kinds[1]) == "a.mov");
    CHECK(with_export_kind("b.c", kinds[0]) == "b.c.mp4");
    CHECK(with_export_kind("a.mp4", kinds[5]) == "a_%04d.png");
    CHECK(with_export_kind("a_%04d.png", kinds[6]) == "a_%04d.exr");
    CHECK(with_export_kind("a_%04d.png", kinds[0]) == "a.mp4");
}

TEST_CASE("pictures have sizes relative to the render size, or usual ones") {
    CHECK(still_extent("1x", {640, 480}) == Extent{640, 480});
    CHECK(still_extent("4x", {640, 480}) == Extent{2560, 1920});
    CHECK(still_extent("1080p", {640, 480}) == Extent{1920, 1080});
    const TemporaryFolder folder;
    StillForm form{.file = "a", .folder = folder.path(), .size = "2x"};
    const auto is_target = [&](const std::filesystem::path& file) {
        return file == folder / "b.png";
    };
    const auto settings = planned_still(form, {64, 48}, 3.0, is_target);
    REQUIRE(settings.has_value());
    CHECK(settings->file == folder / "a.png");
    CHECK(settings->size == Extent{128, 96});
    form.file = "b";
    CHECK(!planned_still(form, {64, 48}, 3.0, is_target));
    form.file = "a.jpg";
    CHECK(!planned_still(form, {64, 48}, 3.0, is_target));
    form.file = "a.avif";
    form.size = "4x";
    CHECK(!planned_still(form, {8192, 48}, 3.0, is_target));
}

TEST_CASE("the dialog for pictures says when the displayed picture has fewer bits than the file") {
    Look look;
    look.passes.resize(1);
    look.passes.back().format = Format::rgba8;
    StillForm form;
    CHECK(still_note(form, look).empty());
    form.format = 1;  // PNG with 16 bits
    CHECK(still_note(form, look) ==
          "The displayed picture has 8 bits. Other sizes are drawn with more.");
    look.passes.back().format = Format::rgba16f;
    CHECK(still_note(form, look).empty());
    form.size = "2x";
    CHECK(still_note(form, look) == "Rendered in the background at the current time.");
}
