#include "base/file_uri.h"

#include <doctest/doctest.h>

TEST_CASE("a file URI gives its path") {
    CHECK(path_of_uri("file:///home/a.wav") == "/home/a.wav");
    CHECK(path_of_uri("FILE://localhost/a%20b") == "/a b");
    CHECK(path_of_uri("file:///gr%C3%BCn/%25.png") == "/grün/%.png");  // RFC 3986, 2.1
    CHECK(path_of_uri("file:///100%") == "/100%");                     // no escape
    CHECK(path_of_uri("file:///a%2") == "/a%2");
    CHECK(path_of_uri("file:///a%zz") == "/a%zz");
}

TEST_CASE("other URIs have no path") {
    for (const char* uri : {"", "file:", "file://", "file://server/a", "https://a/b", "/a",
                            "file:///a%00b", "sftp:///a"}) {
        CAPTURE(uri);
        CHECK(path_of_uri(uri).empty());
    }
}
