#include "glsl/compile/check.h"
#include "glsl/shader_texts.h"
#include "in_a_moment.h"

#include <doctest/doctest.h>

namespace {
// The lines of loops that are warned about. The body starts in line 9.
std::vector<int> warned(const std::string& body) {
    const auto checked =
        check_program(fullscreen_vertex_stage(),
                      stage_of("a.frag",
                               "#version 410 core\nuniform int count;\nuniform float reach;\n"
                               "uniform sampler2D image;\nin vec2 uv;\nout vec4 color;\n"
                               "bool step_on(inout int i) { ++i; return i < count; }\n"
                               "void main() {\n" +
                                   body + "\ncolor = vec4(uv, 0, 1);\n}\n"));
    REQUIRE(checked.has_value());
    std::vector<int> lines;
    for (const Diagnostic& warning : checked->warnings)
        if (warning.message.starts_with("nothing limits this loop"))
            lines.push_back(warning.line);
    return lines;
}

bool is_bounded(const std::string& body) {
    return warned("float sum = 0.0, t = 0.0; int i = 0; ivec2 at = ivec2(0);\n" + body).empty();
}
}  // namespace

TEST_CASE("a loop that counts to something that stays has a bound") {
    CHECK(is_bounded("for (int k = 0; k < 10; ++k) sum += 1.0;"));
    CHECK(is_bounded("for (int k = 0; k < count; k++) sum += 1.0;"));
    CHECK(is_bounded("for (int k = count; k >= 0; k -= 2) sum += 1.0;"));
    CHECK(is_bounded("for (float k = 0.0; k < reach; k += 0.1) sum += 1.0;"));
    CHECK(is_bounded("for (int k = 1; k < count; k *= 2) sum += 1.0;"));
    CHECK(is_bounded("for (int k = 0; k < count; k = k + 1) sum += 1.0;"));
    CHECK(is_bounded("for (int k = 0; float(k) * 0.5 < reach; ++k) sum += 1.0;"));
    CHECK(is_bounded("while (i < count) { sum += 1.0; ++i; }"));
    CHECK(is_bounded("while (i++ < count) sum += 1.0;"));
    CHECK(is_bounded("while (--i > -count) sum += 1.0;"));
    CHECK(is_bounded("while (count - i > 0) ++i;"));
    CHECK(is_bounded("do { sum += 1.0; ++i; } while (i < count);"));
    CHECK(is_bounded("do { sum += 1.0; } while (false);"));
    CHECK(is_bounded("for (; at.x < count; ++at.x) sum += 1.0;"));
}

TEST_CASE("a loop that breaks at a count has a bound") {
    CHECK(is_bounded("while (true) { if (i >= count) break; ++i; }"));
    CHECK(is_bounded("for (;;) { if (i < count) { ++i; sum += 1.0; } else { break; } ++i; }"));
    CHECK(is_bounded("for (;;) { ++i; if (i > 100 || sum > reach) break; sum += t; }"));
    CHECK(is_bounded("while (texture(image, vec2(t)).r < 0.5 && i < 64) { t += sum; ++i; }"));
    CHECK(is_bounded("for (int k = 0; k < 100; ++k) { if (uv.x > 0.5) continue; sum += 1.0; }"));
    CHECK(is_bounded("while (true) { sum += 1.0; break; }"));
    CHECK(is_bounded("for (;;) { if (i < count) { sum += 1.0; ++i; continue; } else { break; } }"));
    CHECK(is_bounded("while (true) { if (i >= count) { break; } else { ++i; } }"));
    CHECK(is_bounded("while (i < count) { if (uv.x > 0.5) { i = 0; break; } ++i; }"));
}

TEST_CASE("a loop that depends on data alone is warned about at its line") {
    CHECK(warned("float t = 0.0;\nwhile (t < reach) t += texture(image, vec2(t)).r;") ==
          std::vector<int>{10});
    CHECK_FALSE(is_bounded("while (true) sum += 1.0;"));
    CHECK_FALSE(is_bounded("while (sum < reach) { if (uv.x > 0.5) sum += 1.0; }"));
    CHECK_FALSE(is_bounded("for (int k = 0; k < count; ++k) { if (uv.x > 0.5) --k; }"));
    CHECK_FALSE(is_bounded("for (int k = 0; k < count; --k) sum += 1.0;"));
    CHECK_FALSE(is_bounded("int end = 10; for (int k = 0; k < end; ++k) ++end;"));
    CHECK_FALSE(is_bounded("while (true) { if (uv.x > 0.5) continue; if (++i > 9) break; }"));
    CHECK_FALSE(
        is_bounded("while (true) { ++i; if (i > 9) { if (uv.x > 0.5) continue; break; } }"));
    CHECK_FALSE(is_bounded("while (true) { if (i < count) { if (uv.x > 0.5) ++i; } else break; }"));
    CHECK_FALSE(is_bounded("while (true) { if (i < count) { continue; ++i; } else break; }"));
    CHECK_FALSE(is_bounded("do { sum += 1.0; } while (step_on(i));"));
    CHECK_FALSE(is_bounded("while (i < count || sum < reach) ++i;"));
    CHECK_FALSE(is_bounded("while (i < count) at.x += 1;"));
    CHECK_FALSE(is_bounded("while (sin(t) < 2.0) t += 0.1;"));
    CHECK_FALSE(is_bounded("while (i < count) { { if (uv.x > 0.5) ++i; } }"));
    CHECK_FALSE(is_bounded("while (i < count) sum += uv.x > 0.5 ? float(++i) : 0.0;"));
    CHECK_FALSE(is_bounded("bool b; while (i < count) b = uv.x > 0.5 && ++i > 3;"));
    CHECK_FALSE(is_bounded("while (i < count) for (int k = 0; k < count; ++k) ++i;"));
    CHECK_FALSE(is_bounded("for (; at.x < count; ++at.y) sum += 1.0;"));
}

TEST_CASE("each loop of a nest is judged alone") {
    CHECK(warned("float t = 0.0;\nfor (int i = 0; i < 4; ++i)\nwhile (t < reach)\nt *= uv.x;") ==
          std::vector<int>{11});
}

TEST_CASE("a loop with many counters and ends is judged in a moment") {
    std::string body = "int i = 0;\nwhile (true) {\n";
    for (int n = 0; n < 5000; ++n)
        body += "++i; if (i > count || uv.x > 0.5) { if (uv.y > 0.5) ++i; }\n";
    CHECK(is_done_in_a_moment([&] { CHECK(warned(body + "}") == std::vector<int>{10}); }));
}
