#include "lab/commands/help_page.h"

#include "base/file.h"

#include <doctest/doctest.h>

#include <cstdlib>

namespace fs = std::filesystem;

TEST_CASE("the whole documentation becomes HTML whose links lead to written pages") {
    std::string name = (fs::temp_directory_path() / "afterglow-docs-XXXXXX").string();
    const fs::path target = mkdtemp(name.data());
    const fs::path docs = fs::path(AFTERGLOW_SOURCE_DIR) / "docs";
    REQUIRE(write_help_pages(docs, target).has_value());
    std::size_t links = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(target)) {
        if (entry.path().extension() != ".html")
            continue;
        const auto html = read_text(entry.path());
        REQUIRE(html.has_value());
        for (std::size_t at = html->find(" href=\""); at != std::string::npos;
             at = html->find(" href=\"", at + 1)) {
            std::string address = html->substr(at + 7, html->find('"', at + 7) - at - 7);
            address = address.substr(0, address.find('#'));
            if (address.empty() || address.find(':') != std::string::npos)
                continue;
            CAPTURE(entry.path());
            CAPTURE(address);
            CHECK(fs::is_regular_file(entry.path().parent_path() / address));
            ++links;
        }
    }
    CHECK(links > 100);
    fs::remove_all(target);
}

TEST_CASE("a page whose folder cannot be written is an error with its path") {
    const fs::path docs = fs::path(AFTERGLOW_SOURCE_DIR) / "docs";
    const auto written = write_help_pages(docs, "/proc/afterglow");
    REQUIRE_FALSE(written.has_value());
    CHECK(written.error().front().file.string().starts_with("/proc/afterglow"));
}
