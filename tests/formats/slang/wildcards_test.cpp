#include "formats/slang/wildcards.h"

#include <doctest/doctest.h>

TEST_CASE("each wildcard is replaced by its value on a desktop without a game") {
    const auto replaced = [](const std::string& token) {
        return with_wildcards_replaced("a/$" + token + "$_b", "presets/My look.slangp");
    };
    CHECK(replaced("PRESET") == "a/My look_b");
    CHECK(replaced("PRESET-DIR") == "a/presets_b");
    CHECK(replaced("VID-DRV") == "a/glcore_b");
    CHECK(replaced("VID-DRV-SHADER-EXT") == "a/slang_b");
    CHECK(replaced("VID-DRV-PRESET-EXT") == "a/slangp_b");
    CHECK(replaced("CORE-REQ-ROT") == "a/CORE-REQ-ROT-0_b");
    CHECK(replaced("VID-ALLOW-CORE-ROT") == "a/VID-ALLOW-CORE-ROT-OFF_b");
    CHECK(replaced("VID-USER-ROT") == "a/VID-USER-ROT-0_b");
    CHECK(replaced("VID-FINAL-ROT") == "a/VID-FINAL-ROT-0_b");
    CHECK(replaced("SCREEN-ORIENT") == "a/SCREEN-ORIENT-0_b");
    CHECK(replaced("VIEW-ASPECT-ORIENT") == "a/VIEW-ASPECT-ORIENT-HORZ_b");
    CHECK(replaced("CORE-ASPECT-ORIENT") == "a/CORE-ASPECT-ORIENT-HORZ_b");
}

TEST_CASE("an unsupported wildcard stays unchanged") {
    const auto replaced = [](const std::string& path) {
        return with_wildcards_replaced(path, "presets/a.slangp");
    };
    CHECK(replaced("$CORE$/$GAME$.slangp") == "$CORE$/$GAME$.slangp");
    CHECK(replaced("100$PRESET$") == "100a");
    CHECK(replaced("10$ and $PRESET$ and $") == "10$ and a and $");
    CHECK(replaced("$$PRESET$$") == "$a$");
    CHECK(replaced("") == "");
}
