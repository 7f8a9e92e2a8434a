// Output of Shadertoy shaders, rule by rule.
#include "io/pictures/picture_file.h"
#include "io/temporary_folder.h"
#include "lab/offline/offline.h"
#include "problems_of.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>

namespace {
/// A pass for the JSON that a test writes.
struct JsonPass {
    std::string type;
    std::string id;
    std::string code;
    std::string inputs = {};
};

const std::string shows_buffer_a = R"({"channel": 0, "type": "buffer", "id": "4dXGR8",
    "sampler": {"filter": "nearest", "wrap": "clamp", "vflip": "true"}})";

std::string main_image(const std::string& body) {
    return "void mainImage(out vec4 c, in vec2 p) { " + body + " }";
}

/// A shader with a picture of 4 x 2 px at 60 frames per second.
class DrawnToy {
public:
    explicit DrawnToy(const std::vector<JsonPass>& passes) {
        std::string text;
        for (const JsonPass& pass : passes)
            text +=
                fmt::format(R"({}{{"type": "{}", "outputs": [{{"id": "{}"}}], "code": "{}",
                                      "inputs": [{}]}})",
                            text.empty() ? "" : ", ", pass.type, pass.id, pass.code, pass.inputs);
        RenderRequest request;
        request.look = m_folder.write("a.json", "{\"renderpass\": [" + text + "]}").string();
        request.size = {4, 2};
        const auto roots = find_roots({});
        REQUIRE(roots.has_value());
        auto prepared = prepare(request, Library(*roots));
        REQUIRE_MESSAGE(prepared.has_value(), problems_of(prepared));
        auto offline = Offline::create(std::move(*prepared), request.size, 60.0);
        REQUIRE_MESSAGE(offline.has_value(), problems_of(offline));
        m_offline.emplace(std::move(*offline));
    }

    /// The bottom left texel of a pass after `frames` more frames.
    std::array<float, 4> after(int frames, int pass = 0) {
        for (int frame = 0; frame < frames; ++frame)
            m_offline->advance();
        return texel(0, 0, pass);
    }
    std::array<float, 4> texel(int x, int y_from_bottom, int pass = 0) const {
        const Picture picture = m_offline->picture(pass);
        const float* at =
            &picture.pixels[picture.index(x, picture.extent.height - 1 - y_from_bottom)];
        return {at[0], at[1], at[2], at[3]};
    }

private:
    TemporaryFolder m_folder;
    std::optional<Offline> m_offline;
};

// Values outside of 0..1 are read from a buffer, which stores them.
DrawnToy buffer_with(const std::string& body, const std::string& inputs = "") {
    return DrawnToy(
        {{"buffer", "4dXGR8", main_image(body), inputs},
         {"image", "4dfGRr", main_image("c = texture(iChannel0, p);"), shows_buffer_a}});
}

using Texel = std::array<float, 4>;
}  // namespace

TEST_CASE("a buffer that reads itself gets its previous frame, initially zero") {
    DrawnToy counter = buffer_with("c = texelFetch(iChannel0, ivec2(p), 0) + 1.0;", shows_buffer_a);
    CHECK(counter.after(1) == Texel{1, 1, 1, 1});
    CHECK(counter.after(4) == Texel{5, 5, 5, 5});
}

TEST_CASE("frames are counted from 0, and time starts at the first") {
    DrawnToy clock = buffer_with("c = vec4(iFrame, iTime * 60.0, iTimeDelta * 60.0, iFrameRate);");
    const Texel first = clock.after(1);
    CHECK(first[0] == 0.0f);
    CHECK(first[1] == 0.0f);
    CHECK(first[2] == doctest::Approx(1.0));
    CHECK(first[3] == doctest::Approx(60.0));
    const Texel fourth = clock.after(3);
    CHECK(fourth[0] == 3.0f);
    CHECK(fourth[1] == doctest::Approx(3.0));
}

TEST_CASE("frame 0 can set the initial value of later frames") {
    DrawnToy shadertoy = buffer_with(
        "c = iFrame == 0 ? vec4(10.0) : texelFetch(iChannel0, ivec2(p), 0) + 1.0;", shows_buffer_a);
    CHECK(shadertoy.after(3)[0] == 12.0f);
}

TEST_CASE("pixels count from the bottom left, and resolutions end with 1") {
    DrawnToy shadertoy = buffer_with("c = vec4(p, iResolution.yz);");
    shadertoy.after(1);
    CHECK(shadertoy.texel(3, 1) == Texel{3.5f, 1.5f, 2.0f, 1.0f});
    DrawnToy read =
        buffer_with("c = vec4(iChannelResolution[0], iChannelResolution[2].x);", shows_buffer_a);
    CHECK(read.after(1) == Texel{4, 2, 1, 0});
}

TEST_CASE("a buffer keeps its alpha, and the alpha of Image is 1") {
    DrawnToy shadertoy({{"buffer", "4dXGR8", main_image("c = vec4(0.25);")},
                        {"image", "4dfGRr", main_image("c = texelFetch(iChannel0, ivec2(0), 0);"),
                         shows_buffer_a}});
    CHECK(shadertoy.after(1, 0)[3] == 0.25f);
    CHECK(shadertoy.texel(0, 0, 1)[3] == 1.0f);
}

TEST_CASE("offline no key or mouse button is down") {
    DrawnToy shadertoy = buffer_with("c = iMouse + texelFetch(iChannel1, ivec2(65, 0), 0);",
                                     R"({"channel": 1, "type": "keyboard"})");
    CHECK(shadertoy.after(1) == Texel{0, 0, 0, 0});
}

TEST_CASE("the sample rate is 44100 Hz") {
    DrawnToy shadertoy = buffer_with("c = vec4(iSampleRate);");
    CHECK(shadertoy.after(1)[0] == 44100.0f);
}

TEST_CASE("a default cube is a sky: brighter and bluer above than below") {
    DrawnToy shadertoy = buffer_with(
        "c = vec4(texture(iChannel1, vec3(0.0, 1.0, 0.1)).b, texture(iChannel1, vec3(0.0, -1.0, "
        "0.1)).b, "
        "textureSize(iChannel1, 0).x, 0.0);",
        R"({"channel": 1, "type": "cubemap", "sampler": {"filter": "linear"}})");
    const Texel drawn = shadertoy.after(1);
    CHECK(drawn[0] > drawn[1] + 0.2f);
    CHECK(drawn[2] == 128.0f);
}

namespace {
// A one-pixel shader whose inputs reference files in its folder.
Result<Picture> drawn_beside(const TemporaryFolder& folder, const std::string& color,
                             const std::string& inputs) {
    const auto file = folder.write("a.json", R"({"renderpass": [{"type": "image", "code": ")" +
                                                 main_image("c = " + color + ";") +
                                                 R"(", "inputs": [)" + inputs + "]}]}");
    RenderRequest request;
    request.look = file.string();
    request.size = {1, 1};
    auto prepared = prepare(request, Library(*find_roots({})));
    if (!prepared)
        return fail(prepared.error());
    auto offline = Offline::create(std::move(*prepared), request.size, 60.0);
    if (!offline)
        return fail(offline.error());
    offline->advance();
    return offline->picture();
}
}  // namespace

TEST_CASE("a cube and a volume read files in the folder of the shader") {
    const TemporaryFolder folder;
    // Faces +x -x +y -y +z -z. Slices from the bottom.
    const Picture faces{{1, 6}, 1, Encoding::display, {0.0f, 0.2f, 0.4f, 0.6f, 0.8f, 1.0f}};
    const Picture slices{{2, 4}, 1, Encoding::display, {0.2f, 0.2f, 0.2f, 0.2f, 1, 1, 1, 1}};
    REQUIRE(save_picture(faces, folder / "faces.png").has_value());
    REQUIRE(save_picture(slices, folder / "slices.png").has_value());
    const auto drawn = drawn_beside(
        folder,
        "vec4(texture(iChannel0, vec3(0, -1, 0)).r, texture(iChannel1, vec3(0.5, 0.5, 0.75)).r, "
        "0.0, 1.0)",
        R"({"channel": 0, "type": "cubemap", "filepath": "faces.png"},
           {"channel": 1, "type": "volume", "filepath": "slices.png"})");
    REQUIRE_MESSAGE(drawn.has_value(), problems_of(drawn));
    CHECK(drawn->pixels[0] == doctest::Approx(0.6).epsilon(0.01));
    CHECK(drawn->pixels[1] == doctest::Approx(1.0).epsilon(0.01));
}

TEST_CASE("a file that cannot be a cube is reported with its size") {
    const TemporaryFolder folder;
    const Picture neither{{5, 3}, 1, Encoding::display, std::vector<float>(15, 1.0f)};
    REQUIRE(save_picture(neither, folder / "neither.png").has_value());
    const auto drawn =
        drawn_beside(folder, "texture(iChannel0, vec3(1, 0, 0))",
                     R"({"channel": 0, "type": "cubemap", "filepath": "neither.png"})");
    REQUIRE_FALSE(drawn.has_value());
    CHECK(drawn.error().front().file == folder / "neither.png");
    CHECK(drawn.error().front().message.starts_with("can't be a cube map at 5 x 3 px."));
}

TEST_CASE("Cube A is read in the directions in which it was drawn") {
    const std::string cube_main =
        "void mainCubemap(out vec4 c, in vec2 p, in vec3 from, in vec3 seen) { c = vec4(seen, "
        "1.0); }";
    DrawnToy shadertoy({{"buffer", "4dXGR8",
                         main_image("vec3 d = normalize(vec3(0.3, -0.8, 0.5)); "
                                    "c = vec4(texture(iChannel1, d).rgb - d, float(iFrame));"),
                         R"({"channel": 1, "type": "cubemap", "id": "4dX3Rr"})"},
                        {"cubemap", "4dX3Rr", cube_main},
                        {"image", "4dfGRr", main_image("c = vec4(1.0);")}});
    const Texel off = shadertoy.after(2);  // the buffer reads the cube of the previous frame
    CHECK(off[3] == 1.0f);
    for (std::size_t part = 0; part < 3; ++part)
        CHECK(std::abs(off[part]) < 0.01f);
}

TEST_CASE("dates of renders are fixed, with months from 0") {
    DrawnToy shadertoy = buffer_with("c = iDate;");
    const Texel date = shadertoy.after(30);
    CHECK(date[0] == 2000.0f);
    CHECK(date[1] == 0.0f);
    CHECK(date[2] == 1.0f);
    CHECK(date[3] == doctest::Approx(0.5));
}

TEST_CASE("a default volume is repeating noise of 32 texels per side") {
    DrawnToy shadertoy = buffer_with(
        "vec3 at = vec3(0.3, 0.4, 0.6); c = vec4(textureSize(iChannel1, 0).z, "
        "texture(iChannel1, at).r - texture(iChannel1, at + 1.0).r, texture(iChannel1, at).r, "
        "0.0);",
        R"({"channel": 1, "type": "volume", "sampler": {"filter": "linear", "wrap": "repeat"}})");
    const Texel drawn = shadertoy.after(1);
    CHECK(drawn[0] == 32.0f);
    CHECK(std::abs(drawn[1]) < 0.01f);
    CHECK(drawn[2] > 0.0f);
}

TEST_CASE("the resolution of a volume includes its depth") {
    DrawnToy shadertoy =
        buffer_with("c = vec4(iChannelResolution[1], 1.0);",
                    R"({"channel": 1, "type": "volume", "sampler": {"filter": "linear"}})");
    CHECK(shadertoy.after(1) == Texel{32, 32, 32, 1});
}

TEST_CASE("vflip selects the bottom row of a video") {
    const TemporaryFolder folder;
    Picture rows{{1, 2}, 3, Encoding::display, {1.0f, 1.0f, 1.0f, 0.0f, 0.0f, 0.0f}};
    REQUIRE(save_picture(rows, folder / "rows.png").has_value());
    for (const char* flip : {"true", "false"}) {
        RenderRequest request;
        request.look =
            folder
                .write("a.json",
                       fmt::format(R"({{"renderpass": [{{"type": "image", "code": "{}",
                    "inputs": [{{"channel": 0, "type": "webcam", "sampler": {{"vflip": "{}"}}}}]}}]}})",
                                   main_image("c = texelFetch(iChannel0, ivec2(0), 0);"), flip))
                .string();
        request.source = (folder / "rows.png").string();
        request.size = {1, 1};
        auto prepared = prepare(request, Library(*find_roots({})));
        REQUIRE_MESSAGE(prepared.has_value(), problems_of(prepared));
        auto offline = Offline::create(std::move(*prepared), request.size, 60.0);
        REQUIRE(offline.has_value());
        offline->advance();
        CHECK(offline->picture().pixels[0] == (flip == std::string("true") ? 0.0f : 1.0f));
    }
}

TEST_CASE("vflip selects the bottom row of a picture") {
    const auto reading = [](const char* flip) {
        return fmt::format(R"({{"channel": 1, "type": "texture", "filepath": "rows.png",
            "sampler": {{"filter": "nearest", "wrap": "clamp", "vflip": "{}"}}}})",
                           flip);
    };
    const TemporaryFolder folder;
    Picture rows{{1, 2}, 3, Encoding::display, {1.0f, 1.0f, 1.0f, 0.0f, 0.0f, 0.0f}};
    REQUIRE(save_picture(rows, folder / "rows.png").has_value());
    for (const char* flip : {"true", "false"}) {
        const auto file =
            folder.write("a.json", R"({"renderpass": [{"type": "image", "code": ")" +
                                       main_image("c = texelFetch(iChannel1, ivec2(0), 0);") +
                                       R"(", "inputs": [)" + reading(flip) + "]}]}");
        RenderRequest request;
        request.look = file.string();
        request.size = {1, 1};
        auto prepared = prepare(request, Library(*find_roots({})));
        REQUIRE_MESSAGE(prepared.has_value(), problems_of(prepared));
        auto offline = Offline::create(std::move(*prepared), request.size, 60.0);
        REQUIRE(offline.has_value());
        offline->advance();
        // The top row of the file is white. With vflip, which is usual, the bottom row is at y = 0.
        CHECK(offline->picture().pixels[0] == (flip == std::string("true") ? 0.0f : 1.0f));
    }
}
