#include "formats/slang/decoration.h"

#include <doctest/doctest.h>

TEST_CASE("decoration is removed from a text, while letters of all scripts and brackets stay") {
    CHECK(without_decoration("   . Phosphor height ") == "Phosphor height");
    CHECK(without_decoration("== Colors ==") == "Colors");
    CHECK(without_decoration("\xe2\x98\x85 Halo? ==>") == "Halo?");  // a star
    CHECK(without_decoration("\xc2\xb7 \xc2\xb9Global\xc2\xb2\xe2\x81\xb4") == "Global");
    CHECK(without_decoration("\xc3\xa9tat \xc2\xb5") == "\xc3\xa9tat \xc2\xb5");
    CHECK(without_decoration("[IMG] Sharpness (px)") == "[IMG] Sharpness (px)");
    CHECK(without_decoration("-----").empty());
    CHECK(without_decoration("\xe2\x80\x94\xe2\x80\x94 Mask \xe2\x80\x94") == "Mask");  // em dashes
    CHECK(without_decoration("").empty());
}
