#include "ui/frame/look_keys.h"

#include "gpu/input_event.h"

#include <doctest/doctest.h>

TEST_CASE("keys have the codes of browsers") {
    CHECK(browser_key('A') == 65);
    CHECK(browser_key('Z') == 90);
    CHECK(browser_key('7') == 55);
    CHECK(browser_key(' ') == 32);
    CHECK(browser_key(gpu::key::left) == 37);
    CHECK(browser_key(gpu::key::up) == 38);
    CHECK(browser_key(gpu::key::right) == 39);
    CHECK(browser_key(gpu::key::down) == 40);
    CHECK(browser_key(gpu::key::enter) == 13);
    CHECK(browser_key(gpu::key::backspace) == 8);
    CHECK(browser_key(gpu::key::del) == 46);
    CHECK(browser_key(gpu::key::first_function) == 112);
    CHECK(browser_key(gpu::key::last_function) == 123);
    CHECK(browser_key(gpu::key::left_shift) == 16);
    CHECK(browser_key(gpu::key::right_shift + 1) == 17);  // control
    CHECK(browser_key(gpu::key::page_up) == 33);
    CHECK(browser_key(gpu::key::page_down) == 34);
    CHECK(browser_key('@') == 0);
}
