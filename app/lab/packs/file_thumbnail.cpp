#include "lab/packs/file_thumbnail.h"

#include "base/file.h"
#include "base/job_progress.h"
#include "formats/pack/pack_format.h"
#include "io/files/zip.h"
#include "io/pictures/png_encoder.h"
#include "lab/library/look_templates.h"
#include "lab/library/open.h"
#include "lab/offline/preset_thumbnail_renderer.h"

#include <algorithm>

namespace fs = std::filesystem;

namespace {
constexpr std::size_t largest_text = std::size_t{16} << 20;
constexpr std::size_t largest_picture = std::size_t{4} << 20;

// The picture of the first look or preset that has one.
Result<std::string> thumbnail_in_pack(const fs::path& pack) {
    auto text = read_in_zip(pack, pack_file, largest_text);
    if (!text)
        return text;
    const auto manifest = parse_pack(*text, pack);
    if (!manifest)
        return fail(manifest.error());
    std::vector<std::string> places;
    for (const PackedLook& look : manifest->looks)
        places.push_back(look.thumbnail.empty() ? look.folder + "/" + picture_name
                                                : look.thumbnail);
    for (const PackedPreset& preset : manifest->presets)
        places.push_back(preset.thumbnail);
    for (const std::string& place : places)
        if (auto picture = read_in_zip(pack, place, largest_picture); !picture || !picture->empty())
            return picture;
    return fail({pack, 0, "has no thumbnails"});
}

Result<std::string> drawn(const OpenRequest& request, const Library& library) {
    LoadedLook loaded = load_requested(request, library);
    if (!loaded.look)
        return fail(loaded.look.error());
    PresetThumbnailRenderer renderer(std::move(*loaded.look), library, std::nullopt, Pace::full);
    const auto picture = renderer.paint(request.preset_file, JobProgress());
    return picture ? encode_png(*picture) : fail(picture.error());
}
}  // namespace

Result<std::string> file_thumbnail(const fs::path& file, const Library& library) {
    if (is_pack(file))
        return thumbnail_in_pack(file);
    const auto request = resolve(file.string(), library);
    if (!request)
        return fail(request.error());
    std::error_code error;
    const fs::path picture = request->look / picture_name;
    if (!request->preset && fs::is_regular_file(picture, error))
        return read_bytes(picture, largest_picture);
    return drawn(*request, library);
}
