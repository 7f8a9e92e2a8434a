#include "signals/drawing/stroke_font.h"

#include "base/text.h"
#include "signals/drawing/accented_letters.h"

#include <algorithm>
#include <array>

namespace {
// Glyph: strokes separated by spaces. Stroke: corners of two digits, 0..4 across and 0..6 up.
struct Glyph {
    char character;
    std::string_view strokes;
};

constexpr std::array stroke_glyphs{
    Glyph{'A', "0004264440 0242"},
    Glyph{'B', "00063645443303 3342413000"},
    Glyph{'C', "4536160501103041"},
    Glyph{'D', "00062644422000"},
    Glyph{'E', "46060040 0333"},
    Glyph{'F', "460600 0333"},
    Glyph{'G', "45361605011030414323"},
    Glyph{'H', "0006 4640 0343"},
    Glyph{'I', "1636 2620 1030"},
    Glyph{'J', "0110304146"},
    Glyph{'K', "0600 460340"},
    Glyph{'L', "060040"},
    Glyph{'M', "0006234640"},
    Glyph{'N', "00064046"},
    Glyph{'O', "010516364541301001"},
    Glyph{'P', "00063645443303"},
    Glyph{'Q', "010516364541301001 2240"},
    Glyph{'R', "00063645443303 2340"},
    Glyph{'S', "453616050413334241301001"},
    Glyph{'T', "0646 2620"},
    Glyph{'U', "060110304146"},
    Glyph{'V', "062046"},
    Glyph{'W', "0610233046"},
    Glyph{'X', "0046 4006"},
    Glyph{'Y', "062346 2320"},
    Glyph{'Z', "06460040"},
    Glyph{'0', "010516364541301001 1135"},
    Glyph{'1', "152620 1030"},
    Glyph{'2', "05163645440040"},
    Glyph{'3', "05163645443313 334241301001"},
    Glyph{'4', "30360242"},
    Glyph{'5', "460603334241301001"},
    Glyph{'6', "4536160501103041423303"},
    Glyph{'7', "064610"},
    Glyph{'8', "13040516364544331302011030414233"},
    Glyph{'9', "4313040516364541301001"},
    Glyph{'.', "2021"},
    Glyph{',', "2110"},
    Glyph{':', "2122 2425"},
    Glyph{';', "2110 2425"},
    Glyph{'!', "2622 2120"},
    Glyph{'?', "05163645442322 2120"},
    Glyph{'-', "1333"},
    Glyph{'+', "0343 2125"},
    Glyph{'=', "0242 4404"},
    Glyph{'*', "0343 1135 3115"},
    Glyph{'/', "0046"},
    Glyph{'\\', "0640"},
    Glyph{'|', "2026"},
    Glyph{'(', "36252130"},
    Glyph{')', "16252110"},
    Glyph{'[', "36161030"},
    Glyph{']', "16363010"},
    Glyph{'<', "450341"},
    Glyph{'>', "054301"},
    Glyph{'_', "0040"},
    Glyph{'\'', "2624"},
    Glyph{'"', "1614 3436"},
    Glyph{'#', "1016 3630 0242 4404"},
    Glyph{'%', "0046 0506161505 3031414030"},
    Glyph{'&', "4004051625240201102042"},
    Glyph{'@', "32341412324245361605011040"},
    Glyph{'$', "453616050413334241301001 2026"},
    Glyph{'^', "042644"},
    Glyph{'~', "03143344"},
};
constexpr std::string_view missing_glyph = "0006464000";

constexpr double units_high = 6.0;
constexpr double units_wide = 4.0;
constexpr double advance = 6.0;  // between letters
constexpr double line_advance = 10.0;
constexpr double small_capital = 0.75;

const Glyph* find_glyph(char32_t character) {
    const auto found =
        std::find_if(stroke_glyphs.begin(), stroke_glyphs.end(), [character](const Glyph& glyph) {
            return static_cast<char32_t>(static_cast<unsigned char>(glyph.character)) == character;
        });
    return found == stroke_glyphs.end() ? nullptr : &*found;
}

std::string utf8_of(char32_t character) {
    const auto tail = [character](unsigned shift) {
        return static_cast<char>(0x80u | ((character >> shift) & 0x3fu));
    };
    if (character < 0x80)
        return {static_cast<char>(character)};
    if (character < 0x800)
        return {static_cast<char>(0xc0u | character >> 6), tail(0)};
    if (character < 0x10000)
        return {static_cast<char>(0xe0u | character >> 12), tail(6), tail(0)};
    return {static_cast<char>(0xf0u | character >> 18), tail(12), tail(6), tail(0)};
}

// Decodes UTF-8; 0xFFFD for invalid bytes. Composes letters followed by combining marks (NFD, as in
// file names).
std::vector<char32_t> characters_of(std::string_view text) {
    std::vector<char32_t> characters;
    for (std::size_t i = 0; i < text.size();) {
        const auto first = static_cast<unsigned char>(text[i++]);
        const int more = first < 0x80 ? 0 : first < 0xe0 ? 1 : first < 0xf0 ? 2 : 3;
        char32_t character = first < 0x80 ? first : first & (0x3fu >> more);
        for (int k = 0; k < more; ++k) {
            const bool goes_on =
                i < text.size() && (static_cast<unsigned char>(text[i]) & 0xc0u) == 0x80u;
            character = goes_on ? character << 6 | (static_cast<unsigned char>(text[i]) & 0x3fu)
                                : U'\uFFFD';
            i += goes_on ? 1 : 0;
        }
        const auto composed = !characters.empty() && character >= 0x300 && character < 0x370
                                  ? composed_letter(characters.back(), character)
                                  : std::nullopt;
        if (composed)
            characters.back() = *composed;
        else
            characters.push_back(character);
    }
    return characters;
}

bool is_small(char32_t character) {
    return character >= 'a' && character <= 'z';
}

/// Position and scale of a glyph's strokes.
struct GlyphPosition {
    double x;
    double y;
    double unit;
    double height;  // relative to a capital
};

void add_strokes(std::string_view strokes, const GlyphPosition& at, std::vector<ScenePath>& paths) {
    for (const std::string_view stroke : split(strokes, ' ')) {
        ScenePath path;
        for (std::size_t i = 0; i + 1 < stroke.size(); i += 2)
            path.points.push_back({at.x + at.unit * (stroke[i] - '0'),
                                   at.y + at.unit * at.height * (stroke[i + 1] - '0')});
        if (!path.points.empty())
            paths.push_back(std::move(path));
    }
}

void add_letter(char32_t character, double x, double y, double unit,
                std::vector<ScenePath>& paths) {
    constexpr double mark_gap = 0.8;
    constexpr double mark_height = 0.6;
    constexpr double mark_room_below = 2.0;
    if (character == ' ')
        return;
    const auto marked = find_accented_letter(character);
    const char32_t plain = marked && marked->base != 0
                               ? static_cast<char32_t>(static_cast<unsigned char>(marked->base))
                               : character;
    const bool is_low = is_small(plain) || (marked && marked->is_small);
    const GlyphPosition glyph_position{x, y, unit, is_low ? small_capital : 1.0};
    const Glyph* const glyph = find_glyph(is_small(plain) ? plain - 'a' + 'A' : plain);
    if (marked && !marked->strokes.empty())
        return add_strokes(marked->strokes, glyph_position, paths);
    add_strokes(glyph ? glyph->strokes : missing_glyph, glyph_position, paths);
    if (!marked)
        return;
    const double above = unit * (units_high * glyph_position.height + mark_gap);
    add_strokes(
        marked->mark,
        {x, y + (marked->is_mark_above ? above : -unit * mark_room_below * mark_height * 1.2), unit,
         mark_height},
        paths);
}

double width_of(std::size_t letters) {
    return letters == 0 ? 0.0 : advance * static_cast<double>(letters - 1) + units_wide;
}
}  // namespace

std::vector<ScenePath> text_paths(std::string_view text, double height, TextAlign align) {
    std::vector<std::vector<char32_t>> lines;
    std::size_t longest = 0;
    for (const std::string_view line : split(text, '\n')) {
        lines.push_back(characters_of(line));
        longest = std::max(longest, lines.back().size());
    }
    const double unit = height / units_high;
    const double block = units_high + line_advance * static_cast<double>(lines.size() - 1);
    std::vector<ScenePath> paths;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const double room = width_of(longest) - width_of(lines[i].size());
        const double indent = align == TextAlign::left    ? 0.0
                              : align == TextAlign::right ? room
                                                          : 0.5 * room;
        double x = indent - 0.5 * width_of(longest);
        const double y = 0.5 * block - units_high - line_advance * static_cast<double>(i);
        for (const char32_t character : lines[i]) {
            add_letter(character, unit * x, unit * y, unit, paths);
            x += advance;
        }
    }
    return paths;
}

std::string missing_letters(std::string_view text) {
    std::vector<char32_t> reported;
    std::string missing;
    for (const char32_t character : characters_of(text)) {
        const char32_t capital = is_small(character) ? character - 'a' + 'A' : character;
        const bool is_known = character == ' ' || character == '\n' || find_glyph(capital) ||
                              find_accented_letter(character);
        if (is_known || std::find(reported.begin(), reported.end(), character) != reported.end())
            continue;
        reported.push_back(character);
        missing += (missing.empty() ? "" : " ") + utf8_of(character);
    }
    return missing;
}
