#include "base/fuzzy.h"

#include "base/text.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <string>

namespace {
constexpr int letter = 1;
constexpr int word_start = 8;
constexpr int follows = 8;  // directly after the previous letter
constexpr int gap = -2;     // characters are skipped before it
constexpr int skips = -1;   // after a gap, inside a word
constexpr int none = std::numeric_limits<int>::min() / 2;

bool is_letter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || static_cast<unsigned char>(c) >= 0x80;
}

bool begins_word(std::string_view text, std::size_t at) {
    return is_letter(text[at]) && (at == 0 || !is_letter(text[at - 1]));
}

// Best score of each prefix of the word that ends at each byte of the text.
struct Table {
    std::vector<int> scores;          // word × text
    std::vector<std::size_t> before;  // position of the previous letter
};

void fit_letter(std::string_view word, std::string_view text, std::size_t i, Table& table) {
    const std::size_t width = text.size();
    int best = none;  // best score of the previous letter at j - 2 or earlier
    std::size_t best_at = 0;
    for (std::size_t j = 0; j < width; ++j) {
        int& score = table.scores[i * width + j];
        const bool starts = begins_word(text, j);
        const bool fits = word[i] == text[j];
        if (i == 0) {
            score = fits && starts ? letter + word_start : none;
            continue;
        }
        const int next = j > 0 ? table.scores[(i - 1) * width + j - 1] : none;
        const int jump = best + letter + gap + (starts ? word_start : skips);
        const int step = next + letter + follows;
        score = fits ? std::max(std::max(jump, step), none) : none;
        table.before[i * width + j] = jump > step ? best_at : j - 1;
        if (next > best) {
            best = next;
            best_at = j - 1;
        }
    }
}

// All letters in order; the first one starts a word.
std::optional<FuzzyMatch> fit_letters(std::string_view word, std::string_view text) {
    if (text.empty() || word.size() > text.size())
        return std::nullopt;
    Table table{std::vector<int>(word.size() * text.size(), none),
                std::vector<std::size_t>(word.size() * text.size())};
    for (std::size_t i = 0; i < word.size(); ++i)
        fit_letter(word, text, i, table);
    const auto last = table.scores.end() - static_cast<std::ptrdiff_t>(text.size());
    const auto best = std::max_element(last, table.scores.end());
    if (*best < none / 2)
        return std::nullopt;
    FuzzyMatch match{*best, {}};
    auto at = static_cast<std::size_t>(best - last);
    for (std::size_t i = word.size(); i-- > 0; at = table.before[i * text.size() + at])
        match.positions.insert(match.positions.begin(), at);
    return match;
}

std::optional<FuzzyMatch> fit_piece(std::string_view word, std::string_view text) {
    const std::size_t at = text.find(word);
    if (word.size() < 2 || at == std::string_view::npos)
        return std::nullopt;
    const int length = static_cast<int>(word.size());
    FuzzyMatch match{length * letter + (length - 1) * follows, {}};
    for (std::size_t i = 0; i < word.size(); ++i)
        match.positions.push_back(at + i);
    return match;
}
}  // namespace

std::optional<FuzzyMatch> fuzzy_match(std::string_view query, std::string_view text) {
    std::string words = to_lower(query);
    std::replace(words.begin(), words.end(), '_', ' ');
    const std::string lower = to_lower(text);
    FuzzyMatch all;
    for (const std::string_view word : split(words, ' ')) {
        if (word.empty())
            continue;
        const auto letters = fit_letters(word, lower);
        const auto piece = fit_piece(word, lower);
        if (!letters && !piece)
            return std::nullopt;
        const FuzzyMatch& better =
            !piece || (letters && letters->score >= piece->score) ? *letters : *piece;
        all.score += better.score;
        all.positions.insert(all.positions.end(), better.positions.begin(), better.positions.end());
    }
    std::sort(all.positions.begin(), all.positions.end());
    all.positions.erase(std::unique(all.positions.begin(), all.positions.end()),
                        all.positions.end());
    return all;
}
