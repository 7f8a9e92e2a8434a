#include "formats/mpv_export/mpv_text.h"

#include <doctest/doctest.h>

TEST_CASE("sizes are expressions of the screen or the video, and at least 1") {
    CHECK(mpv_side({Side::By::viewport, 1.0, {}}, 0) == "OUTPUT.w");
    CHECK(mpv_side({Side::By::source, 2.0, {}}, 1) == "HOOKED.h 2.000000000 *");
    CHECK(mpv_side({Side::By::pixels, 64.0, {}}, 0) == "64");
    CHECK(mpv_side({Side::By::viewport, 0.25, {}}, 1) ==
          "OUTPUT.h 0.250000000 * OUTPUT.h 0.250000000 * 0.5 < +");
}

TEST_CASE("a text has no mark that starts a block") {
    CHECK(without_mpv_marks("a //!HOOK ///! b //! !") == "a // !HOOK /// ! b // ! !");
}

TEST_CASE("a block has all lines before its GLSL") {
    const MpvBlock block{.about = "Look: \"pass\"\n//!SAVE x",
                         .binds = {"first"},
                         .save = "second",
                         .width = "OUTPUT.w",
                         .height = "8",
                         .values = "#define gain 1.0\n",
                         .body = "vec4 hook() { return vec4(gain); }  //!\n"};
    CHECK(mpv_block_text(block) ==
          "\n//!HOOK MAIN\n//!DESC Look: 'pass' // !SAVE x\n//!BIND HOOKED\n//!BIND first\n"
          "//!SAVE second\n//!COMPONENTS 4\n//!WIDTH OUTPUT.w\n//!HEIGHT 8\n#define gain 1.0\n"
          "vec4 hook() { return vec4(gain); }  // !\n");
}
