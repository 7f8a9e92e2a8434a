#include "portable_player/expression.h"

#include "portable_player/error.h"

#include <cctype>
#include <cmath>
#include <map>
#include <string_view>
#include <vector>

namespace {
using ValueOf = std::function<double(const std::string&)>;

/// A binary operator and how strongly it binds.
struct Operator {
    std::string_view sign;
    int strength;
    double (*apply)(double, double);
};

// Longer signs come before their beginnings.
const std::vector<Operator> operators{
    {"||", 1, [](double a, double b) { return a != 0.0 || b != 0.0 ? 1.0 : 0.0; }},
    {"&&", 2, [](double a, double b) { return a != 0.0 && b != 0.0 ? 1.0 : 0.0; }},
    {"<=", 3, [](double a, double b) { return a <= b ? 1.0 : 0.0; }},
    {">=", 3, [](double a, double b) { return a >= b ? 1.0 : 0.0; }},
    {"==", 3, [](double a, double b) { return a == b ? 1.0 : 0.0; }},
    {"!=", 3, [](double a, double b) { return a != b ? 1.0 : 0.0; }},
    {"<", 3, [](double a, double b) { return a < b ? 1.0 : 0.0; }},
    {">", 3, [](double a, double b) { return a > b ? 1.0 : 0.0; }},
    {"+", 4, [](double a, double b) { return a + b; }},
    {"-", 4, [](double a, double b) { return a - b; }},
    {"*", 5, [](double a, double b) { return a * b; }},
    {"/", 5, [](double a, double b) { return a / b; }},
    {"%", 5, [](double a, double b) { return std::fmod(a, b); }}};

const std::map<std::string, double (*)(double)> functions{
    {"abs", std::fabs},
    {"ceil", std::ceil},
    {"floor", std::floor},
    {"log2", std::log2},
    {"round", std::round},
    {"sqrt", std::sqrt},
    {"finite", [](double a) { return std::isfinite(a) ? a : 0.0; }}};

const std::map<std::string, double (*)(double, double)> pair_functions{
    {"max", std::fmax}, {"min", std::fmin}, {"pow", std::pow}};

class Parser {
public:
    Parser(const std::string& text, const ValueOf& value_of) : m_text(text), m_value_of(value_of) {}

    double whole() {
        const double value = choice();
        if (next() != '\0')
            stop();
        return value;
    }

private:
    double choice() {
        const double condition = chain(1);
        if (!takes("?"))
            return condition;
        const double yes = choice();
        expect(":");
        const double no = choice();
        return condition != 0.0 ? yes : no;
    }

    // Operators of at least this strength, from left to right.
    double chain(int strength) {
        double value = factor();
        for (;;) {
            const Operator* found = nullptr;
            for (const Operator& one : operators)
                if (!found && one.strength >= strength && takes(one.sign))
                    found = &one;
            if (!found)
                return value;
            value = found->apply(value, chain(found->strength + 1));
        }
    }

    double factor() {
        if (takes("-"))
            return -factor();
        if (takes("!"))
            return factor() == 0.0 ? 1.0 : 0.0;
        if (takes("(")) {
            const double value = choice();
            expect(")");
            return value;
        }
        if (takes("$"))
            return m_value_of(word("_."));
        if (std::isalpha(static_cast<unsigned char>(next())) != 0)
            return call(word("_"));
        return number();
    }

    double call(const std::string& name) {
        expect("(");
        const double a = choice();
        if (const auto found = functions.find(name); found != functions.end()) {
            expect(")");
            return found->second(a);
        }
        const auto found = pair_functions.find(name);
        if (found == pair_functions.end())
            stop();
        expect(",");
        const double b = choice();
        expect(")");
        return found->second(a, b);
    }

    double number() {
        const std::string digits = next() == '\0' ? std::string() : word(".");
        std::size_t used = 0;
        try {
            const double value = std::stod(digits, &used);
            if (used == digits.size())
                return value;
        } catch (const std::logic_error&) {  // not a number
        }
        stop();
    }

    // Letters, digits and these characters.
    std::string word(std::string_view more) {
        const std::size_t start = m_at;
        while (m_at < m_text.size() &&
               (std::isalnum(static_cast<unsigned char>(m_text[m_at])) != 0 ||
                more.find(m_text[m_at]) != std::string_view::npos))
            ++m_at;
        return m_text.substr(start, m_at - start);
    }

    char next() {
        while (m_at < m_text.size() && std::isspace(static_cast<unsigned char>(m_text[m_at])) != 0)
            ++m_at;
        return m_at < m_text.size() ? m_text[m_at] : '\0';
    }

    bool takes(std::string_view sign) {
        next();
        const bool is_next = std::string_view(m_text).substr(m_at).starts_with(sign);
        m_at += is_next ? sign.size() : 0;
        return is_next;
    }

    void expect(std::string_view sign) {
        if (!takes(sign))
            stop();
    }

    [[noreturn]] void stop() const { throw Error("can't evaluate '" + m_text + "'"); }

    const std::string& m_text;
    const ValueOf& m_value_of;
    std::size_t m_at = 0;
};
}  // namespace

double evaluate(const std::string& expression, const ValueOf& value_of) {
    return Parser(expression, value_of).whole();
}
