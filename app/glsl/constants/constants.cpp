#include "glsl/constants/constants.h"

#include "base/text.h"
#include "glsl/text/trailing_comments.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <span>
#include <utility>

namespace {
using WrittenTokens = std::vector<Token>;

/// A number literal.
struct Literal {
    NumberType type;
    double number = 0.0;
    const char* begin = nullptr;
    const char* end = nullptr;
};

NumberType scalar(Scalar kind) {
    return {kind, 1, 1};
}

std::optional<double> whole_number(std::string_view digits) {
    const bool is_hex = digits.starts_with("0x") || digits.starts_with("0X");
    const bool is_octal = !is_hex && digits.size() > 1 && digits.front() == '0';
    if (is_hex)
        digits.remove_prefix(2);
    std::uint32_t number = 0;
    const char* const end = digits.data() + digits.size();
    const auto [stop, error] =
        std::from_chars(digits.data(), end, number, is_hex ? 16 : (is_octal ? 8 : 10));
    if (error != std::errc() || stop != end)
        return std::nullopt;
    return number;
}

constexpr double largest_int = 2147483647.0;

std::optional<Literal> literal_of(const Token& token) {
    Literal literal{{}, 0.0, token.text.data(), token.text.data() + token.text.size()};
    if (token.is("true") || token.is("false")) {
        literal.type = scalar(Scalar::boolean);
        literal.number = token.is("true") ? 1.0 : 0.0;
        return literal;
    }
    if (token.kind != Token::Kind::number)
        return std::nullopt;
    std::string_view digits = token.text;
    const bool is_hex = digits.starts_with("0x") || digits.starts_with("0X");
    std::optional<double> number;
    if (!is_hex && digits.find_first_of(".eEfF") != std::string_view::npos) {
        while (!digits.empty() && std::string_view("lLfF").find(digits.back()) != std::string::npos)
            digits.remove_suffix(1);
        literal.type = scalar(Scalar::floating);
        number = parse_number(digits);
    } else {
        const bool is_natural = digits.ends_with('u') || digits.ends_with('U');
        if (is_natural)
            digits.remove_suffix(1);
        literal.type = scalar(is_natural ? Scalar::unsigned_integer : Scalar::integer);
        number = whole_number(digits);
    }
    if (!number || (literal.type.scalar == Scalar::integer && *number > largest_int))
        return std::nullopt;
    literal.number = *number;
    return literal;
}

// With or without brackets and sign.
std::optional<Literal> literal_in(std::span<const Token> tokens) {
    while (tokens.size() > 2 && tokens.front().is("(") && tokens.back().is(")"))
        tokens = tokens.subspan(1, tokens.size() - 2);
    if (tokens.empty() || tokens.size() > 2)
        return std::nullopt;
    auto literal = literal_of(tokens.back());
    if (!literal || tokens.size() == 1)
        return literal;
    const bool is_signed = tokens.front().is("-") || tokens.front().is("+");
    if (!is_signed || literal->type.scalar == Scalar::boolean)
        return std::nullopt;
    if (tokens.front().is("-"))
        literal->number = -literal->number;
    literal->begin = tokens.front().text.data();
    return literal;
}

struct TypeWord {
    std::string_view word;
    Scalar scalar;
};
constexpr std::array type_words{
    TypeWord{"float", Scalar::floating}, TypeWord{"int", Scalar::integer},
    TypeWord{"uint", Scalar::unsigned_integer}, TypeWord{"bool", Scalar::boolean}};

bool is_precision(const Token& token) {
    return token.is("lowp") || token.is("mediump") || token.is("highp");
}

int change_of_brackets(const Token& token) {
    if (token.is("(") || token.is("[") || token.is("{"))
        return 1;
    return token.is(")") || token.is("]") || token.is("}") ? -1 : 0;
}

class ConstantFinder {
public:
    explicit ConstantFinder(std::string_view text) : m_text(text), m_tokens(scan(text).all) {}

    std::vector<WrittenConstant> find() {
        while (const Token* token = peek()) {
            if (token->starts_directive)
                read_directive();
            else if (!token->in_directive && token->is("const"))
                read_const();
            else
                next();
        }
        for (std::size_t i = 0; i < m_found.size(); ++i)
            m_found[i].comments = m_comments.of(i);
        std::erase_if(m_found, [](const WrittenConstant& found) { return !asks(found); });
        return std::move(m_found);
    }

private:
    static bool asks(const WrittenConstant& found) {
        return std::ranges::any_of(found.comments, [&](const Comment& comment) {
            const auto has = [&](const char* key) {
                return comment.text.find(key) != std::string::npos;
            };
            return has("@range") || has("@items") ||
                   (found.type.scalar == Scalar::boolean && has("@label"));
        });
    }

    // The next code token. Comments before it are added to the current or previous declaration.
    const Token* peek() {
        for (; m_at < m_tokens.size(); ++m_at) {
            const Token& token = m_tokens[m_at];
            if (token.kind != Token::Kind::comment)
                return &token;
            if (m_is_inside)
                m_inside.push_back(comment_from(token));
            else
                m_comments.add(token, m_at > 0 ? &m_tokens[m_at - 1] : nullptr);
        }
        return nullptr;
    }

    const Token* next() {
        const Token* const token = peek();
        m_at += token ? 1 : 0;
        return token;
    }

    // Reads `#define NAME NUMBER`; ignores macros with arguments.
    void read_directive() {
        WrittenTokens words;
        for (++m_at; m_at < m_tokens.size(); ++m_at) {
            const Token& token = m_tokens[m_at];
            if (!token.in_directive || token.starts_directive)
                break;
            if (token.kind == Token::Kind::comment)
                m_inside.push_back(comment_from(token));
            else
                words.push_back(token);
        }
        const bool is_definition = words.size() > 2 && words[0].is("define");
        const bool has_arguments =
            is_definition && words[2].is("(") &&
            words[2].text.data() == words[1].text.data() + words[1].text.size();
        if (is_definition && !has_arguments)
            add(words[1], words.back().line, std::span(words).subspan(2), nullptr);
        m_inside.clear();
    }

    // Reads `const TYPE NAME = NUMBER, NAME = NUMBER;`
    void read_const() {
        next();
        while (peek() && is_precision(*peek()))
            next();
        const Token* const type = next();
        if (!type || type->kind != Token::Kind::word)
            return;
        const auto* const known = std::ranges::find(type_words, type->text, &TypeWord::word);
        while (read_declarator(known == type_words.end() ? nullptr : known)) {
        }
    }

    // Reads up to after the ','. False at the end of the statement or for other code.
    bool read_declarator(const TypeWord* type) {
        const Token* const name = next();
        const Token* const equals = name && name->kind == Token::Kind::word ? peek() : nullptr;
        if (!equals || !(equals->is("=") || equals->is("[")))
            return false;
        next();
        WrittenTokens body;
        m_is_inside = true;
        int depth = equals->is("[") ? 1 : 0;
        const Token* token = next();
        for (; token && !token->starts_directive; token = next()) {
            if (depth == 0 && (token->is(",") || token->is(";")))
                break;
            depth += change_of_brackets(*token);
            if (depth < 0)
                break;
            body.push_back(*token);
        }
        m_is_inside = false;
        const bool is_whole = token && (token->is(",") || token->is(";"));
        if (is_whole && equals->is("=") && type)
            add(*name, token->line, body, type);
        else if (is_whole)
            add(*name, token->line, {}, nullptr);
        return is_whole && token->is(",");
    }

    void add(const Token& name, int last_line, std::span<const Token> body, const TypeWord* type) {
        WrittenConstant found;
        found.name = name.text;
        found.line = name.line;
        const auto literal = literal_in(body);
        if (type)
            found.type = scalar(type->scalar);
        else if (literal)
            found.type = literal->type;
        if (literal) {
            found.number = literal->number;
            found.begin = static_cast<std::size_t>(literal->begin - m_text.data());
            found.end = static_cast<std::size_t>(literal->end - m_text.data());
        }
        m_comments.open(last_line, std::exchange(m_inside, {}));
        m_found.push_back(std::move(found));
    }

    std::string_view m_text;
    std::vector<Token> m_tokens;
    std::vector<WrittenConstant> m_found;
    std::size_t m_at = 0;
    TrailingComments m_comments;
    bool m_is_inside = false;       // inside a declaration
    std::vector<Comment> m_inside;  // comments of that declaration
};
}  // namespace

std::vector<WrittenConstant> find_constants(std::string_view text) {
    if (text.find('@') == std::string_view::npos)
        return {};
    return ConstantFinder(text).find();
}

std::string glsl_number(const NumberType& type, double number) {
    std::string text;
    switch (type.scalar) {
        case Scalar::boolean:
            return number != 0.0 ? "true" : "false";
        case Scalar::unsigned_integer:
            return fmt::format("{}u", static_cast<std::uint32_t>(number));
        case Scalar::integer:
            text = fmt::format("{}", static_cast<std::int64_t>(number));
            break;
        case Scalar::floating:
            text = format_number(number);
            if (text.find_first_of(".e") == std::string::npos)
                text += ".0";
            break;
    }
    return number < 0.0 ? '(' + text + ')' : text;
}
