#include "formats/markdown/html_page.h"

#include <doctest/doctest.h>

namespace {
std::string body_of(std::string_view markdown, const char* page = "tutorials/a.md") {
    constexpr HtmlLink links[] = {{"Manual", "manual.md"}, {"VJ", "tutorials/vj.md"}};
    const auto html = html_page(markdown, {page, "/opt/docs", links});
    REQUIRE(html.has_value());
    const std::size_t begin = html->find("<main>\n") + 7;
    return html->substr(begin, html->find("</main>") - begin);
}
}  // namespace

TEST_CASE("headings get GitHub's anchors") {
    CHECK(body_of("## Save & share: `two` files\n") ==
          "<h2 id=\"save--share-two-files\">Save &amp; share: <code>two</code> files</h2>\n");
    CHECK(body_of("# A\n\n# A\n") == "<h1 id=\"a\">A</h1>\n<h1 id=\"a-1\">A</h1>\n");
}

TEST_CASE("links to pages lead to their HTML, others to the file itself") {
    CHECK(body_of("[x](../looks.md#stacks)") == "<p><a href=\"../looks.html#stacks\">x</a></p>\n");
    CHECK(body_of("[x](#here) [y](https://example.org/a.md)") ==
          "<p><a href=\"#here\">x</a> <a href=\"https://example.org/a.md\">y</a></p>\n");
    CHECK(body_of("[x](../../SECURITY.md)") ==
          "<p><a href=\"file:///opt/SECURITY.md\">x</a></p>\n");
    CHECK(body_of("![x](manual/step.png)", "manual.md") ==
          "<p><img src=\"file:///opt/docs/manual/step.png\" alt=\"x\"></p>\n");
}

TEST_CASE("tables are tables, and HTML is shown as text") {
    const std::string table = body_of("| a | b |\n| --- | --- |\n| 1 | **2** |\n");
    CHECK(table.find("<td><strong>2</strong></td>") != std::string::npos);
    CHECK(body_of("<script>alert(1)</script>").find("<script>") == std::string::npos);
}

TEST_CASE("the navigation is relative to the page") {
    constexpr HtmlLink links[] = {{"Manual", "manual.md"}, {"VJ", "tutorials/vj.md"}};
    const auto html = html_page("# The <VJ>\n", {"tutorials/vj.md", "/opt/docs", links});
    REQUIRE(html.has_value());
    CHECK(html->find("<a href=\"../manual.html\">Manual</a>") != std::string::npos);
    CHECK(html->find("<a class=\"here\" href=\"../tutorials/vj.html\">VJ</a>") !=
          std::string::npos);
    CHECK(html->find("<title>The &lt;VJ> – Afterglow</title>") != std::string::npos);
}
