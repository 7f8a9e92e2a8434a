#pragma once

#include "glsl/text/tokens.h"

#include <map>
#include <span>
#include <string_view>
#include <vector>

/// How many tokens code becomes when its macros are expanded, found without expanding them: a few
/// lines of macros can stand for more tokens than a machine has memory. An upper estimate, with all
/// branches of #if counted.
class MacroWeights {
public:
    explicit MacroWeights(const std::vector<Directive>& directives);

    /// Tokens after expansion; infinite where macros are nested too deeply, or take
    /// too many arguments, to tell.
    double weight_of(std::span<const Token> code);
    /// Whether a token is the name of a macro.
    bool is_macro(const Token& token) const { return m_macros.contains(token.text); }
    /// Whether each macro closes the brackets that it opens, and no others.
    bool are_balanced() const { return m_are_balanced; }

private:
    // Tokens of an expansion: `base`, and for each argument how often it is repeated.
    struct Weight {
        double base = 0.0;
        std::vector<double> repeats;
    };
    struct Macro {
        bool takes_arguments = false;
        std::vector<std::string_view> parameters;
        std::span<const Token> body;
    };
    enum class State { unknown, open, known };
    struct Definitions {
        std::vector<Macro> all;
        bool takes_arguments = false;  // one of them does
        State state = State::unknown;
        Weight weight;  // the largest of all
    };
    using Parameters = std::vector<std::string_view>;

    static Macro macro_from(const Directive& define);
    const Weight& weight_of_macro(Definitions& definitions);
    Weight weigh(std::span<const Token> code, const Parameters& parameters);
    std::size_t add_call(std::span<const Token> code, const Weight& called,
                         const Parameters& parameters, Weight& sum);

    std::map<std::string_view, Definitions> m_macros;
    bool m_are_balanced = true;
    int m_depth = 0;
};
