#include "signals/drawing/accented_letters.h"

#include <algorithm>
#include <array>

namespace {
struct Mark {
    char32_t combining;        // in Unicode
    std::string_view strokes;  // like a glyph's; 0 to 2 up from 1 above or 2 below the letter
    bool is_above;
    std::u32string_view letters;  // with the mark
    std::string_view bases;       // without it, in the same order
};

// Latin-1, Latin Extended-A and the letters of Romanian, decomposed as in Unicode.
constexpr std::array marks{
    Mark{0x300, "1230", true, U"ÀÈÌÒÙàèìòù", "AEIOUaeiou"},                              // grave
    Mark{0x301, "1032", true, U"ÁÉÍÓÚÝáéíóúýĆćĹĺŃńŔŕŚśŹź", "AEIOUYaeiouyCcLlNnRrSsZz"},  // acute
    Mark{0x302, "002240", true, U"ÂÊÎÔÛâêîôûĈĉĜĝĤĥĴĵŜŝŴŵŶŷ",
         "AEIOUaeiouCcGgHhJjSsWwYy"},                                          // circumflex
    Mark{0x303, "00113041", true, U"ÃÑÕãñõĨĩŨũ", "ANOanoIiUu"},                // tilde
    Mark{0x308, "1011 3031", true, U"ÄËÏÖÜäëïöüÿŸ", "AEIOUaeiouyY"},           // diaeresis
    Mark{0x30a, "2031221120", true, U"ÅåŮů", "AaUu"},                          // ring
    Mark{0x304, "1131", true, U"ĀāĒēĪīŌōŪū", "AaEeIiOoUu"},                    // macron
    Mark{0x306, "0211203142", true, U"ĂăĔĕĞğĬĭŎŏŬŭ", "AaEeGgIiOoUu"},          // breve
    Mark{0x307, "2021", true, U"ĊċĖėĠġİŻż", "CcEeGgIZz"},                      // dot
    Mark{0x30b, "1022 3042", true, U"ŐőŰű", "OoUu"},                           // double acute
    Mark{0x30c, "022042", true, U"ČčĎďĚěĽľŇňŘřŠšŤťŽž", "CcDdEeLlNnRrSsTtZz"},  // caron
    Mark{0x327, "22312010", false, U"ÇçĢģĶķĻļŅņŖŗŞşŢţ", "CcGgKkLlNnRrSsTt"},   // cedilla
    Mark{0x328, "32212030", false, U"ĄąĘęĮįŲų", "AaEeIiUu"},                   // ogonek
    Mark{0x326, "2210", false, U"ȘșȚț", "SsTt"},                               // comma
};

// Letters that are not a base letter with a mark, large and small.
struct Special {
    char32_t large;
    char32_t small;
    std::string_view strokes;
};
constexpr std::array specials{
    Special{U'Æ', U'æ', "002646 2620 2040 1343"},
    Special{U'Ð', U'ð', "00062644422000 0323"},
    Special{U'Đ', U'đ', "00062644422000 0323"},
    Special{U'Ø', U'ø', "010516364541301001 0046"},
    Special{U'Þ', U'þ', "0006 0535443202"},
    Special{U'ẞ', U'ß', "00051626354433 233342413020"},
    Special{U'Ħ', U'ħ', "0006 4640 0343 0545"},
    Special{U'Ĳ', U'ĳ', "0600 1120304146"},
    Special{U'Ŀ', U'ŀ', "060040 2333"},
    Special{U'Ł', U'ł', "060040 0224"},
    Special{U'Ŋ', U'ŋ', "00064041 46412010"},
    Special{U'Œ', U'œ', "461605011040 2620 2343"},
    Special{U'Ŧ', U'ŧ', "0646 2620 1333"},
    Special{U'I', U'ı', "1636 2620 1030"},
    Special{U'K', U'ĸ', "0600 460340"},
    Special{U'S', U'ſ', "453616050413334241301001"},
    Special{U'N', U'ŉ', "00064046 0605"},
    // Signs used in names and titles.
    Special{U'¡', 0, "2024 2526"},
    Special{U'¿', 0, "41301001122324 2526"},
    Special{U'·', 0, "2333"},
    Special{U'°', 0, "1526351415"},
    Special{U'×', 0, "0145 0541"},
    Special{U'÷', 0, "0343 2425 2122"},
    Special{U'±', 0, "0444 2226 0141"},
    Special{U'£', 0, "4536261504 0040 0434 0401"},
    Special{U'–', 0, "0343"},
    Special{U'—', 0, "0343"},
    Special{U'‘', 0, "1625"},
    Special{U'’', 0, "2615"},
    Special{U'“', 0, "0615 2635"},
    Special{U'”', 0, "1605 3625"},
    Special{U'„', 0, "1100 3120"},
    Special{U'«', 0, "250321 452341"},
    Special{U'»', 0, "052301 254321"},
    Special{U'…', 0, "0001 2021 4041"},
    Special{U'€', 0, "4536160501103041 0232 0434"},
};
}  // namespace

std::optional<AccentedLetter> find_accented_letter(char32_t letter) {
    for (const Mark& mark : marks)
        if (const auto at = mark.letters.find(letter); at != std::u32string_view::npos)
            return AccentedLetter{mark.bases[at], {}, mark.strokes, mark.is_above, false};
    constexpr char32_t first_beyond_ascii = 0x80;
    for (const Special& special : specials)
        if (letter >= first_beyond_ascii && (letter == special.small || letter == special.large))
            return AccentedLetter{0, special.strokes, {}, true, letter == special.small};
    return std::nullopt;
}

std::optional<char32_t> composed_letter(char32_t base, char32_t combining) {
    for (const Mark& mark : marks)
        if (mark.combining == combining)
            for (std::size_t i = 0; i < mark.bases.size(); ++i)
                if (static_cast<char32_t>(static_cast<unsigned char>(mark.bases[i])) == base)
                    return mark.letters[i];
    return std::nullopt;
}
