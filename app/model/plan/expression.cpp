#include "model/plan/expression.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

namespace {
double finite(double number) {
    return std::isfinite(number) ? number : 0.0;
}

// A recursive-descent parser. After an error m_problem is set and the result is ignored.
class Reader {
public:
    Reader(std::string_view text, const std::map<std::string, double>& names)
        : m_text(text), m_names(names) {}

    Result<double> read() {
        const double value = choice();
        skip_blank();
        if (m_problem.empty() && m_at < m_text.size())
            m_problem = fmt::format("unexpected '{}'", m_text.substr(m_at));
        if (m_problem.empty() && !std::isfinite(value))
            m_problem = fmt::format("'{}' is not a finite number", m_text);
        if (!m_problem.empty())
            return fail({{}, 0, m_problem});
        return value;
    }

private:
    static constexpr int deepest = 64;

    double choice() {
        const double condition = disjunction();
        if (!accept('?'))
            return condition;
        if (m_depth + 1 >= deepest)
            return stop("the '? :' conditions are nested too deeply");
        ++m_depth;
        const double yes = choice();
        expect(':');
        const double no = choice();
        --m_depth;
        return condition != 0.0 ? yes : no;
    }

    double disjunction() {
        double value = conjunction();
        while (accept("||")) {
            const bool is_true = conjunction() != 0.0;
            value = is_true || value != 0.0 ? 1.0 : 0.0;
        }
        return value;
    }

    double conjunction() {
        double value = comparison();
        while (accept("&&")) {
            const bool is_true = comparison() != 0.0;
            value = is_true && value != 0.0 ? 1.0 : 0.0;
        }
        return value;
    }

    double comparison() {
        const double a = sum();
        if (accept("<="))
            return a <= sum() ? 1.0 : 0.0;
        if (accept(">="))
            return a >= sum() ? 1.0 : 0.0;
        if (accept("=="))
            return a == sum() ? 1.0 : 0.0;
        if (accept("!="))
            return a != sum() ? 1.0 : 0.0;
        if (accept('<'))
            return a < sum() ? 1.0 : 0.0;
        if (accept('>'))
            return a > sum() ? 1.0 : 0.0;
        return a;
    }

    double sum() {
        double value = product();
        for (;;) {
            if (accept('+'))
                value += product();
            else if (accept('-'))
                value -= product();
            else
                return value;
        }
    }

    double product() {
        double value = factor();
        for (;;) {
            if (accept('*'))
                value *= factor();
            else if (accept('/'))
                value /= factor();
            else if (accept('%'))
                value = std::fmod(value, factor());
            else
                return value;
        }
    }

    double factor() {
        if (m_depth >= deepest)
            return stop("the expression is nested too deeply");
        ++m_depth;
        const double value = accept('-')   ? -factor()
                             : accept('!') ? (factor() == 0.0 ? 1.0 : 0.0)
                                           : atom();
        --m_depth;
        return value;
    }

    double atom() {
        if (accept('(')) {
            const double value = choice();
            expect(')');
            return value;
        }
        if (accept('$'))
            return named();
        const std::string name = word();
        return name.empty() ? number() : call(name);
    }

    double named() {
        std::string name = word();
        if (m_at < m_text.size() && m_text[m_at] == '.') {  // a component
            ++m_at;
            name += '.' + word();
        }
        const auto found = m_names.find(name);
        return found == m_names.end() ? stop(fmt::format("unknown name '${}'", name))
                                      : found->second;
    }

    double number() {
        const std::size_t start = m_at;
        while (m_at < m_text.size() && (std::isdigit(letter()) || letter() == '.'))
            ++m_at;
        const auto value = parse_number(m_text.substr(start, m_at - start));
        return value ? *value : stop("expected a number, a name or '('");
    }

    double call(const std::string& name) {
        expect('(');
        const double a = choice();
        if (name == "max" || name == "min" || name == "pow") {
            expect(',');
            const double b = choice();
            expect(')');
            return name == "max" ? std::max(a, b) : name == "min" ? std::min(a, b) : std::pow(a, b);
        }
        expect(')');
        static const std::map<std::string, double (*)(double)> functions{
            {"abs", std::fabs}, {"ceil", std::ceil}, {"finite", finite},    {"floor", std::floor},
            {"log", std::log},  {"log2", std::log2}, {"round", std::round}, {"sqrt", std::sqrt}};
        const auto function = functions.find(name);
        return function == functions.end() ? stop(fmt::format("unknown function '{}'", name))
                                           : function->second(a);
    }

    std::string word() {
        skip_blank();
        const std::size_t start = m_at;
        while (m_at < m_text.size() && (std::isalpha(letter()) || letter() == '_' ||
                                        (m_at > start && std::isdigit(letter()))))
            ++m_at;
        return std::string(m_text.substr(start, m_at - start));
    }

    bool accept(std::string_view wanted) {
        skip_blank();
        if (!m_text.substr(m_at).starts_with(wanted))
            return false;
        m_at += wanted.size();
        return true;
    }

    bool accept(char wanted) { return accept(std::string_view(&wanted, 1)); }

    void expect(char wanted) {
        if (!accept(wanted))
            stop(fmt::format("missing '{}'", wanted));
    }

    double stop(std::string problem) {
        if (m_problem.empty())
            m_problem = std::move(problem);
        m_at = m_text.size();
        return 0.0;
    }

    void skip_blank() {
        while (m_at < m_text.size() && std::isspace(letter()))
            ++m_at;
    }

    unsigned char letter() const { return static_cast<unsigned char>(m_text[m_at]); }

    std::string_view m_text;
    const std::map<std::string, double>& m_names;
    std::size_t m_at = 0;
    int m_depth = 0;
    std::string m_problem;
};
}  // namespace

Result<double> evaluate(std::string_view expression, const std::map<std::string, double>& names) {
    return Reader(expression, names).read();
}
