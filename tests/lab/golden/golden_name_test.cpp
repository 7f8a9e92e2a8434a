#include "lab/golden/golden_name.h"

#include <doctest/doctest.h>

TEST_CASE("a golden picture is named after its look and preset") {
    CHECK(golden_name("phosphor", "") == "phosphor");
    CHECK(golden_name("phosphor", "amber-p3") == "phosphor--amber-p3");
    CHECK(golden_name("phosphor+crt", "Night Ward (2)") == "phosphor+crt--night-ward-2");
    CHECK(golden_name("crt-geom.slangp", "") == "crt-geom.slangp");
    CHECK(golden_name("größe", "光") == "größe--光");
}

TEST_CASE("the name of a golden picture can't lead to another folder") {
    CHECK(golden_name("../../etc/passwd", "") == "etc-passwd");
    CHECK(golden_name("", "..") == "look--preset");
    CHECK(golden_name("-x", "a//b\\c\n") == "x--a-b-c");
    CHECK(golden_name("latin \xe9", "") == "latin");
    for (const char* name : {"phosphor", "phosphor--amber-p3", "a_b.c+d", "größe"})
        CHECK(is_golden_name(name));
    for (const char* name : {"", "../a", "a/b", "a\\b", ".a", "-a", "A", "a b", "\xe9", "a\n"})
        CHECK_FALSE(is_golden_name(name));
}

TEST_CASE("long names of golden pictures are cut between characters") {
    const std::string name = golden_name(std::string(99, 'a') + "ß", std::string(300, 'b'));
    CHECK(name == std::string(99, 'a') + "--" + std::string(100, 'b'));
    CHECK(is_golden_name(name));
}
