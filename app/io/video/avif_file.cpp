#include "io/video/avif_file.h"

#include "io/video/film_file.h"
#include "io/video/frame_bytes.h"

Result<void> save_avif(const RawPicture& picture, const std::filesystem::path& file,
                       std::optional<double> quality) {
    const auto encoding = film_encoding(file, {.quality = quality});
    if (!encoding)
        return fail(encoding.error());
    auto target =
        FilmFile::create(file, {.extent = picture.extent, .rate = {1, 1}, .encoding = *encoding});
    if (!target)
        return fail(target.error());
    if (auto added = (*target)->add(frame_bytes(picture, encoding->bits(), FrameAlpha::none));
        !added)
        return added;
    return (*target)->finish();
}
