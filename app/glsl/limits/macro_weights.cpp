#include "glsl/limits/macro_weights.h"

#include <algorithm>
#include <limits>

namespace {
constexpr int max_depth = 256;
constexpr std::size_t max_macro_parameters = 256;
constexpr double infinite = std::numeric_limits<double>::infinity();

bool is_open(const Token& token) {
    return token.is("(") || token.is("[") || token.is("{");
}

bool is_close(const Token& token) {
    return token.is(")") || token.is("]") || token.is("}");
}

bool is_balanced(std::span<const Token> code) {
    int depth = 0;
    for (const Token& token : code) {
        depth += is_open(token) ? 1 : is_close(token) ? -1 : 0;
        if (depth < 0)
            return false;
    }
    return depth == 0;
}

// Avoids NaN from 0 x infinity.
double product(double a, double b) {
    return a == 0.0 || b == 0.0 ? 0.0 : a * b;
}
}  // namespace

MacroWeights::MacroWeights(const std::vector<Directive>& directives) {
    for (const Directive& directive : directives) {
        if (directive.name != "define" || directive.arguments.empty())
            continue;
        Definitions& same = m_macros[directive.arguments.front().text];
        same.all.push_back(macro_from(directive));
        m_are_balanced = m_are_balanced && is_balanced(same.all.back().body);
        same.takes_arguments = same.takes_arguments || same.all.back().takes_arguments;
    }
}

MacroWeights::Macro MacroWeights::macro_from(const Directive& define) {
    const std::span<const Token> tokens(define.arguments);
    const Token& name = tokens[0];
    Macro macro;
    macro.body = tokens.subspan(1);
    // Only a bracket directly after the name starts a parameter list.
    const char* const behind = name.text.data() + name.text.size();
    if (tokens.size() < 2 || !tokens[1].is("(") || tokens[1].text.data() != behind)
        return macro;
    macro.takes_arguments = true;
    std::size_t at = 2;
    for (; at < tokens.size() && !tokens[at].is(")"); ++at)
        if (tokens[at].kind == Token::Kind::word)
            macro.parameters.push_back(tokens[at].text);
    macro.body = tokens.subspan(std::min(at + 1, tokens.size()));
    return macro;
}

double MacroWeights::weight_of(std::span<const Token> code) {
    return weigh(code, {}).base;
}

const MacroWeights::Weight& MacroWeights::weight_of_macro(Definitions& definitions) {
    if (definitions.state == State::known)
        return definitions.weight;
    static const Weight itself{1.0, {}};
    if (definitions.state == State::open)
        return itself;  // a macro is not expanded within its own expansion
    definitions.state = State::open;
    Weight largest{1.0, {}};
    for (const Macro& macro : definitions.all) {
        const bool is_known =
            m_depth < max_depth && macro.parameters.size() <= max_macro_parameters;
        Weight weight = is_known ? weigh(macro.body, macro.parameters) : Weight{infinite, {}};
        largest.base = std::max(largest.base, weight.base);
        largest.repeats.resize(std::max(largest.repeats.size(), weight.repeats.size()));
        for (std::size_t i = 0; i < weight.repeats.size(); ++i)
            largest.repeats[i] = std::max(largest.repeats[i], weight.repeats[i]);
    }
    definitions.weight = std::move(largest);
    definitions.state = State::known;
    return definitions.weight;
}

MacroWeights::Weight MacroWeights::weigh(std::span<const Token> code,
                                         const Parameters& parameters) {
    // A macro passed by name to another macro may be called there; this is an estimate of its size.
    const Weight handed_over{16.0, {4.0, 4.0, 4.0, 4.0}};
    Weight sum{0.0, std::vector<double>(parameters.size())};
    ++m_depth;
    for (std::size_t i = 0; i < code.size(); ++i) {
        const bool is_call = i + 1 < code.size() && code[i + 1].is("(");
        const auto parameter = std::ranges::find(parameters, code[i].text);
        const auto macro = m_macros.find(code[i].text);
        if (parameter != parameters.end())
            sum.repeats[static_cast<std::size_t>(parameter - parameters.begin())] += 1.0;
        if (parameter != parameters.end() && is_call) {
            i += add_call(code.subspan(i + 1), handed_over, parameters, sum);
        } else if (parameter == parameters.end() && macro != m_macros.end()) {
            const Weight& weight = weight_of_macro(macro->second);
            if (is_call && macro->second.takes_arguments)
                i += add_call(code.subspan(i + 1), weight, parameters, sum);
            else
                sum.base += weight.base;
        } else if (parameter == parameters.end()) {
            sum.base += 1.0;
        }
    }
    --m_depth;
    return sum;
}

// `code` starts at the opening bracket. Returns the number of tokens in the call from there.
std::size_t MacroWeights::add_call(std::span<const Token> code, const Weight& called,
                                   const Parameters& parameters, Weight& sum) {
    sum.base += called.base;
    std::size_t argument = 0;
    std::size_t begin = 1;
    int depth = 0;
    for (std::size_t i = 0; i < code.size(); ++i) {
        depth += is_open(code[i]) ? 1 : is_close(code[i]) ? -1 : 0;
        const bool is_last = depth == 0 || i + 1 == code.size();
        if (!is_last && !(depth == 1 && code[i].is(",")))
            continue;
        const std::size_t end = std::max(begin, depth == 0 || code[i].is(",") ? i : i + 1);
        const Weight weight = weigh(code.subspan(begin, end - begin), parameters);
        const double repeats = argument < called.repeats.size() ? called.repeats[argument] : 1.0;
        sum.base += product(repeats, weight.base);
        for (std::size_t p = 0; p < parameters.size(); ++p)
            sum.repeats[p] += product(repeats, weight.repeats[p]);
        ++argument;
        begin = i + 1;
        if (is_last)
            return i + 1;
    }
    return 0;
}
