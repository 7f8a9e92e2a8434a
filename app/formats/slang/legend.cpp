#include "formats/slang/legend.h"

#include "base/text.h"
#include "formats/slang/decoration.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

namespace {
constexpr std::size_t longest_name = 48;
constexpr int fewest_names = 3;  // minimum that is unlikely to be a coincidence without other
                                 // evidence

struct Pair {
    int first = 0;
    int last = 0;
    std::size_t begin = 0;  // of the number in the text
    std::size_t name = 0;   // start of the name
    bool is_loose = false;  // "0-Name", which may be a word such as "2-phase"
};

// Parses an integer of `text` at `at` and advances `at`: "2", "-1", "1.0".
std::optional<int> take_whole(std::string_view text, std::size_t& at) {
    int number = 0;
    const auto read = std::from_chars(text.data() + at, text.data() + text.size(), number);
    if (read.ec != std::errc{})
        return std::nullopt;
    at = static_cast<std::size_t>(read.ptr - text.data());
    if (text.substr(at).starts_with(".0"))
        at = std::min(text.find_first_not_of('0', at + 1), text.size());
    return number;
}

// Parses "0:Name", "0 = Name", "1-4: Name", "1/2=Name"; in brackets also "0-Name".
std::optional<Pair> pair_at(std::string_view text, std::size_t at, bool is_in_brackets) {
    Pair pair;
    pair.begin = at;
    const auto first = take_whole(text, at);
    if (!first)
        return std::nullopt;
    pair.first = pair.last = *first;
    if (at < text.size() && (text[at] == '-' || text[at] == '/')) {
        std::size_t behind = at + 1;
        if (const auto last = take_whole(text, behind)) {
            pair.last = *last;
            at = behind;
        }
    }
    const std::string_view rest = text.substr(at);
    if (is_in_brackets && rest.size() > 1 && rest[0] == '-' && rest[1] != ' ') {
        pair.name = at + 1;
        pair.is_loose = true;
        return pair;
    }
    at = text.find_first_not_of(' ', at);
    if (at == text.npos || (text[at] != '=' && text[at] != ':'))
        return std::nullopt;
    pair.name = at + 1;
    return pair;
}

std::string_view name_of(std::string_view text) {
    constexpr std::string_view around = " \t,;|:=";
    const std::size_t begin = text.find_first_not_of(around);
    if (begin == text.npos)
        return {};
    return text.substr(begin, text.find_last_not_of(around) + 1 - begin);
}

struct Named {
    std::size_t begin = 0;  // of the first number
    std::vector<Item> items;
};

std::optional<Named> names_behind_numbers(std::string_view text, int low, int high,
                                          bool is_in_brackets) {
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool is_start = i == 0 || std::string_view(" \t([,;|").find(text[i - 1]) != text.npos;
        const auto pair = is_start ? pair_at(text, i, is_in_brackets) : std::nullopt;
        if (!pair)
            continue;
        pairs.push_back(*pair);
        i = pair->name - 1;
    }
    if (pairs.empty() || (pairs.size() == 1 && (!is_in_brackets || pairs[0].is_loose)))
        return std::nullopt;
    Named named{pairs.front().begin, {}};
    int next = low;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const std::size_t end = i + 1 < pairs.size() ? pairs[i + 1].begin : text.size();
        const std::string name(name_of(text.substr(pairs[i].name, end - pairs[i].name)));
        if (pairs[i].first < next || pairs[i].last < pairs[i].first || pairs[i].last > high ||
            name.empty() || name.size() > longest_name)
            return std::nullopt;
        for (int number = pairs[i].first; number <= pairs[i].last; ++number)
            named.items.push_back(
                {static_cast<double>(number),
                 pairs[i].first == pairs[i].last ? name : fmt::format("{} ({})", name, number)});
        next = pairs[i].last + 1;
    }
    return named;
}

bool is_on_off(std::string_view a, std::string_view b) {
    const std::string both = to_lower(a) + "/" + to_lower(b);
    return both == "off/on" || both == "on/off";
}

// The piece without its number, "1: BGR"; nullopt for another number or none.
std::optional<std::string_view> without_number(std::string_view piece, int number) {
    std::size_t at = 0;
    const auto own = take_whole(piece, at);
    if (own != number || at >= piece.size() ||
        std::string_view("=:-). ").find(piece[at]) == piece.npos)
        return std::nullopt;
    const std::size_t name = piece.find_first_not_of("=:-). ", at);
    return name == piece.npos ? std::nullopt : std::optional(piece.substr(name));
}

std::vector<Item> items_of(const std::vector<std::string_view>& pieces, int low) {
    std::vector<Item> bare;
    std::vector<Item> whole;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const int number = low + static_cast<int>(i);
        whole.push_back({static_cast<double>(number), std::string(pieces[i])});
        if (const auto name = without_number(pieces[i], number))
            bare.push_back({static_cast<double>(number), std::string(*name)});
    }
    return bare.size() == whole.size() ? bare : whole;
}

// The names in `body` if it has one for each number.
std::vector<Item> listed_names(std::string_view body, int low, int high) {
    const std::size_t first = body.find_first_of("|;,/");
    if (first == body.npos)
        return {};
    // The outermost separator: '|' before ';' before ',' before '/'.
    char separator = '/';
    for (const char other : {',', ';', '|'})
        if (body.find(other) != body.npos)
            separator = other;
    std::vector<std::string_view> pieces = split(body, separator);
    for (std::string_view& piece : pieces)
        piece = trim(piece);
    if (static_cast<int>(pieces.size()) != high - low + 1)
        return {};
    const bool is_named = std::ranges::all_of(pieces, [](std::string_view piece) {
        return !piece.empty() && piece.size() <= longest_name;
    });
    if (!is_named)
        return {};
    if (separator == '/' && pieces.size() == 2) {
        // "On/Off" indicates a switch; it does not mean that 0 is on.
        if (low != 0 || !is_on_off(pieces[0], pieces[1]))
            return {};
        return {{0.0, "Off"}, {1.0, "On"}};
    }
    return items_of(pieces, low);
}

// The end of the label and the start of the names in "Label - A | B" or "Label: A | B".
struct Cut {
    std::size_t label_end = 0;
    std::size_t names = 0;
};

std::optional<Cut> cut_before_names(std::string_view head) {
    std::optional<Cut> cut;
    for (std::size_t i = 0; i < head.size(); ++i) {
        const bool is_of_number = i > 0 && head[i - 1] >= '0' && head[i - 1] <= '9';
        if (head[i] == ':' && !is_of_number)
            cut = Cut{i, i + 1};
        else if (head.substr(i).starts_with(" - "))
            cut = Cut{i, i + 3};
    }
    return cut;
}

// The position of the bracket that closes at the end of the text.
std::optional<std::size_t> opening_bracket(std::string_view text) {
    if (text.empty() || (text.back() != ')' && text.back() != ']'))
        return std::nullopt;
    const char close = text.back();
    const char open = close == ')' ? '(' : '[';
    int depth = 0;
    for (std::size_t i = text.size(); i-- > 0;) {
        depth += text[i] == close ? 1 : text[i] == open ? -1 : 0;
        if (depth == 0)
            return i;
    }
    return std::nullopt;
}

SlangLegend legend(std::string_view label, std::vector<Item> items) {
    return {std::string(without_decoration(label)), std::move(items)};
}

std::optional<SlangLegend> legend_in_brackets(std::string_view text, int low, int high) {
    const auto open = opening_bracket(text);
    if (!open)
        return std::nullopt;
    const std::string_view body = trim(text.substr(*open + 1, text.size() - *open - 2));
    const std::string_view label = text.substr(0, *open);
    if (auto items = listed_names(body, low, high); !items.empty())
        return legend(label, std::move(items));
    if (auto named = names_behind_numbers(body, low, high, true))
        return legend(label, std::move(named->items));
    return std::nullopt;
}

std::optional<SlangLegend> legend_behind_label(std::string_view text, int low, int high) {
    const std::size_t bar = text.find('|');
    const auto cut = cut_before_names(text.substr(0, bar));
    if (cut)
        if (auto items = listed_names(text.substr(cut->names), low, high); !items.empty())
            return legend(text.substr(0, cut->label_end), std::move(items));
    // A legend only: "0: OFF | 1: ON".
    std::size_t at = 0;
    if (bar != text.npos && take_whole(text, at) == low)
        if (auto items = listed_names(text, low, high); !items.empty())
            return legend({}, std::move(items));
    if (auto named = names_behind_numbers(text, low, high, false))
        return legend(text.substr(0, named->begin), std::move(named->items));
    return std::nullopt;
}

// "Vignette On/Off", "Palette Hercules/CGA/EGA".
std::optional<SlangLegend> names_at_the_end(std::string_view text, int low, int high) {
    const std::size_t blank = text.find_last_of(" \t");
    if (blank == text.npos || text.find_first_of("|;,", blank) != text.npos)
        return std::nullopt;
    const std::size_t label_end = text.find_last_not_of(" \t,;", blank) + 1;
    if (auto items = listed_names(text.substr(blank + 1), low, high); !items.empty())
        return legend(text.substr(0, label_end), std::move(items));
    return std::nullopt;
}

// "Range 0-multi 1-hor 2-vert": each number has a name.
std::optional<SlangLegend> names_behind_dashes(std::string_view text, int low, int high) {
    auto named = names_behind_numbers(text, low, high, true);
    if (high - low + 1 < fewest_names || !named ||
        static_cast<int>(named->items.size()) != high - low + 1)
        return std::nullopt;
    return legend(text.substr(0, named->begin), std::move(named->items));
}

// "SDR | HDR", "RF, Composite, S-Video". In "Mode  OFF | LOW | HIGH" two spaces end the label.
std::optional<SlangLegend> names_alone(std::string_view text, int low, int high) {
    const std::size_t bar = text.find('|');
    if (bar == text.npos && high - low + 1 < fewest_names)
        return std::nullopt;
    const std::size_t gap = text.substr(0, bar).find("  ");
    const bool is_labelled = bar != text.npos && gap != text.npos;
    const std::string_view label = is_labelled ? text.substr(0, gap) : std::string_view();
    if (bar == text.npos && text.find_first_of(",;") == text.npos)
        return std::nullopt;  // "Y/C/RGB" is ambiguous
    if (auto items = listed_names(text.substr(label.size()), low, high); !items.empty())
        return legend(label, std::move(items));
    return std::nullopt;
}
}  // namespace

SlangLegend parse_slang_legend(std::string_view text, int low, int high) {
    const std::string_view bare = without_decoration(text);
    if (auto found = legend_in_brackets(bare, low, high))
        return *found;
    if (auto found = legend_behind_label(bare, low, high))
        return *found;
    for (const auto read : {names_at_the_end, names_behind_dashes, names_alone})
        if (auto found = read(bare, low, high))
            return *found;
    return {std::string(bare), {}};
}
