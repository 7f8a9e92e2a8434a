#include "lab/sharing.h"

#include "base/text.h"
#include "formats/preset_format.h"
#include "formats/preset_png.h"
#include "formats/share_line.h"
#include "io/atomic_file.h"
#include "io/picture_file.h"
#include "io/png_encoder.h"

namespace fs = std::filesystem;

std::string share_line_of(const Document& document, const RecentMedia& recent) {
    return share_line(with_portable_media(document.complete_preset(), {}, recent));
}

Result<void> write_preset(const Document& document, const std::string& name, const fs::path& file,
                          const RecentMedia& recent) {
    if (to_lower(file.extension().string()) != ".json")
        return fail({file, 0, "a preset's file ends in .json"});
    Preset preset = with_portable_media(document.preset(), media_folder(file), recent);
    if (!name.empty())
        preset.name = name;
    if (preset.name.empty())
        preset.name = file.stem().string();
    return save_preset(file, preset);
}

Result<void> save_picture_with_preset(const Picture& picture, const Document& document,
                                      const fs::path& file, const RecentMedia& recent) {
    if (to_lower(file.extension().string()) != ".png")
        return save_picture(picture, file);
    auto png = encode_png(picture);
    if (!png)
        return fail(png.error());
    const auto whole =
        with_preset(std::move(*png), with_portable_media(document.complete_preset(), {}, recent));
    if (!whole)
        return fail(whole.error());
    return write_atomically(file, *whole);
}
