#include "io/caption.h"

#include "base/font_file.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

namespace {
constexpr std::array<float, 4> ink{0.86f, 0.88f, 0.86f, 1.0f};

int width_of(const std::string& text, int height, const std::string& font) {
    const OIIO::ROI box = OIIO::ImageBufAlgo::text_size(text, height, font);
    return box.defined() ? box.width() : 0;
}

// A letter is one byte, or one that starts with 11 and some that start with 10.
void drop_last_letter(std::string& text) {
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U)
        text.pop_back();
    if (!text.empty())
        text.pop_back();
}

std::string fitted(std::string text, const CaptionPlace& place, const std::string& font) {
    if (width_of(text, place.height, font) <= place.width)
        return text;
    while (!text.empty() && width_of(text + "…", place.height, font) > place.width)
        drop_last_letter(text);
    return text + "…";
}
}  // namespace

Result<void> draw_caption(Picture& picture, const CaptionPlace& place, std::string text) {
    const std::string font =
        find_font_file({"Inter-Regular.otf", "Inter-Regular.ttf", "DejaVuSans.ttf"});
    if (font.empty())
        return fail({{}, 0, "no font for captions was found (Debian's is in fonts-dejavu-core)"});
    const OIIO::ImageSpec spec(picture.extent.width, picture.extent.height, picture.channels,
                               OIIO::TypeDesc::FLOAT);
    OIIO::ImageBuf canvas(spec, picture.pixels.data());
    if (!OIIO::ImageBufAlgo::render_text(canvas, place.left, place.baseline,
                                         fitted(std::move(text), place, font), place.height, font,
                                         ink))
        return fail({font, 0, "cannot write with this font: " + canvas.geterror()});
    return {};
}
