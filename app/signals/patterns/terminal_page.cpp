#include "signals/patterns/terminal_page.h"

#include "signals/patterns/bitmap_font.h"
#include "signals/patterns/resampled.h"

#include <array>
#include <string_view>

namespace {
constexpr int letter_width = 8;
constexpr int letter_height = 16;
constexpr int page_columns = 80;
constexpr int page_lines = 25;
constexpr char cursor = '\x7f';

using Color = std::array<float, 3>;

// '^' and a digit select one of these for the text that follows.
constexpr std::array<Color, 8> page_colors{{
    {0.70f, 0.72f, 0.72f},  // 0 grey
    {1.00f, 0.42f, 0.36f},  // 1 red
    {0.36f, 0.92f, 0.44f},  // 2 green
    {1.00f, 0.80f, 0.28f},  // 3 amber
    {0.42f, 0.60f, 1.00f},  // 4 blue
    {0.92f, 0.50f, 0.92f},  // 5 magenta
    {0.36f, 0.88f, 0.94f},  // 6 cyan
    {1.00f, 1.00f, 1.00f},  // 7 white
}};

constexpr std::array<std::string_view, page_lines> page{
    "^6  AFTERGLOW OBSERVATORY   ^0night log, dome 2        ^3seeing 0.8\"   ^2** LINK UP **",
    "^4 ------------------------------------------------------------------------------",
    "",
    "^7                 _    __ _                    _",
    "^7                / \\  / _| |_ ___ _ __ __ _ | | _____      __      ^3.",
    "^7               / _ \\| |_| __/ _ \\ '__/ _` || |/ _ \\ \\ /\\ / /    ^3'   *",
    "^7              / ___ \\  _| ||  __/ | | (_| || | (_) \\ V  V /   ^3*      .",
    "^7             /_/   \\_\\_|  \\__\\___|_|  \\__, ||_|\\___/ \\_/\\_/",
    "^7                                      |___/        ^0everything fades, slowly",
    "",
    "^0  TIME      OBJECT       ALT   AZ    MAG    NOTES",
    "^0  21:07:40  ^2M57 ring     ^0 61   278   8.8    crisp. the hole is really a hole",
    "^0  21:52:18  ^2Albireo      ^0 54   265   3.1    gold and blue, as promised",
    "^0  22:30:05  ^2Saturn       ^0 23   151   0.4    rings tilted; three moons in a row",
    "^0  23:14:51  ^2M31          ^0 68    87   3.4    light left before there were people",
    "^0  23:58:09  ^5unknown      ^0 12   204   ^1?.?    ^1moved. ^0then it did not. logged",
    "^0  00:41:33  ^2Pleiades     ^0 49   118   1.6    counted eleven without glasses",
    "",
    "^4  $ ^7plot --target saturn --scale log",
    "^3      #                         ^6tube   P31   persistence 38 us",
    "^3    # #   #                     ^6beam   12.4 kV   focus 0.31 mm",
    "^3   ## ## ##     #               ^6mask   0.28 mm dot pitch",
    "^3  ####### ## # ## #   #         ^6ABCDEFGHIJKLM nopqrstuvwxyz 0123456789",
    "^0  0 !\"#$%&'()*+,-./:;<=>?@[\\]_`{|}~",
    "^4  $ ^7make tea && sleep 600 && wake dome2 ^2\x7f",
};

// Each dot is two rows high, followed by a dot of half brightness: the beam decays slowly.
void draw_character(Picture& picture, char character, int column, int line, const Color& color) {
    const auto lit = [&](int x, int row) {
        if (character == cursor || bitmap_font::has_dot(character, x - 1, row))
            return 1.0f;
        return bitmap_font::has_dot(character, x - 2, row) ? 0.5f : 0.0f;
    };
    for (int y = 0; y < letter_height; ++y)
        for (int x = 0; x < letter_width; ++x) {
            const std::size_t at =
                picture.index(column * letter_width + x, line * letter_height + y);
            for (std::size_t c = 0; c < 3; ++c)
                picture.pixels[at + c] = color[c] * lit(x, y / 2);
        }
}

void draw_line(Picture& picture, std::string_view text, int line) {
    Color color = page_colors[0];
    int column = 0;
    for (std::size_t i = 0; i < text.size() && column < page_columns; ++i) {
        if (text[i] == '^' && i + 1 < text.size()) {
            color = page_colors[static_cast<std::size_t>(text[++i] - '0')];
            continue;
        }
        draw_character(picture, text[i], column++, line, color);
    }
}

Picture drawn_page(Extent extent, double /*seconds*/) {
    Picture picture{
        {page_columns * letter_width, page_lines * letter_height}, 3, Encoding::display, {}};
    picture.pixels.resize(picture.index(0, picture.extent.height));
    for (int line = 0; line < page_lines; ++line)
        draw_line(picture, page[static_cast<std::size_t>(line)], line);
    return resampled(picture, extent);
}
}  // namespace

Pattern terminal_page_pattern() {
    return {{"terminal", "Terminal page", "80 x 25 characters of text in eight colours."},
            {page_columns * letter_width, page_lines * letter_height},
            drawn_page};
}
