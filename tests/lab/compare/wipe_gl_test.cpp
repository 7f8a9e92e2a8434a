// The wipe between the original article's picture and the look's own, in the window.
#include "gpu/headless_context.h"
#include "lab/session.h"
#include "lab/small_lab.h"
#include "lab/views/views.h"

namespace {
constexpr const char* with_a_switch = R"(#version 410 core
uniform sampler2D previous;
uniform float step_size = 1.0;  // @range 0 4
uniform bool as_written = false;
in vec2 uv;
out vec4 color;
void main() { color = texture(previous, uv) + (as_written ? 3.0 * step_size : step_size); }
)";

constexpr const char* sample = R"(#version 410 core
uniform bool as_written = false;
out vec4 color;
void main() { color = vec4(as_written ? 3.0 : 1.0); }
)";

constexpr const char* that_accumulates = R"({
  "format": "afterglow-look", "version": 1, "name": "Small", "driven_by": "nothing", "settle_frames": 20,
  "passes": [
    { "name": "sum", "fragment": "sum.frag", "format": "rgba32f", "blend": "add", "accumulate": true, "converge": 6 },
    { "name": "show", "fragment": "show.frag", "format": "rgba32f", "inputs": { "image": "sum" } }
  ]
})";

/// A look whose picture grows by 1 per frame, and by 3 in the article version.
class Wiping : public SmallLab {
public:
    Wiping() {
        write_by_rename("sum.frag", with_a_switch);
        REQUIRE(update_until([&] { return find_parameter(document().look(), "as_written"); }));
    }
    void set(const char* name, double value) {
        lab().edit([&](Document& document) { document.set_value(name, Value(value)); });
    }
    void rest() {
        REQUIRE(update_until([&] { return !lab().is_moving(); }));
    }
    /// Turns the wipe on and waits until the history of the other side is drawn.
    void wipe() {
        lab().frames().comparison().set_mode(CompareMode::wipe);
        REQUIRE(update_until([&] { return lab().frames().comparison().sides().has_value(); }));
        for (int i = 0; i < 1000 && lab().renderer()->replay().is_running(); ++i)
            update(1);
    }
    float shown_beside() {
        return gpu::read_pixel(lab().renderer()->executors().variant()->target(1), 3, 3)[0];
    }
};
}  // namespace

TEST_CASE("the article's picture is drawn from the frames that led to the current one") {
    Wiping small;
    small.update(6);
    small.lab().player().pause();
    small.update(1);
    const float frames = small.frames();
    const float shown = small.shown();
    CHECK(small.lab().renderer()->executors().variant() == nullptr);

    small.wipe();
    small.rest();
    CHECK(small.shown() == shown);
    CHECK(small.shown_beside() == 3 * std::min(frames, 20.0f));  // settle_frames is 20
    CHECK(small.frames() == frames);
    CHECK(small.lab().frames().comparison().sides()->left_name() == "Original article");
    CHECK(small.document().values().empty());
    CHECK_FALSE(small.document().history().can_undo());

    small.lab().player().play();
    small.update(4);
    CHECK(small.frames() == frames + 4);
    CHECK(small.shown() == shown + 4);
    CHECK(small.shown_beside() == 3 * (std::min(frames, 20.0f) + 4));

    small.lab().frames().comparison().set_mode(CompareMode::off);
    small.update(1);
    CHECK(small.lab().renderer()->executors().variant() == nullptr);
    CHECK(small.shown() == shown + 5);
}

TEST_CASE("an active wipe is restored at the next start") {
    Wiping small;
    CHECK(session_of(small.lab(), {}).comparison.mode == CompareMode::off);
    small.wipe();
    const Session session = session_of(small.lab(), {});
    CHECK(session.comparison.mode == CompareMode::wipe);
    small.start();
    restore(small.lab(), session);
    REQUIRE(
        small.update_until([&] { return small.lab().frames().comparison().sides().has_value(); }));
    CHECK(small.update_until([&] { return small.shown_beside() > 0.0f; }));
}

TEST_CASE("during playback time waits until the history of the other side is drawn") {
    Wiping small;
    small.update(30);
    const float frames = small.frames();
    small.wipe();
    CHECK(small.frames() == frames);
    CHECK(small.shown_beside() == 60);
    small.update(2);
    CHECK(small.frames() == frames + 2);
    CHECK(small.shown_beside() == 66);
}

TEST_CASE("changes of values, shaders and the size affect both sides of a wipe") {
    Wiping small;
    small.wipe();
    SUBCASE("a parameter without history") {
        small.set("gain", 2.0);
        small.update(1);
        CHECK(
            gpu::read_pixel(small.lab().renderer()->executors().variant()->target(1), 3, 3)[0] ==
            2 * gpu::read_pixel(small.lab().renderer()->executors().variant()->target(0), 3, 3)[0]);
        CHECK(small.shown() ==
              2 * gpu::read_pixel(small.lab().renderer()->executor().target(0), 3, 3)[0]);
    }
    SUBCASE("a parameter with history, while paused") {
        small.lab().player().pause();
        small.set("step_size", 2.0);
        small.update(1);
        small.rest();
        CHECK(small.shown_beside() == 3 * small.shown());
        CHECK(small.shown() == 2 * std::min(small.frames(), 20.0f));
    }
    SUBCASE("the switch itself, which does not swap the sides") {
        small.lab().player().pause();
        small.set("as_written", 1.0);
        small.update(1);
        small.rest();
        CHECK(small.shown() == 3 * small.shown_beside());
        CHECK(small.lab().frames().comparison().sides()->left_name() == "Original article");
        CHECK_FALSE(small.lab().frames().comparison().sides()->is_other_left);
    }
    SUBCASE("a shader") {
        small.write_by_rename("show.frag",
                              replaced(small_look::show, "* gain", "* gain * 0.0 + 7.0"));
        CHECK(small.update_until([&] { return small.shown_beside() == 7 && small.shown() == 7; }));
    }
    SUBCASE("the size") {
        small.lab().work().size.choose({false, {16, 4}, 1.0});
        small.update(1);
        CHECK(small.lab().renderer()->executors().variant()->target(1).extent() == Extent{16, 4});
        CHECK(small.lab().renderer()->executor().target(1).extent() == Extent{16, 4});
    }
}

TEST_CASE("drawing the history of the other side can be cancelled") {
    Wiping small;
    small.update(30);
    small.lab().frames().comparison().set_mode(CompareMode::wipe);
    small.lab().update(0.0);  // may have drawn all of it already
    small.lab().frames().cancel_replay();
    const float frames = small.frames();
    small.update(2);
    CHECK(small.frames() == frames + 2);
    CHECK(small.lab().frames().comparison().sides().has_value());
}

TEST_CASE("a wipe on a look without the switch reports the missing switch") {
    SmallLab small;
    small.lab().frames().comparison().set_mode(CompareMode::wipe);
    small.update(1);
    CHECK_FALSE(small.lab().frames().comparison().sides());
    REQUIRE(small.lab().messages().notice());
    CHECK(small.lab().messages().notice()->text.find("no switch as_written") != std::string::npos);
}

TEST_CASE("both sides of an accumulating look take all their samples and stop") {
    Wiping small;
    small.write_by_rename("sum.frag", sample);
    small.write_by_rename("look.json", that_accumulates);
    REQUIRE(small.update_until(
        [&] { return small.shown() == 6 && small.lab().frames().has_converged(); }));
    small.wipe();
    REQUIRE(small.update_until([&] { return small.lab().frames().has_converged(); }));
    small.rest();
    CHECK(small.lab().renderer()->executors().variant()->drawer().samples()->held == 6);
    CHECK(small.shown() == 6);
    CHECK(small.shown_beside() == 18);
}

namespace {
/// A lab with the built-in looks.
class RealLab {
public:
    explicit RealLab(const std::string& look) {
        auto context = gpu::create_headless_context();
        REQUIRE(context.has_value());
        m_context = std::move(*context);
        auto worker = gpu::Context::shared_with(*m_context);
        REQUIRE(worker.has_value());
        const Roots roots{AFTERGLOW_SOURCE_DIR, m_folder / "user", m_folder / "state"};
        m_lab = std::make_unique<Lab>(Library(roots), *m_context, std::move(*worker));
        m_lab->work().size.choose({false, {48, 36}, 1.0});
        m_lab->looks().open(look);
        update_until([&] { return m_lab->player().transport().frame_number() > 5; });
        m_lab->player().pause();
        m_lab->update(0.0);
        auto views = Views::make();
        REQUIRE(views.has_value());
        m_views = std::make_unique<Views>(std::move(*views));
        m_window.views.sizes.picture = {48, 36};
    }
    RealLab(const RealLab&) = delete;
    RealLab& operator=(const RealLab&) = delete;
    ~RealLab() {
        m_context->make_current();
        m_views.reset();
        m_lab.reset();
    }

    template <class Condition>
    void update_until(Condition condition) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (!condition()) {
            REQUIRE(std::chrono::steady_clock::now() < end);
            m_lab->update(1.0 / 60.0);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
    /// The pixels of the view when nothing changes any more, RGBA.
    std::vector<float> view() {
        m_lab->update(0.0);
        update_until([&] { return !m_lab->is_moving(); });
        m_views->update(*m_lab, m_window);
        return m_views->main().read_picture().pixels;
    }
    void set_all(const std::vector<std::string>& switches, double value) {
        m_lab->edit([&](Document& document) {
            for (const std::string& name : switches)
                document.set_value(name, Value(value));
        });
    }
    Lab& lab() { return *m_lab; }
    WindowState& window() { return m_window; }

private:
    TemporaryFolder m_folder;
    std::unique_ptr<gpu::Context> m_context;
    std::unique_ptr<Lab> m_lab;
    std::unique_ptr<Views> m_views;
    WindowState m_window;
};

struct Sides {
    double left = 0.0;  // the largest difference on this side
    double right = 0.0;
};

Sides differences(const std::vector<float>& a, const std::vector<float>& b, std::size_t line) {
    constexpr std::size_t width = 48;
    REQUIRE(a.size() == b.size());
    Sides sides;
    for (std::size_t i = 0; i < a.size(); ++i) {
        double& side = i / 4 % width < line ? sides.left : sides.right;
        side = std::max(side, std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
    }
    return sides;
}
}  // namespace

TEST_CASE("left of the line is the exact article picture, right of it the look's own") {
    struct Case {
        const char* look;
        std::vector<std::string> switches;
    };
    for (const Case& each : {Case{"phosphor", {"as_written"}}, Case{"shadow-mask", {"as_written"}},
                             Case{"phosphor+crt", {"phosphor/as_written", "crt/as_written"}}}) {
        CAPTURE(each.look);
        RealLab real(each.look);
        const std::vector<float> ours = real.view();
        real.window().views.wipe_share = 0.25;
        real.lab().frames().comparison().set_mode(CompareMode::wipe);
        const std::vector<float> wiped = real.view();
        real.lab().frames().comparison().set_mode(CompareMode::off);
        CHECK(differences(real.view(), ours, 12).left == 0.0);
        real.set_all(each.switches, 1.0);
        const std::vector<float> article = real.view();

        CHECK(differences(wiped, article, 12).left == 0.0);
        CHECK(differences(wiped, ours, 12).right == 0.0);
        CHECK(differences(article, ours, 12).left > 0.01);
        CHECK(differences(article, ours, 12).right > 0.01);
    }
}

TEST_CASE("the line of a wipe covers the visible part of the picture") {
    const PicturePosition small{10.0, 5.0, 2.0};  // 100 px wide, from 10 to 210
    CHECK(wipe_column(small, {100, 50}, {400, 200}, 0.0) == 10);
    CHECK(wipe_column(small, {100, 50}, {400, 200}, 0.5) == 110);
    CHECK(wipe_column(small, {100, 50}, {400, 200}, 1.0) == 210);
    const PicturePosition cut{-300.0, 0.0, 8.0};  // exceeds the view on both sides
    CHECK(wipe_column(cut, {100, 50}, {400, 200}, 0.5) == 200);
    CHECK(wipe_share(cut, {100, 50}, {400, 200}, 100.0) == doctest::Approx(0.25));
    CHECK(wipe_share(small, {100, 50}, {400, 200}, 900.0) == 1.0);
    CHECK(wipe_share(small, {100, 50}, {400, 200}, -5.0) == 0.0);
}
