#pragma once

#include "lab/gallery/gallery_card.h"

#include <string>
#include <vector>

/// A look of the page with its cards.
struct GallerySection {
    std::string id;      // of the look: "phosphor+crt"
    std::string anchor;  // unique in the page
    std::string name;
    std::string about;
    std::string author;
    std::string license;
    std::vector<GalleryCard> cards;
};

/// The page that lists all cards. It needs no network and loads only the thumbnails.
std::string gallery_page(const std::vector<GallerySection>& sections);

/// Whether a text is such a page.
bool is_gallery_page(std::string_view html);

/// Whether the page links a file of the gallery: "pages/crt.html".
bool has_gallery_link(std::string_view html, const std::string& path);
