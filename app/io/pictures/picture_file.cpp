#include "io/pictures/picture_file.h"

#include "base/file.h"
#include "base/text.h"
#include "io/files/atomic_file.h"
#include "io/pictures/picture_codec.h"
#include "io/pictures/picture_kind.h"
#include "io/pictures/png_chunks.h"
#include "io/pictures/png_encoder.h"
#include "model/picture/display_bytes.h"

namespace fs = std::filesystem;

namespace {
// Checks a file before a library reads it. libpng would print the errors of a damaged PNG to
// stderr, so its header and checksums are checked first.
Result<void> check_file(const fs::path& file) {
    const auto start = read_start(file, png_signature().size());
    if (!start)
        return fail(start.error());
    if (start->empty())
        return fail({file, 0, "the file is empty"});
    if (!is_png(*start))
        return {};
    const auto bytes = read_bytes(file);
    if (!bytes)
        return fail(bytes.error());
    const auto chunks = parse_png_chunks(*bytes);
    if (!chunks)
        return fail({file, 0, chunks.error().front().message});
    if (const std::string fault = fault_of_png(*chunks); !fault.empty())
        return fail({file, 0, fault});
    return {};
}

// Sets the file of diagnostics without a file.
Diagnostics about_file(Diagnostics diagnostics, const fs::path& file) {
    for (Diagnostic& diagnostic : diagnostics)
        diagnostic.file = file;
    return diagnostics;
}

Result<std::string> encode_exr(const Picture& picture, const SaveOptions& options) {
    const auto codec = picture_codec();
    if (!codec)
        return fail(codec.error());
    return (*codec)->encode_exr(picture, options.half);
}
}  // namespace

Result<Picture> load_picture(const fs::path& file) {
    if (const auto good = check_file(file); !good)
        return fail(good.error());
    const auto start = read_start(file, picture_start);
    if (!start)
        return fail(start.error());
    const std::string kind = picture_kind(*start, file);
    if (kind.empty())
        return fail({file, 0,
                     "can't read the picture: not a PNG, JPEG, EXR, TIFF, HDR, GIF, WebP, HEIF, "
                     "PSD, DDS, JPEG 2000, BMP, PNM or TGA file"});
    const auto codec = picture_codec();
    if (!codec)
        return fail(about_file(codec.error(), file));
    return (*codec)->read(file, kind);
}

Result<void> save_picture(const Picture& picture, const fs::path& file,
                          const SaveOptions& options) {
    const std::string extension = to_lower(file.extension().string());
    if (extension != ".png" && extension != ".exr")
        return fail({file, 0, "can't save the picture: the file name must end in .png or .exr"});
    const auto bytes = extension == ".png" ? encode_png(picture) : encode_exr(picture, options);
    if (!bytes)
        return fail(about_file(bytes.error(), file));
    return write_atomically(file, *bytes);
}

Result<std::string> encode_picture(const RawPicture& picture, std::string_view extension) {
    if (extension == ".png")
        return encode_png(picture.extent, display_bytes(picture));
    const auto codec = picture_codec();
    if (!codec)
        return fail(codec.error());
    if (std::holds_alternative<RawPicture::Bytes>(picture.pixels))
        return (*codec)->encode_exr(picture_of(picture), false);
    return (*codec)->encode_raw_exr(picture);
}
