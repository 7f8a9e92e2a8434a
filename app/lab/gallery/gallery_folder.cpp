#include "lab/gallery/gallery_folder.h"

#include "base/file.h"
#include "base/text.h"
#include "lab/gallery/gallery_page.h"

#include <string_view>

namespace fs = std::filesystem;

namespace {
// The page of a folder with media: "crt_media" is part of "crt.html".
std::string page_of_media(const std::string& name) {
    constexpr std::string_view ending = "_media";
    return name.ends_with(ending) ? name.substr(0, name.size() - ending.size()) + ".html" : name;
}

tl::unexpected<Diagnostics> not_part(const fs::path& file) {
    return fail({file, 0, "is not part of the gallery. Move it, or choose another folder."});
}

Result<void> check_files(const fs::path& folder, const std::string& html) {
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        std::error_code ignored;
        const std::string name = entry.path().filename().string();
        const std::string file = entry.is_directory(ignored) ? page_of_media(name) : name;
        if (!has_gallery_link(html, folder.filename().string() + '/' + file))
            return not_part(entry.path());
    }
    return {};
}
}  // namespace

Result<void> check_gallery_folder(const fs::path& folder) {
    std::error_code error;
    if (!fs::exists(fs::status(folder, error)))
        return {};
    const fs::directory_iterator entries(folder, error);
    if (!error && entries == fs::directory_iterator())
        return {};
    const auto html = error ? Result<std::string>() : read_bytes(folder / gallery_index);
    if (!html || !is_gallery_page(*html))
        return fail({folder, 0, "exists and is not a gallery. Choose another folder."});
    for (const fs::directory_entry& entry : entries) {
        const fs::path name = entry.path().filename();
        if (name == gallery_index)
            continue;
        if (name != gallery_thumbnails && name != gallery_pages)
            return not_part(entry.path());
        if (auto good = check_files(entry.path(), *html); !good)
            return good;
    }
    return {};
}
