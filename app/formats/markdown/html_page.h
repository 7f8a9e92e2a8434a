#pragma once

#include "base/diagnostic.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

/// A link of the navigation: a page of the documentation.
struct HtmlLink {
    const char* label;
    const char* page;  // "tutorials/vj.md"
};

/// Where a page belongs.
struct HtmlContext {
    std::filesystem::path page;  // relative to the documentation's folder
    std::filesystem::path docs;  // that folder
    std::span<const HtmlLink> navigation;
};

/// A complete HTML page of GitHub-flavoured Markdown, readable without network. Headings get
/// GitHub's anchors. Links to pages inside the folder lead to their HTML; pictures and other files
/// are read where they are. HTML in the text is shown as text. Fails if memory is exhausted.
Result<std::string> html_page(std::string_view markdown, const HtmlContext& context);
