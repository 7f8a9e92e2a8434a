#pragma once

#include "lab/document/document.h"
#include "lab/reload/look_loader.h"

#include <optional>

/// Builds programs for parameters that are constants in the texts of the open look. The picture
/// continues with its previous programs meanwhile.
class TextConstants {
public:
    explicit TextConstants(LookLoader& loader) : m_loader(loader) {}

    /// Whether the programs of the picture have other constants than the document.
    static bool are_pending(const Document& document);
    /// Requests the document's constants, each set of values once.
    void update(const Document& document);
    /// Whether there are programs for the values of a variant; requests them if not.
    bool has_programs_for(const Document& document, const Values& variant);
    struct Built {
        Look look;
        Programs programs;
    };
    /// For the variant, if its constants differ from the picture's; nullopt: not built.
    const std::optional<Built>& variant() const { return m_variant; }
    void set_variant(Built built) { m_variant = std::move(built); }
    /// Call when another look was opened or requested.
    void clear();

private:
    void request(JobKind kind, Values constants);

    LookLoader& m_loader;
    std::optional<Values> m_asked;  // for the picture; nullopt: those that it has
    std::optional<Values> m_asked_for_variant;
    std::optional<Built> m_variant;
};
