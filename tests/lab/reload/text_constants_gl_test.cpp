// Annotated constants in the texts of a look: a changed value rebuilds the programs in the
// background.
#include "formats/settings/session_format.h"
#include "lab/document/parameter_edits.h"
#include "lab/offline/offline.h"
#include "lab/session.h"
#include "lab/small_lab.h"
#include "model/tuning/modulation.h"
#include "problems_of.h"

#include <algorithm>
#include <cmath>

namespace fs = std::filesystem;

namespace {
// The red channel is LEVEL + more.
constexpr const char* text =
    "#define LEVEL 0.25  // @range 0 1\n"
    "#define SIZE 1      // @range 0 4\n"
    "uniform float more = 0.0;  // @range 0 1\n"
    "void mainImage(out vec4 c, in vec2 p) {\n"
    "    float kept[SIZE];\n"
    "    kept[0] = LEVEL + more;\n"
    "    c = vec4(kept[0], 0.0, 0.0, 1.0);\n"
    "}\n";

/// A lab with one Shadertoy shader.
class ConstantLab : public SmallLab {
public:
    ConstantLab() {
        m_file = folder() / "a.glsl";
        REQUIRE(write_atomically(m_file, std::string_view(text)).has_value());
        lab().looks().open(m_file.string());
        REQUIRE(update_until([&] { return is_at(0.25); }));
    }
    void set(const char* name, double value, bool continues_step = false) {
        lab().edit([&](Document& document) {
            document.set_value(name, Value(value), continues_step);
            if (!continues_step)
                document.finish();
        });
    }
    double red(const Executor& executor) {
        return static_cast<double>(gpu::read_pixel(executor.target(0), 3, 3)[0]);
    }
    double red() { return red(lab().renderer()->executor()); }
    // To 8-bit precision.
    bool is_at(double level) {
        return document().look().id == "a.glsl" && std::abs(red() - level) < 0.003;
    }
    bool becomes(double level) {
        return update_until([&] { return is_at(level) && !lab().loader().is_loading(); });
    }
    const fs::path& file() const { return m_file; }

private:
    fs::path m_file;
};

double rendered_red(RenderRequest request) {
    const auto roots = find_roots({});
    REQUIRE(roots.has_value());
    request.size = {4, 4};
    auto prepared = prepare(request, Library(*roots));
    REQUIRE_MESSAGE(prepared.has_value(), problems_of(prepared));
    auto offline = Offline::create(std::move(*prepared), request.size, 60.0);
    REQUIRE_MESSAGE(offline.has_value(), problems_of(offline));
    return static_cast<double>(offline->picture_after(1).pixels[0]);
}
}  // namespace

TEST_CASE("constants follow changes, undo, redo, reset and a reload of the file") {
    ConstantLab small;
    small.set("LEVEL", 0.75);
    CHECK(small.becomes(0.75));
    CHECK(small.document().look().constants.at("LEVEL") == Value(0.75));
    small.lab().edit([](Document& document) { document.undo(); });
    CHECK(small.becomes(0.25));
    small.lab().edit([](Document& document) { document.redo(); });
    CHECK(small.becomes(0.75));

    // The edit changes other text of the file; the value stays.
    REQUIRE(write_atomically(small.file(), replaced(text, "LEVEL + more", "LEVEL - 0.5 + more"))
                .has_value());
    CHECK(small.becomes(0.25));
    small.lab().edit([](Document& document) { reset_parameters(document, {"LEVEL"}); });
    CHECK(small.update_until([&] {
        return small.document().look().constants.at("LEVEL") == Value(0.25) && small.is_at(0.0);
    }));
}

TEST_CASE("dragging a constant shows intermediate values in order, then the last one") {
    ConstantLab small;
    std::vector<double> shown_levels;
    double value = 0.3;
    // Like a drag: a new value in each update, whether or not the previous one is compiled.
    REQUIRE(small.update_until([&] {
        value = std::min(value + 0.0005, 1.0);
        small.set("LEVEL", value, true);
        const double compiled = small.document().look().constants.at("LEVEL").number();
        if (shown_levels.empty() || compiled != shown_levels.back())
            shown_levels.push_back(compiled);
        return shown_levels.size() > 4;
    }));
    CHECK(std::ranges::is_sorted(shown_levels));
    CHECK(small.lab().document()->history().is_in_gesture());
    small.set("LEVEL", 0.875);
    CHECK(small.becomes(0.875));
    CHECK_FALSE(small.lab().loader().opening().has_value());
}

TEST_CASE("a value that does not compile is reported at its line, and the picture stays") {
    ConstantLab small;
    small.set("SIZE", 0.0);
    REQUIRE(small.update_until([&] { return !small.lab().messages().problems().empty(); }));
    CHECK(small.lab().messages().problems().front().diagnostic.line == 5);
    REQUIRE(small.update_until([&] { return !small.lab().loader().is_loading(); }));
    CHECK(small.is_at(0.25));
    small.update(20);
    CHECK_FALSE(small.lab().loader().is_loading());  // it is tried once
    small.set("SIZE", 2.0);
    CHECK(small.update_until([&] { return small.lab().messages().problems().empty(); }));
    small.set("LEVEL", 0.5);
    CHECK(small.becomes(0.5));
}

TEST_CASE("a changed constant is drawn while paused") {
    ConstantLab small;
    small.lab().player().pause();
    small.update(3);
    small.set("LEVEL", 0.625);
    CHECK(small.becomes(0.625));
    CHECK(small.update_until([&] { return !small.lab().is_moving(); }));
}

TEST_CASE("a constant cannot be modulated, and the reason is reported") {
    ConstantLab small;
    const Look& look = small.document().look();
    CHECK(why_unmodulated(look, *find_parameter(look, "more")).empty());
    CHECK(why_unmodulated(look, *find_parameter(look, "LEVEL")) ==
          "'LEVEL' can't be modulated: changing it recompiles the look");
}

TEST_CASE("each side of a comparison has its own constants") {
    ConstantLab small;
    small.lab().frames().comparison().store(0);
    small.set("LEVEL", 0.75);
    REQUIRE(small.becomes(0.75));
    small.lab().frames().comparison().choose({{Other::Kind::slot, 0, {}}, CompareMode::wipe});
    const auto other_is = [&](double level) {
        return small.update_until([&] {
            const Executor* other = small.lab().renderer()->executors().variant();
            return other && small.lab().frames().comparison().sides() &&
                   std::abs(small.red(*other) - level) < 0.003;
        });
    };
    CHECK(other_is(0.25));
    CHECK(small.is_at(0.75));
    small.set("LEVEL", 0.5);
    CHECK(small.becomes(0.5));
    CHECK(other_is(0.25));
    small.set("more", 0.25);
    CHECK(small.becomes(0.75));
    CHECK(other_is(0.25));
    small.set("LEVEL", 0.25);
    CHECK(small.becomes(0.5));
    CHECK(other_is(0.25));
}

TEST_CASE("a session restores changed constants") {
    ConstantLab small;
    small.set("LEVEL", 0.75);
    REQUIRE(small.becomes(0.75));
    const Session session = session_of(small.lab(), {});
    small.start();
    restore(small.lab(), session, {});
    REQUIRE(small.update_until(
        [&] { return small.lab().document() && !small.lab().loader().is_loading(); }));
    CHECK(small.document().look().constants.at("LEVEL") == Value(0.75));
    CHECK(small.becomes(0.75));
}

TEST_CASE("offline rendering uses constants from values and from automation") {
    const TemporaryFolder folder;
    const std::string look = folder.write("a.glsl", text).string();
    CHECK(std::abs(rendered_red({.look = look}) - 0.25) < 0.003);
    CHECK(std::abs(rendered_red({.look = look, .values = {{"LEVEL", "0.5"}, {"more", "0.25"}}}) -
                   0.75) < 0.003);
    const auto automation = folder.write("moves.txt", "0 LEVEL 1\n");
    CHECK(std::abs(rendered_red({.look = look, .automation = automation.string()}) - 1.0) < 0.003);
}

TEST_CASE("each copy of a look in a stack has its own constants") {
    const TemporaryFolder folder;
    const std::string file = folder
                                 .write("a.frag",
                                        "#define LEVEL 0.25  // @range 0 1\n"
                                        "uniform sampler2D texture0;\n"
                                        "varying vec2 v;\n"
                                        "void main() {\n"
                                        "    gl_FragColor = texture2D(texture0, v) * LEVEL;\n"
                                        "}\n")
                                 .string();
    const auto roots = find_roots({});
    REQUIRE(roots.has_value());
    const auto prepared = prepare(
        {.look = file + "+" + file, .values = {{"a.frag/LEVEL", "0.5"}, {"a.frag#2/LEVEL", "1"}}},
        Library(*roots));
    REQUIRE_MESSAGE(prepared.has_value(), problems_of(prepared));
    const Look& look = prepared->document.look();
    CHECK(look.constants.at("a.frag/LEVEL") == Value(0.5));
    CHECK(look.constants.at("a.frag#2/LEVEL") == Value(1.0));
    CHECK(look.passes.front().fragment.text->find("LEVEL 0.5 ") != std::string::npos);
    CHECK(look.passes.back().fragment.text->find("LEVEL 1.0 ") != std::string::npos);
}
