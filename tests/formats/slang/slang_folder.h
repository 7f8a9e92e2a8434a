#pragma once

#include "formats/slang/preset.h"
#include "formats/slang/shader.h"
#include "formats/told.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

/// A temporary folder of presets and shaders.
class SlangFolder {
public:
    std::filesystem::path write(const std::string& name, const std::string& text) const {
        return m_folder.write(name, text);
    }
    std::filesystem::path operator/(const std::string& name) const { return m_folder / name; }

    Result<SlangPreset> preset(const std::string& name) {
        m_files = {};
        return read_slang_preset(m_folder / name, m_files);
    }
    /// Writes `a.slangp` and loads it.
    Result<SlangPreset> preset_of(const std::string& text) {
        write("a.slangp", text);
        return preset("a.slangp");
    }
    Result<SlangShader> shader(const std::string& name) {
        m_files = {};
        return read_slang_shader(m_folder / name, m_files);
    }
    /// Writes `a.slang` and loads it.
    Result<SlangShader> shader_of(const std::string& text) {
        write("a.slang", text);
        return shader("a.slang");
    }

    bool has_seen(const std::string& name) const {
        return std::ranges::find(m_files.seen(), m_folder / name) != m_files.seen().end();
    }
    /// "a.slangp:2: error: ...", one per line, with paths relative to this folder.
    std::string told(const Diagnostics& diagnostics) const {
        return told_in(m_folder.path(), diagnostics);
    }
    template <class T>
    std::string refusal(const Result<T>& result) const {
        REQUIRE_FALSE(result.has_value());
        return told(result.error());
    }

private:
    TemporaryFolder m_folder;
    SlangFiles m_files;
};
