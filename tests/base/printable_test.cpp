#include "base/printable.h"

#include "base/diagnostic.h"

#include <doctest/doctest.h>

#include <string>

TEST_CASE("control characters are shown as hexadecimal escapes") {
    CHECK(printable("plain, Größe, 光, 😀") == "plain, Größe, 光, 😀");
    CHECK(printable("\x1b[2J\x1b]0;title\x07") == "\\x1b[2J\\x1b]0;title\\x07");
    CHECK(printable(std::string("a\0b", 3)) == "a\\x00b");
    CHECK(printable("a\rb\nc\td\x7f") == "a\\x0db\\x0ac\\x09d\\x7f");
    CHECK(printable("\xc2\x9b"
                    "31m") == "\\xc2\\x9b31m");  // U+009B, CSI
    CHECK(printable("\x9b"
                    "31m") == "\\x9b31m");       // CSI as one byte
    CHECK(printable("\xc2\xa0") == "\xc2\xa0");  // U+00A0 is a no-break space
}

TEST_CASE("invalid UTF-8 bytes are shown as hexadecimal escapes") {
    for (const char* bad :
         {"\xc0\x9b", "\xc1\xbf", "\xe0\x80\x9b", "\xed\xa0\x80", "\xf0\x80\x80\x9b",
          "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xff", "\xe2\x82", "\xc2"}) {
        const std::string shown = printable(bad);
        CHECK(shown.find("\\x") == 0);
        CHECK(shown.size() == 4 * std::string(bad).size());
    }
}

TEST_CASE("a diagnostic escapes control characters in its file name and message") {
    const Diagnostic diagnostic{"a\x1b[1m.json", 2, "unknown key 'x\x1b[2J\n'"};
    CHECK(to_string(diagnostic) == "a\\x1b[1m.json:2: error: unknown key 'x\\x1b[2J\\x0a'");
}

TEST_CASE("a text is shortened at a character boundary") {
    CHECK(shortened("abc", 3) == "abc");
    CHECK(shortened("abcd", 3) == "abc…");
    CHECK(shortened("aää", 4) == "aä…");
    CHECK(shortened("ä", 1) == "…");
}
