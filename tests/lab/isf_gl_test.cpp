// Output of ISF shaders, rule by rule.
#include "io/pictures/picture_file.h"
#include "io/temporary_folder.h"
#include "lab/document/sharing.h"
#include "lab/offline/export_output.h"
#include "lab/offline/offline.h"
#include "problems_of.h"

#include <doctest/doctest.h>

#include <cmath>

namespace {
const std::string float_picture = R"("PASSES": [{"FLOAT": true}])";

/// Draws a.fs, made of the members of its header and GLSL code.
class DrawnIsf {
public:
    DrawnIsf(const std::string& members, const std::string& code) {
        m_folder.write("a.fs", "/*{" + members + "}*/\n" + code);
        m_request.look = (m_folder / "a.fs").string();
        m_request.size = {8, 4};
    }

    RenderRequest& request() { return m_request; }
    void expect_warning() { m_is_warned = true; }
    void write(const std::string& name, const std::string& text) { m_folder.write(name, text); }
    void set_source(const Picture& picture) {
        m_request.source = (m_folder / "source.png").string();
        REQUIRE(save_picture(picture, m_request.source).has_value());
    }

    Offline opened() const {
        const auto roots = find_roots({});
        REQUIRE(roots.has_value());
        auto prepared = prepare(m_request, Library(*roots));
        REQUIRE_MESSAGE(prepared.has_value(), problems_of(prepared));
        CHECK(prepared->warnings.empty() != m_is_warned);
        auto offline = Offline::create(std::move(*prepared), m_request.size, 60.0);
        REQUIRE_MESSAGE(offline.has_value(), problems_of(offline));
        return std::move(*offline);
    }
    Picture after(int frames) const {
        Offline offline = opened();
        Picture picture = offline.picture_after(frames);
        CHECK(to_string(offline.take_problems()) == "");
        return picture;
    }
    /// The first frame, saved as a PNG and loaded again.
    Picture saved() const {
        Offline offline = opened();
        Roots roots;
        roots.state = m_folder.path();
        const auto file = m_folder / "saved.png";
        REQUIRE(save_picture_with_preset(offline.picture_after(1), offline.document(), file,
                                         RecentMedia(roots)));
        return load_picture(file).value();
    }
    /// Frame `number` of an exported sequence of two.
    Picture exported(int number) const {
        Offline offline = opened();
        const auto go_on = [](std::int64_t) { return true; };
        Diagnostics warnings;
        REQUIRE(export_to((m_folder / "f%d.png").string(), offline,
                          {.part = {0, 2}, .pass = 0, .should_continue = go_on}, warnings));
        return load_picture(m_folder / ("f" + std::to_string(number) + ".png")).value();
    }

private:
    TemporaryFolder m_folder;
    RenderRequest m_request;
    bool m_is_warned = false;
};

std::vector<float> texel(const Picture& picture, int x, int y) {
    const auto first = picture.pixels.begin() + static_cast<std::ptrdiff_t>(picture.index(x, y));
    return {first, first + picture.channels};
}

void check_near(const std::vector<float>& texel, const std::vector<double>& expected) {
    REQUIRE(texel.size() == expected.size());
    for (std::size_t i = 0; i < texel.size(); ++i)
        CHECK(static_cast<double>(texel[i]) == doctest::Approx(expected[i]).epsilon(1e-5));
}

const std::string draws_orange = "void main() { gl_FragColor = vec4(1.0, 0.6, 0.2, 1.0); }\n";

/// Red counts columns, green rows from the top, in steps of 32 / 255.
Picture isf_source() {
    Picture picture{{8, 4}, 4, Encoding::display, {}};
    for (int i = 0; i < 32; ++i)
        for (const int bytes : {i % 8 * 32, i / 8 * 32, 255, 255})
            picture.pixels.push_back(static_cast<float>(bytes) / 255.0f);
    return picture;
}
}  // namespace

TEST_CASE("an ISF shader gets its time, size and frame number") {
    const DrawnIsf drawn(float_picture,
                         "void main() { gl_FragColor = vec4(TIME, TIMEDELTA, FRAMEINDEX, "
                         "RENDERSIZE.x * 100.0 + RENDERSIZE.y); }\n");
    check_near(texel(drawn.after(1), 0, 0), {0.0, 0.0, 0.0, 804.0});
    check_near(texel(drawn.after(31), 0, 0), {0.5, 1.0 / 60.0, 30.0, 804.0});
}

TEST_CASE("DATE is constant when rendering to a file") {
    const DrawnIsf drawn(float_picture, "void main() { gl_FragColor = DATE; }\n");
    check_near(texel(drawn.after(60), 0, 0), {2000.0, 1.0, 1.0, 1.0});
}

TEST_CASE("each pass has its index and the size of its own target") {
    const DrawnIsf drawn(
        R"("PASSES": [{"TARGET": "a", "WIDTH": 3, "HEIGHT": "$HEIGHT/2", "FLOAT": 1}, {"FLOAT": true}])",
        "void main() {\n"
        "  if (PASSINDEX == 0) gl_FragColor = vec4(RENDERSIZE, PASSINDEX, 1);\n"
        "  else gl_FragColor = vec4(IMG_THIS_PIXEL(a).xy, IMG_SIZE(a));\n}\n");
    check_near(texel(drawn.after(1), 7, 3), {3.0, 2.0, 3.0, 2.0});
}

TEST_CASE("a persistent target keeps its previous frame, and others start empty") {
    const std::string code =
        "void main() {\n"
        "  if (PASSINDEX == 0) gl_FragColor = IMG_THIS_PIXEL(count) + vec4(1);\n"
        "  else gl_FragColor = IMG_THIS_PIXEL(count);\n}\n";
    const DrawnIsf kept(
        R"("PASSES": [{"TARGET": "count", "PERSISTENT": true, "FLOAT": true}, {"FLOAT": true}])",
        code);
    check_near(texel(kept.after(7), 3, 2), {7.0, 7.0, 7.0, 7.0});
    const DrawnIsf fresh(R"("PASSES": [{"TARGET": "count", "FLOAT": true}, {"FLOAT": true}])",
                         code);
    check_near(texel(fresh.after(7), 3, 2), {1.0, 1.0, 1.0, 1.0});
}

TEST_CASE("a last pass with a target is the picture and the input of the next frame") {
    const DrawnIsf drawn(R"("PASSES": [{"TARGET": "all", "PERSISTENT": true, "FLOAT": true}])",
                         "void main() { gl_FragColor = IMG_THIS_PIXEL(all) + vec4(0.5); }\n");
    check_near(texel(drawn.after(4), 0, 0), {2.0, 2.0, 2.0, 2.0});
}

TEST_CASE("two passes write the same target in sequence") {
    // Each frame computes 2 x + 1 twice.
    const DrawnIsf drawn(
        R"("PASSES": [{"TARGET": "t", "PERSISTENT": true, "FLOAT": true}, {"TARGET": "t"},
                      {"FLOAT": true}])",
        "void main() {\n"
        "  vec4 was = IMG_THIS_PIXEL(t);\n"
        "  gl_FragColor = PASSINDEX == 2 ? was : was * 2.0 + 1.0;\n}\n");
    check_near(texel(drawn.after(1), 0, 0), {3.0, 3.0, 3.0, 3.0});
    check_near(texel(drawn.after(3), 0, 0), {63.0, 63.0, 63.0, 63.0});
}

TEST_CASE("a last pass with a size fills the whole picture with linear filtering") {
    const DrawnIsf drawn(R"("PASSES": [{"WIDTH": 2, "HEIGHT": 1, "FLOAT": true}])",
                         "void main() { gl_FragColor = vec4(RENDERSIZE, floor(gl_FragCoord.x), "
                         "1.0); }\n");
    const Picture picture = drawn.after(1);
    REQUIRE(picture.extent == Extent{8, 4});
    // Eight columns over two texels with centres at 2 and 6: 0 and 1 outside of them, steps of a
    // quarter between.
    const std::vector<double> across{0.0, 0.0, 0.125, 0.375, 0.625, 0.875, 1.0, 1.0};
    for (int x = 0; x < 8; ++x)
        check_near(texel(picture, x, 2), {2.0, 1.0, across[static_cast<std::size_t>(x)], 1.0});
}

TEST_CASE("coordinates start at the bottom left") {
    const DrawnIsf drawn(
        float_picture,
        "void main() { gl_FragColor = vec4(isf_FragNormCoord, gl_FragCoord.xy); }\n");
    check_near(texel(drawn.after(1), 0, 3), {0.5 / 8.0, 0.5 / 4.0, 0.5, 0.5});
    check_near(texel(drawn.after(1), 7, 0), {7.5 / 8.0, 3.5 / 4.0, 7.5, 3.5});
}

TEST_CASE("every way to read the source of a filter returns its texels upright") {
    for (const char* read :
         {"IMG_THIS_PIXEL(inputImage)", "IMG_THIS_NORM_PIXEL(inputImage)",
          "IMG_PIXEL(inputImage, gl_FragCoord.xy)", "IMG_PIXEL(inputImage, gl_FragCoord.xy, 0.0)",
          "IMG_NORM_PIXEL(inputImage, isf_FragNormCoord)",
          "IMG_NORM_PIXEL(inputImage, gl_FragCoord.xy / _inputImage_imgSize)"}) {
        CAPTURE(read);
        DrawnIsf drawn(float_picture + R"(, "INPUTS": [{"NAME": "inputImage", "TYPE": "image"}])",
                       std::string("void main() { gl_FragColor = ") + read + "; }\n");
        drawn.set_source(isf_source());
        const Picture picture = drawn.after(1);
        for (const auto& [x, y] : {std::pair(0, 0), std::pair(7, 0), std::pair(3, 2)})
            CHECK(texel(picture, x, y)[0] == doctest::Approx(x * 32 / 255.0).epsilon(1e-3));
        CHECK(texel(picture, 2, 3)[1] == doctest::Approx(3 * 32 / 255.0).epsilon(1e-3));
    }
}

TEST_CASE("a transition goes from the source to another picture") {
    DrawnIsf drawn(float_picture +
                       R"(, "INPUTS": [{"NAME": "startImage", "TYPE": "image"},
                           {"NAME": "endImage", "TYPE": "image"},
                           {"NAME": "progress", "TYPE": "float", "DEFAULT": 0.0}])",
                   "void main() { gl_FragColor = mix(IMG_THIS_PIXEL(startImage), "
                   "IMG_THIS_PIXEL(endImage), progress); }\n");
    drawn.set_source({{1, 1}, 4, Encoding::display, {0.2f, 0.4f, 0.6f, 1.0f}});
    CHECK(texel(drawn.after(1), 4, 1)[0] == doctest::Approx(0.2).epsilon(1e-3));
    drawn.request().values = {{"progress", "1"}};
    // The top left bar of SMPTE is 75 % grey.
    const auto bar = texel(drawn.after(1), 0, 0);
    CHECK(bar[0] == doctest::Approx(0.75).epsilon(0.01));
    CHECK(bar[1] == bar[0]);
    CHECK(bar[2] == bar[0]);
}

TEST_CASE("inputs have the values that the header defines") {
    DrawnIsf drawn(
        float_picture + R"(, "INPUTS": [
        {"NAME": "tint", "TYPE": "color", "DEFAULT": [0.5, 0.25, 1.0, 0.75]},
        {"NAME": "at", "TYPE": "point2D", "DEFAULT": [-3, 40], "MIN": [-5, 0], "MAX": [5, 100]},
        {"NAME": "kind", "TYPE": "long", "VALUES": [3, 9], "LABELS": ["a", "b"], "DEFAULT": 9},
        {"NAME": "on", "TYPE": "bool", "DEFAULT": 1},
        {"NAME": "page", "TYPE": "long", "MIN": 0, "MAX": 2, "DEFAULT": 0}])",
        "void main() { gl_FragColor = page == 0 ? tint : vec4(at, kind, on ? 1 : 0); }\n");
    check_near(texel(drawn.after(1), 0, 0), {0.5, 0.25, 1.0, 0.75});
    drawn.request().values = {{"page", "1"}};
    check_near(texel(drawn.after(1), 0, 0), {-3.0, 40.0, 9.0, 1.0});
    drawn.request().values = {{"page", "1"}, {"kind", "a"}, {"on", "false"}};
    check_near(texel(drawn.after(1), 0, 0), {-3.0, 40.0, 3.0, 0.0});
}

TEST_CASE("code for older compilers draws: an int returned as float, own noise functions") {
    DrawnIsf drawn(float_picture,
                   "float one() { return 1; }\nfloat noise1(float sample) { return sample; }\n"
                   "void main() { gl_FragColor = vec4(one(), noise1(0.5), 0, 1); }\n");
    drawn.expect_warning();
    check_near(texel(drawn.after(1), 0, 0), {1.0, 0.5, 0.0, 1.0});
}

TEST_CASE("an event is on only in the first frame of a file") {
    DrawnIsf drawn(
        R"("INPUTS": [{"NAME": "hit", "TYPE": "event"}],
           "PASSES": [{"TARGET": "hits", "PERSISTENT": true, "FLOAT": true}])",
        "void main() { gl_FragColor = IMG_THIS_PIXEL(hits) + vec4(hit ? 1.0 : 0.0); }\n");
    CHECK(texel(drawn.after(5), 0, 0)[0] == 0.0f);
    drawn.request().values = {{"hit", "true"}};
    CHECK(texel(drawn.after(5), 0, 0)[0] == 1.0f);
}

TEST_CASE("a custom vertex shader moves the picture and writes varyings") {
    DrawnIsf drawn(float_picture,
                   "in vec2 turned;\nvoid main() { gl_FragColor = vec4(turned, 0, 1); }\n");
    drawn.write(
        "a.vs",
        "out vec2 turned;\nvoid main() {\n  isf_vertShaderInit();\n"
        "  turned = isf_FragNormCoord.yx;\n  gl_Position.x = gl_Position.x * 0.5 - 0.5;\n}\n");
    const Picture picture = drawn.after(1);
    check_near(texel(picture, 0, 3), {0.5 / 4.0, 0.5 / 4.0, 0.0, 1.0});
    check_near(texel(picture, 4, 3), {0.0, 0.0, 0.0, 0.0});  // the right half stays empty
}

TEST_CASE("a shader with audio inputs reads the sound of the signal") {
    DrawnIsf drawn(float_picture +
                       R"(, "INPUTS": [{"NAME": "wave", "TYPE": "audio", "MAX": 16},
                                       {"NAME": "tones", "TYPE": "audioFFT", "MAX": 1024}])",
                   "void main() { gl_FragColor = vec4(IMG_PIXEL(wave, vec2(5.5, 0.5)).r, "
                   "IMG_PIXEL(wave, vec2(5.5, 1.5)).r, IMG_SIZE(tones).x, "
                   "IMG_PIXEL(tones, vec2(32.5, 0.5)).g); }\n");
    // 12.5 cycles in 1/60 s are 750 Hz, bin 32 of 2048 samples at 48 kHz.
    drawn.request().signal = "lissajous:x=12.5,y=12.5,phase=0.25,amplitude=0.5";
    const auto heard = texel(drawn.after(60), 0, 0);
    const double left = 2.0 * heard[0] - 1.0;
    const double right = 2.0 * heard[1] - 1.0;
    CHECK(std::hypot(left, right) == doctest::Approx(0.5).epsilon(1e-2));
    CHECK(heard[2] == 1024.0f);
    CHECK(heard[3] == doctest::Approx(0.5).epsilon(1e-2));
}

TEST_CASE("a cube is read by direction: a sky by default, then the chosen faces") {
    DrawnIsf drawn(R"("INPUTS": [{"NAME": "room", "TYPE": "cube"}], )" + float_picture,
                   "void main() {\n"
                   "    float up = textureCube(room, vec3(0.0, 1.0, 0.0)).b;\n"
                   "    float down = texture(room, vec3(0.0, -1.0, 0.0)).b;\n"
                   "    gl_FragColor = vec4(up, down, 0.0, 1.0);\n"
                   "}\n");
    const std::vector<float> sky = texel(drawn.after(1), 0, 0);
    CHECK(sky[0] > sky[1] + 0.2f);
    // +x -x +y -y +z -z from top to bottom, in fifths, which bytes store exactly.
    const Picture faces{{1, 6}, 1, Encoding::display, {0.0f, 0.2f, 0.4f, 0.6f, 0.8f, 1.0f}};
    const TemporaryFolder folder;
    REQUIRE(save_picture(faces, folder / "faces.png").has_value());
    drawn.request().values = {{"room", (folder / "faces.png").string()}};
    check_near(texel(drawn.after(1), 0, 0), {0.4, 0.6, 0.0, 1.0});
}

TEST_CASE("a transparent picture is saved with its alpha and unchanged colours") {
    const DrawnIsf half("", "void main() { gl_FragColor = vec4(1.0, 0.6, 0.2, 0.4); }\n");
    check_near(texel(half.saved(), 3, 2), {1.0, 0.6, 0.2, 0.4});
    const DrawnIsf empty("", "void main() { gl_FragColor = vec4(1.0, 0.6, 0.2, 0.0); }\n");
    check_near(texel(empty.saved(), 3, 2), {1.0, 0.6, 0.2, 0.0});
    const DrawnIsf opaque("", draws_orange);
    check_near(texel(opaque.saved(), 3, 2), {1.0, 0.6, 0.2});
}

TEST_CASE("all pictures of a sequence have alpha, including opaque ones") {
    const DrawnIsf drawn("",
                         "void main() { gl_FragColor = vec4(1.0, 0.6, 0.2, 1.0 - 0.4 * "
                         "float(FRAMEINDEX)); }\n");
    check_near(texel(drawn.exported(0), 3, 2), {1.0, 0.6, 0.2, 1.0});
    check_near(texel(drawn.exported(1), 3, 2), {1.0, 0.6, 0.2, 0.6});
}
