#include "io/pictures/caption.h"

#include "base/file.h"
#include "base/font_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stb_truetype.h>
#include <utility>

namespace {
constexpr std::array<float, 4> ink{0.86f, 0.88f, 0.86f, 1.0f};
constexpr char32_t ellipsis = U'…';
constexpr std::size_t largest_font = 64 << 20;  // bytes

// The code points of a UTF-8 text; an invalid sequence becomes U+FFFD.
std::u32string code_points(const std::string& text) {
    std::u32string points;
    std::size_t i = 0;
    const auto byte = [&](std::size_t at) {
        return at < text.size() ? static_cast<unsigned char>(text[at]) : 0U;
    };
    while (i < text.size()) {
        const unsigned first = byte(i++);
        const int more = first < 0x80   ? 0
                         : first < 0xC0 ? -1
                         : first < 0xE0 ? 1
                         : first < 0xF0 ? 2
                                        : 3;
        char32_t point = more <= 0 ? first : first & (0x3FU >> more);
        bool is_whole = more >= 0;
        for (int k = 0; k < more && is_whole; ++k) {
            is_whole = (byte(i) & 0xC0U) == 0x80U;
            if (is_whole)
                point = (point << 6U) | (byte(i++) & 0x3FU);
        }
        points.push_back(is_whole ? point : U'\uFFFD');
    }
    return points;
}

class Font {
public:
    static Result<Font> load(const std::filesystem::path& file, int height) {
        auto bytes = read_bytes(file, largest_font);
        if (!bytes)
            return fail(bytes.error());
        Font font(std::move(*bytes));
        if (const int start = stbtt_GetFontOffsetForIndex(font.data(), 0);
            start < 0 || !stbtt_InitFont(&font.m_info, font.data(), start))
            return fail({file, 0, "can't use this font"});
        font.m_scale = stbtt_ScaleForMappingEmToPixels(&font.m_info, static_cast<float>(height));
        return font;
    }

    /// The width of the text in pixels. Calls `place(glyph, x)` for each glyph; the first has x =
    /// 0.
    template <class Visit>
    float walk(const std::u32string& text, const Visit& position) const {
        float x = 0.0f;
        int previous = 0;
        for (const char32_t point : text) {
            const int glyph = stbtt_FindGlyphIndex(&m_info, static_cast<int>(point));
            if (previous != 0)
                x += m_scale *
                     static_cast<float>(stbtt_GetGlyphKernAdvance(&m_info, previous, glyph));
            position(glyph, x);
            int advance = 0;
            int bearing = 0;
            stbtt_GetGlyphHMetrics(&m_info, glyph, &advance, &bearing);
            x += m_scale * static_cast<float>(advance);
            previous = glyph;
        }
        return x;
    }

    float width_of(const std::u32string& text) const {
        return walk(text, [](int, float) {});
    }

    /// Blends a glyph, with its origin at x, y on the baseline, over the picture.
    void draw(int glyph, float x, int y, Picture& picture) const {
        const float whole = std::floor(x);
        int width = 0;
        int height = 0;
        int left = 0;
        int top = 0;
        const std::unique_ptr<unsigned char, void (*)(unsigned char*)> coverage(
            stbtt_GetGlyphBitmapSubpixel(&m_info, m_scale, m_scale, x - whole, 0.0f, glyph, &width,
                                         &height, &left, &top),
            [](unsigned char* bitmap) { stbtt_FreeBitmap(bitmap, nullptr); });
        for (int row = 0; coverage && row < height; ++row)
            for (int column = 0; column < width; ++column)
                mix(picture, static_cast<int>(whole) + left + column, y + top + row,
                    static_cast<float>(coverage.get()[row * width + column]) / 255.0f);
    }

private:
    explicit Font(std::string bytes) : m_bytes(std::make_unique<std::string>(std::move(bytes))) {}

    const unsigned char* data() const {
        return reinterpret_cast<const unsigned char*>(m_bytes->data());
    }

    static void mix(Picture& picture, int x, int y, float share) {
        if (x < 0 || y < 0 || x >= picture.extent.width || y >= picture.extent.height)
            return;
        const auto channels = static_cast<std::size_t>(picture.channels);
        const auto pixel =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.extent.width) +
            static_cast<std::size_t>(x);
        for (std::size_t i = 0; i < std::min(channels, ink.size()); ++i) {
            float& value = picture.pixels[pixel * channels + i];
            value += share * (ink[i] - value);
        }
    }

    std::unique_ptr<std::string> m_bytes;  // on the heap: m_info points into it
    stbtt_fontinfo m_info{};
    float m_scale = 1.0f;
};

std::u32string fitted(std::u32string text, float width, const Font& font) {
    if (font.width_of(text) <= width)
        return text;
    while (!text.empty() && font.width_of(text + ellipsis) > width)
        text.pop_back();
    return text + ellipsis;
}
}  // namespace

Result<void> draw_caption(Picture& picture, const CaptionPosition& position,
                          const std::string& text) {
    const std::string file =
        find_font_file({"Inter-Regular.otf", "Inter-Regular.ttf", "DejaVuSans.ttf"});
    if (file.empty())
        return fail(
            {{}, 0, "no font for captions found. Install the Debian package fonts-dejavu-core."});
    const auto font = Font::load(file, position.height);
    if (!font)
        return fail(font.error());
    const std::u32string line =
        fitted(code_points(text), static_cast<float>(position.width), *font);
    font->walk(line, [&](int glyph, float x) {
        font->draw(glyph, static_cast<float>(position.left) + x, position.baseline, picture);
    });
    return {};
}
