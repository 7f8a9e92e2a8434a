#pragma once

#include "glsl/cache/check_cache.h"

#include <string>
#include <vector>

/// The adjustable constants of a look's texts. Their values are written into the texts first. The
/// later steps (checks, programs, caches) see ordinary texts.
class ConstantParameters {
public:
    /// Values by name, or by the name in `@was`; null: the values in the text. `cache` may be null.
    explicit ConstantParameters(const Values* values, CheckCache* cache = nullptr)
        : m_values(values), m_cache(cache) {}

    /// Replaces the numbers in a text, keeping line numbers. Returns the names found, for bind().
    std::vector<std::string> write_into(Stage& stage);
    /// Binds the constants to the pass of their text.
    void bind(const std::vector<std::string>& names, std::size_t pass);
    /// Processes both texts of a pass.
    void write_into(Pass& pass, std::size_t index);

    /// Adds the constants to the parameters of the look, one per name, and their values to
    /// look.constants. Errors, at their lines: annotation errors as for uniforms, conflicting
    /// values or types, a value that is not a number, a name already used by another parameter.
    Diagnostics add_to(Look& look) const;

private:
    struct Constant {
        Parameter parameter;  // guessed, without hints
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

/// Writes the values into all passes of a look and adds its constants.
Diagnostics write_constants(Look& look, const Values* values, CheckCache* cache = nullptr);
