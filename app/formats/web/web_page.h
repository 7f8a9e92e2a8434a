#pragma once

#include "formats/portable/portable_json.h"
#include "formats/web/es_shaders.h"

#include <cstdint>

/// A web page that draws a look, and the files next to it.
struct WebPage {
    std::string html;
    std::map<std::string, std::string> scripts;  // with media, by path relative to the page
};

/// Makes a page from a look and its description. Media are embedded. If they have more than
/// `max_embedded` bytes together, they are scripts in the folder `media_folder` next to the page,
/// because a page opened from a disk can't read other files. Text is escaped for HTML and JSON.
Result<WebPage> web_page(const Look& look, const PortableFiles& described, const EsShaders& shaders,
                         const std::string& media_folder, std::uintmax_t max_embedded);
