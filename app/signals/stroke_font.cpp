#include "signals/stroke_font.h"

#include "base/text.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace {
// Each glyph is strokes between spaces, each stroke corners of two digits: 0..4 across, 0..6 up.
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
constexpr double advance = 6.0;  // from letter to letter
constexpr double line_advance = 10.0;
constexpr double small_capital = 0.75;

std::string_view strokes_of(char character) {
    const auto found =
        std::find_if(stroke_glyphs.begin(), stroke_glyphs.end(),
                     [character](const Glyph& glyph) { return glyph.character == character; });
    return found == stroke_glyphs.end() ? missing_glyph : found->strokes;
}

// One stand-in for each character of a UTF-8 text: itself, or 0 for one beyond ASCII.
std::vector<char> characters_of(std::string_view text) {
    std::vector<char> characters;
    for (const char byte : text) {
        const auto bits = static_cast<unsigned char>(byte);
        const bool goes_on = (bits & 0xC0) == 0x80;
        if (!goes_on)
            characters.push_back(bits < 0x80 ? byte : '\0');
    }
    return characters;
}

void add_letter(char character, double x, double y, double unit, std::vector<ScenePath>& paths) {
    if (character == ' ')
        return;
    const bool is_small = character >= 'a' && character <= 'z';
    const char capital =
        is_small ? static_cast<char>(std::toupper(static_cast<unsigned char>(character)))
                 : character;
    const double height = is_small ? small_capital : 1.0;
    for (const std::string_view stroke : split(strokes_of(capital), ' ')) {
        ScenePath path;
        for (std::size_t i = 0; i + 1 < stroke.size(); i += 2)
            path.points.push_back(
                {x + unit * (stroke[i] - '0'), y + unit * height * (stroke[i + 1] - '0')});
        paths.push_back(std::move(path));
    }
}

double width_of(std::size_t letters) {
    return letters == 0 ? 0.0 : advance * static_cast<double>(letters - 1) + units_wide;
}
}  // namespace

std::vector<ScenePath> text_paths(std::string_view text, double height, TextAlign align) {
    std::vector<std::vector<char>> lines;
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
        for (const char character : lines[i]) {
            add_letter(character, unit * x, unit * y, unit, paths);
            x += advance;
        }
    }
    return paths;
}
