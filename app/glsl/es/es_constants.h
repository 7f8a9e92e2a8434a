#pragma once

#include <string>
#include <vector>

/// An annotated constant of a look, and its number as a specialisation constant.
struct EsConstant {
    std::string name;
    int id = 0;

    bool operator==(const EsConstant&) const = default;
};

/// Whether the text defines the constant. False if #if or a case label evaluates it: it has to be
/// known before the shader is compiled.
bool can_be_specialized(const std::string& text, const std::string& name);

/// The text with these constants as specialisation constants, where it defines them. Their initial
/// values are those in the text. They add a line after #version.
std::string with_es_constants(const std::string& text, const std::vector<EsConstant>& constants);
