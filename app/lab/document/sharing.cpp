#include "lab/document/sharing.h"

#include "base/text.h"
#include "formats/look_format.h"
#include "formats/preset/preset_format.h"
#include "formats/preset/preset_png.h"
#include "formats/preset/share_line.h"
#include "io/files/atomic_file.h"
#include "io/pictures/picture_file.h"
#include "io/pictures/png_encoder.h"
#include "lab/document/opened_preset.h"
#include "model/picture/display_bytes.h"

namespace fs = std::filesystem;

void remember_files(const Document& document, const RecentMedia& recent) {
    for (const StackPart& part : document.look().stack)
        if (is_foreign_look(part.path))
            recent.remember(part.path, {});
    for (const auto& [name, value] : document.values())
        if (names_file(document.look(), name, value))
            recent.remember(value.path, {});
}

namespace {
Preset portable(Preset preset, const Document& document, const fs::path& folder,
                const RecentMedia& recent) {
    remember_files(document, recent);
    return with_portable_media(std::move(preset), folder, recent);
}
}  // namespace

Preset portable_preset_of(const Document& document, const fs::path& file,
                          const RecentMedia& recent) {
    return portable(preset_of(document), document, media_folder(file), recent);
}

std::string share_line_of(const Document& document, const RecentMedia& recent) {
    return share_line(portable(complete_preset_of(document), document, {}, recent),
                      &document.look());
}

Result<void> write_preset(const Document& document, const std::string& name, const fs::path& file,
                          const RecentMedia& recent) {
    if (to_lower(file.extension().string()) != ".json")
        return fail({file, 0, "preset files must end in .json"});
    Preset preset = portable_preset_of(document, file, recent);
    if (!name.empty())
        preset.name = name;
    if (preset.name.empty())
        preset.name = file.stem().string();
    return save_preset(file, preset, &document.look());
}

Result<std::string> png_with_preset(const std::string& png, const Document& document,
                                    const RecentMedia& recent) {
    return with_preset(png, portable(complete_preset_of(document), document, {}, recent),
                       &document.look());
}

Result<std::string> png_of(const Picture& picture, const Document& document,
                           const RecentMedia& recent) {
    const bool has_alpha = document.look().passes.back().has_alpha && is_transparent(picture);
    auto png = has_alpha ? encode_png_with_alpha(picture.extent, display_bytes_with_alpha(picture))
                         : encode_png(picture);
    return png ? png_with_preset(*png, document, recent) : fail(png.error());
}

Result<void> save_picture_with_preset(const Picture& picture, const Document& document,
                                      const fs::path& file, const RecentMedia& recent) {
    if (to_lower(file.extension().string()) != ".png")
        return save_picture(picture, file);
    const auto png = png_of(picture, document, recent);
    return png ? write_atomically(file, *png) : fail(png.error());
}
