#pragma once

#include <string_view>

/// The parts of an exported web page, made from app/web/ at build time. Scripts and CSS are
/// minified. Packed scripts halve a page without media.
struct PageParts {
    // HTML with places: {{TITLE}}, {{STYLE}}, {{ABOUT}}, {{MEDIA}}, {{DATA}}, {{SCRIPT}}
    std::string_view page;
    std::string_view style;           // CSS
    std::string_view script;          // JavaScript without modules, gzip in base64
    std::string_view picture_script;  // the same, also for looks that read pictures
};

/// Those of this build.
PageParts page_parts();
