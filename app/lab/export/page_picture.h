#pragma once

#include <string>
#include <string_view>

/// What an exported page with ?frames=N drew.
struct PagePicture {
    std::string png;    // the attribute `data-png` of its canvas
    std::string fault;  // the page's error; "" if there is a picture

    bool lacks_webgl() const { return fault.find("WebGL") != std::string::npos; }
};

/// From the HTML of a page after its scripts have run.
PagePicture picture_in_page(std::string_view html);
