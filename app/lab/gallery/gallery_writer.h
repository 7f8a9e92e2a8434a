#pragma once

#include "base/diagnostic.h"
#include "lab/gallery/gallery_page.h"
#include "lab/library/library.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

struct GalleryRequest {
    std::vector<std::string> looks;  // as for gallery_contents()
    std::filesystem::path folder;
    bool has_pages = true;  // a live page per card
};

struct WrittenGallery {
    std::vector<GallerySection> sections;
    std::size_t files = 0;
    std::uintmax_t bytes = 0;
    // Looks that a web page can't draw, and errors of looks and presets that were left out.
    Diagnostics warnings;
};

using GalleryProgress = std::function<void(int done, int all)>;

/// Writes a folder with a page, thumbnails of 480 x 270 px and live pages. All or nothing: fails
/// if all looks and presets have errors, and for a folder with other files.
Result<WrittenGallery> write_gallery(const GalleryRequest& request, const Library& library,
                                     const GalleryProgress& progress);
