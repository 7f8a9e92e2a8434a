#include "gpu/driver_log.h"

#include <doctest/doctest.h>

namespace {
// Line 3 of the text comes from another file than the rest.
Stage stage() {
    return {"glow.frag",
            "",
            {{"glow.frag", 1}, {"glow.frag", 2}, {"include/blur.glsl", 40}, {"glow.frag", 4}}};
}
}  // namespace

TEST_CASE("every driver's line format is mapped to the original file and line") {
    for (const char* log :
         {"0:3(12): error: `lihgt' undeclared", "0(3) : error C1008: `lihgt' undeclared",
          "ERROR: 0:3: `lihgt' undeclared"}) {
        const Diagnostics found = gpu::parse_driver_log(log, stage());
        REQUIRE(found.size() == 1);
        CHECK(to_string(found.front()) ==
              "include/blur.glsl:40: error: graphics driver: `lihgt' undeclared");
    }
}

TEST_CASE("several log lines become several diagnostics, and the summary line is dropped") {
    const Diagnostics found = gpu::parse_driver_log(
        "WARNING: 0:1: old version\n"
        "ERROR: 0:2: 'a' : undeclared identifier\r\n"
        "ERROR: 0:4: 'b' : undeclared identifier\n"
        "ERROR: 2 compilation errors.  No code generated.\n",
        stage());
    REQUIRE(found.size() == 3);
    CHECK(found[0].severity == Severity::warning);
    CHECK(found[1].line == 2);
    CHECK(found[2].line == 4);
}

TEST_CASE("a log without a line number is kept whole, for the stage's file") {
    const Diagnostics found =
        gpu::parse_driver_log("error: fragment shader input `x' has no matching output\n", stage());
    REQUIRE(found.size() == 1);
    CHECK(to_string(found.front()) ==
          "glow.frag: error: graphics driver: error: fragment shader input `x' has no matching "
          "output");
}

TEST_CASE("a driver that fails with only warnings or an empty log still gives an error") {
    CHECK(has_errors(gpu::parse_driver_log("WARNING: 0:1: old version", stage())));
    CHECK(has_errors(gpu::parse_driver_log("", stage())));
    CHECK(has_errors(gpu::parse_driver_log(std::string(1 << 20, '('), stage())));
}

TEST_CASE("a line past the end maps to the last one, and a stage without a map keeps its numbers") {
    CHECK(gpu::parse_driver_log("0:99(1): error: eof", stage()).front().line == 4);
    const Diagnostics own = gpu::parse_driver_log("0:7(1): error: x", {"own.vert", "", {}});
    CHECK(to_string(own.front()) == "own.vert:7: error: graphics driver: x");
}
