#pragma once

#include "glsl/text/tokens.h"

#include <map>
#include <span>
#include <string_view>
#include <vector>

/// Computes the number of tokens after macro expansion, without expanding: a few lines of macros
/// can expand to more tokens than fit into memory. An upper bound that counts all branches of #if.
class MacroWeights {
public:
    explicit MacroWeights(const std::vector<Directive>& directives);

    /// Number of tokens after expansion. Infinite when macros are nested too deeply or have too
    /// many parameters for an estimate.
    double weight_of(std::span<const Token> code);
    /// Whether a token is the name of a macro.
    bool is_macro(const Token& token) const { return m_macros.contains(token.text); }
    /// Whether the brackets in each macro are balanced.
    bool are_balanced() const { return m_are_balanced; }

private:
    // Tokens of an expansion: `base`, and the number of repetitions of each argument.
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
        bool takes_arguments = false;  // at least one takes arguments
        State state = State::unknown;
        Weight weight;  // the maximum over all definitions
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
