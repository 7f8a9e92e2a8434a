#pragma once

#include "formats/isf/isf_format.h"
#include "formats/look_format.h"
#include "formats/told.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <string>

/// A temporary folder of ISF shaders.
class IsfFolder {
public:
    std::filesystem::path write(const std::string& name, const std::string& text) const {
        return m_folder.write(name, text);
    }
    std::filesystem::path operator/(const std::string& name) const { return m_folder / name; }

    /// Loads a.fs.
    LoadedLook load() const { return load_look(m_folder / "a.fs", {}); }
    /// Writes a.fs with these header members and this GLSL code, and loads it.
    LoadedLook load(const std::string& members, const std::string& code) const {
        write("a.fs", "/*{" + members + "}*/\n" + code);
        return load();
    }
    Look look(const std::string& members, const std::string& code) const {
        LoadedLook loaded = load(members, code);
        REQUIRE_MESSAGE(loaded.look.has_value(), told(loaded.look.error()));
        CHECK(told(loaded.warnings) == "");
        return std::move(*loaded.look);
    }

    /// "a.fs:2: error: ...", one per line.
    std::string told(const Diagnostics& diagnostics) const {
        return told_in(m_folder.path(), diagnostics);
    }
    std::string refusal(const std::string& members, const std::string& code) const {
        const LoadedLook loaded = load(members, code);
        REQUIRE_FALSE(loaded.look.has_value());
        return told(loaded.look.error());
    }

private:
    TemporaryFolder m_folder;
};

inline const std::string draws_red = "void main() { gl_FragColor = vec4(1, 0, 0, 1); }\n";
