#include "gpu/objects/canvas.h"
#include "gpu/objects/draw.h"
#include "gpu/objects/vertex_array.h"
#include "gpu/program.h"
#include "lab/small_lab.h"

#include <algorithm>
#include <set>

namespace {
void add_other_look(SmallLab& small) {
    small.write("../other/look.json",
                replaced(small_look::manifest, "\"name\": \"Small\"", "\"name\": \"Other\""));
    small.write("../other/sum.frag", small_look::sum);
    small.write("../other/show.frag", small_look::show);
    small.write("../other/gain.glsl", small_look::gain);
}

std::string open_look(const SmallLab& small) {
    return small.document().look().id;
}
}  // namespace

TEST_CASE("opening can be cancelled at any time, and the open look continues") {
    SmallLab small;
    add_other_look(small);
    for (int updates = 0; updates < 4; ++updates) {
        small.lab().looks().open("other");
        REQUIRE(small.lab().loader().is_loading());
        small.update(updates);
        if (open_look(small) == "other")
            break;  // a fast machine has opened it already
        small.lab().looks().cancel_opening();
        CHECK_FALSE(small.lab().loader().is_loading());
        const float frames = small.frames();
        small.update(30);
        CHECK(open_look(small) == "small");
        CHECK(small.frames() > frames);
        CHECK(small.lab().messages().problems().empty());
        CHECK(small.lab().messages().notice()->text == "Cancelled opening \"other\"");
        small.lab().looks().open("small");
        REQUIRE(small.update_until([&] { return !small.lab().loader().is_loading(); }));
    }
    small.lab().looks().open("other");
    CHECK(small.update_until([&] { return open_look(small) == "other"; }));
}

TEST_CASE("after cancelling, an edit of the open look is still drawn") {
    SmallLab small;
    add_other_look(small);
    small.lab().looks().open("other");
    small.lab().looks().cancel_opening();
    small.write("gain.glsl", "uniform float gain = 5.0;  // @range 0 8\n");
    std::set<std::string> shown_texts;
    CHECK(small.update_until([&] {
        shown_texts.insert(open_look(small));
        const Parameter* gain = find_parameter(small.document().look(), "gain");
        return gain && gain->initial == Value(5.0);
    }));
    CHECK(shown_texts == std::set<std::string>{"small"});
}

TEST_CASE("what follows an opening is called once for its look, and never for another one") {
    SmallLab small;
    add_other_look(small);
    const std::filesystem::path other = small.look_folder().parent_path() / "other";
    int calls = 0;
    const auto count = [&calls] { ++calls; };
    small.write("../other/sum.frag", "nonsense\n");
    small.lab().loader().open({other, {}, {}}, count);
    REQUIRE(small.update_until([&] { return small.lab().loader().failed() == "other"; }));
    small.lab().looks().dismiss_problems();
    REQUIRE(small.update_until([&] { return !small.lab().loader().is_loading(); }));
    small.update(5);
    CHECK(open_look(small) == "small");
    CHECK(calls == 0);

    small.write("../other/sum.frag", small_look::sum);
    small.lab().loader().open({other, {}, {}}, count);
    REQUIRE(small.update_until([&] { return open_look(small) == "other"; }));
    small.write("../other/gain.glsl", "uniform float gain = 3.0;  // @range 0 8\n");
    REQUIRE(small.update_until([&] {
        const Parameter* gain = find_parameter(small.document().look(), "gain");
        return gain && gain->initial == Value(3.0);
    }));
    CHECK(calls == 1);
}

TEST_CASE("of two looks opened in succession only the second one opens") {
    SmallLab small;
    add_other_look(small);
    small.write("../third/look.json", small_look::manifest);
    for (const char* file : {"sum.frag", "show.frag", "gain.glsl"})
        std::filesystem::copy_file(small.look_folder() / file,
                                   small.look_folder() / "../third" / file);
    small.lab().looks().open("other");
    small.lab().looks().open("third");
    std::set<std::string> shown_texts;
    CHECK(small.update_until([&] {
        shown_texts.insert(open_look(small));
        return open_look(small) == "third";
    }));
    CHECK_FALSE(shown_texts.contains("other"));
}

TEST_CASE("cancelling without an opening does nothing, and the thread ends on request") {
    SmallLab small;
    small.lab().looks().cancel_opening();
    CHECK(open_look(small) == "small");
    CHECK_FALSE(small.lab().messages().notice().has_value());
    CHECK_FALSE(small.lab().loader().opening().has_value());
    CHECK(small.lab().loader().worker().end(std::chrono::seconds(5)));
}

namespace {
const gpu::Context* context_of(const SmallLab& small) {
    return const_cast<SmallLab&>(small)
        .lab()
        .renderer()
        ->executor()
        .programs()
        .generic()
        .context.get();
}
}  // namespace

TEST_CASE("each look draws in its own context, and successive looks use two in turn") {
    SmallLab small;
    add_other_look(small);
    small.write("../other/gain.glsl", "uniform float gain = 3.0;  // @range 0 8\n");
    const gpu::Context* first = context_of(small);
    REQUIRE(first);
    CHECK(first != gpu::Context::current());
    small.lab().looks().open("other");
    REQUIRE(small.update_until([&] { return open_look(small) == "other"; }));
    small.wait_for_frames();
    const gpu::Context* second = context_of(small);
    REQUIRE(second);
    CHECK(second != first);
    small.lab().looks().open("small");
    REQUIRE(small.update_until([&] { return open_look(small) == "small"; }));
    small.wait_for_frames();
    CHECK(context_of(small) == first);
    CHECK(small.shown() == small.frames());
}

TEST_CASE("an edit, and the same look opened again, keep the look's context") {
    SmallLab small;
    const gpu::Context* context = context_of(small);
    small.write("gain.glsl", "uniform float gain = 2.0;  // @range 0 8\n");
    CHECK(small.update_until([&] { return small.shown() == 2.0f * small.frames(); }));
    CHECK(context_of(small) == context);
    small.lab().looks().open("small");
    REQUIRE(small.update_until([&] { return !small.lab().loader().is_loading(); }));
    CHECK(context_of(small) == context);
}

TEST_CASE("a text that returns after two other edits gets its earlier program") {
    SmallLab small;
    const auto programs = [&] {
        return small.lab().renderer()->executor().programs().generic().passes;
    };
    const auto edit = [&](const std::string& text, double initial) {
        small.write("gain.glsl", text);
        REQUIRE(small.update_until([&] {
            return find_parameter(small.document().look(), "gain")->initial == Value(initial) &&
                   !small.lab().loader().is_loading();
        }));
    };
    const double initial = find_parameter(small.document().look(), "gain")->initial.number();
    const auto before = programs();
    edit("uniform float gain = 5.0;  // @range 0 8\n", 5.0);
    CHECK_FALSE(
        std::ranges::equal(before, programs(), {}, &PassProgram::program, &PassProgram::program));
    edit("uniform float gain = 6.0;  // @range 0 8\n", 6.0);
    edit(small_look::gain, initial);
    CHECK(std::ranges::equal(before, programs(), {}, &PassProgram::program, &PassProgram::program));
}

TEST_CASE("a look draws nothing before its source is available") {
    SmallLab small;
    add_other_look(small);
    small.write("../other/look.json",
                replaced(small_look::manifest, "\"driven_by\": \"nothing\"",
                         "\"driven_by\": \"picture\", \"default_source\": \"pattern:smpte\""));
    bool has_drawn_without = false;
    small.lab().looks().open("other");
    CHECK(small.update_until([&] {
        if (open_look(small) != "other")
            return false;
        const Executor& executor = small.lab().renderer()->executor();
        const auto held = executor.textures().list();
        const bool has_source =
            std::ranges::find(held, Input::From::source, &TextureChoice::from) != held.end();
        has_drawn_without = has_drawn_without || (!executor.plan().targets.empty() && !has_source);
        return small.player().transport().frame_number() > 2;
    }));
    CHECK_FALSE(has_drawn_without);
}

// Mesa drops the bindings of a context when a program that was linked in it is deleted elsewhere.
TEST_CASE("the bindings of the window survive an edit of the look") {
    SmallLab small;
    Stage vertex;
    vertex.text =
        "#version 410 core\nvoid main() { gl_Position = vec4(gl_VertexID % 2 * 4 - 1, "
        "gl_VertexID / 2 * 4 - 1, 0.0, 1.0); }\n";
    Stage fragment;
    fragment.text = "#version 410 core\nout vec4 color;\nvoid main() { color = vec4(0.5); }\n";
    const auto panels = gpu::Program::build(vertex, fragment);
    REQUIRE(panels.has_value());
    const auto canvas = gpu::Canvas::make({4, 4}, Format::rgba32f);
    REQUIRE(canvas.has_value());
    const gpu::VertexArray vertices;
    const auto draw = [&] {
        canvas->bind();
        panels->use();
        vertices.bind();
        gpu::draw_triangle();
    };
    small.write("gain.glsl", "uniform float gain = 2.0;  // @range 0 8\n");
    CHECK(small.update_until([&] {
        draw();
        gpu::finish();
        return small.shown() == 2.0f * small.frames();
    }));
    canvas->clear();
    draw();
    CHECK(gpu::read_pixel(canvas->texture(), 1, 1)[0] == 0.5f);
}
