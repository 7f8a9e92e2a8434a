#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// One name of a declaration.
struct Declarator {
    std::string name;
    std::string size;         // of an array, in brackets: "[4]"
    std::string initialiser;  // "" without one
};

/// A uniform, input or output that a text declares at global scope, whether or not the preprocessor
/// removes it.
struct InterfaceStatement {
    enum class Kind { uniform, input, output };

    Kind kind = Kind::uniform;
    std::size_t begin = 0;       // of its first word, such as `layout`: offsets into the text
    std::size_t type_begin = 0;  // of the type, after all qualifiers
    std::size_t end = 0;         // after the ';'
    std::string type;            // "vec2"; for a block, its name
    std::vector<Declarator> declarators;
    bool is_flat = false;
    bool is_block = false;  // has no declarators
    int location = -1;      // of its layout; -1: none
};

/// The statements in order, found by scanning tokens.
std::vector<InterfaceStatement> find_interface_statements(std::string_view text);

/// The names that a text declares at global scope: functions, variables, structs and macros.
std::vector<std::string> global_names(std::string_view text);
