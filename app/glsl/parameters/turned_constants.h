#pragma once

#include "glsl/cache/check_cache.h"

#include <string>
#include <vector>

/// The constants of a look's texts that a person may turn. Its texts get the numbers that they are
/// turned to before anything else reads them; all that follows (checks, programs, what is kept of
/// them) knows of no constants.
class TurnedConstants {
public:
    /// By name, or by the name that `@was` says; null: all is as written. `cache` may be null.
    explicit TurnedConstants(const Values* values, CheckCache* cache = nullptr)
        : m_values(values), m_cache(cache) {}

    /// Writes the numbers into a text, each in the place of the author's, on its line. What is
    /// found, for bind().
    std::vector<std::string> write_into(Stage& stage);
    /// The text is one of the pass.
    void bind(const std::vector<std::string>& names, std::size_t pass);
    /// Both texts of a pass.
    void write_into(Pass& pass, std::size_t index);

    /// Adds them to the parameters of the look, one a name, and what the texts have to its
    /// constants. Errors: mistakes in annotations as those of uniforms; numbers or types that
    /// disagree, and what is no number, at their lines; a name that another parameter has.
    Diagnostics add_to(Look& look) const;

private:
    struct Constant {
        Parameter parameter;  // as guessed
        Hints hints;
        Value value;  // in the texts
    };

    Constant* note(const WrittenConstant& written, const Stage& stage);
    Value value_for(const Parameter& guessed, const Hints& hints) const;
    void error(const Location& at, std::string message);

    const Values* m_values;
    CheckCache* m_cache;
    std::vector<Constant> m_constants;
    Diagnostics m_errors;
};

/// Writes into all passes of a look, and adds its constants.
Diagnostics turn_constants(Look& look, const Values* values, CheckCache* cache = nullptr);
