#pragma once

#include <nlohmann/json.hpp>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

// The contents of portable.json. docs/portable.md defines every member.

using Json = nlohmann::json;
using Size = std::array<int, 2>;  // width, height in pixels

struct Sampler {
    bool is_linear = true;
    bool is_mipmapped = false;
    bool blends_levels = true;
    std::string wrap = "edge";
};

struct Input {
    std::string uniform;
    std::string from;  // "pass", "source", "image", "keyboard" or "sound"
    std::string name;
    int frames_ago = 0;
    std::string holds;  // of a sound
    int columns = 0;    // of a sound
    Sampler sampler;
};

/// One side of a target.
struct Length {
    std::string of;  // "viewport", "source" or "previous"; "" for an expression
    double factor = 1.0;
    std::string expression;
};

struct BuiltIn {
    std::string uniform;
    std::string value;
    std::optional<Input> of;
};

/// A uniform that a parameter sets.
struct Binding {
    std::string uniform;
    std::string parameter;
};

/// A number, or the name of the parameter that has it.
using Count = std::variant<int, std::string>;

struct Pass {
    std::string name;
    std::string scope;   // prefix of the parameters in its expressions
    std::string source;  // the pass that its look reads as the source
    std::string draw;
    std::string blend;
    std::filesystem::path vertex;
    std::filesystem::path fragment;
    std::string format;
    Length width;
    Length height;
    std::string one_channel;
    std::string half_floats;
    bool is_linear = true;
    bool is_top_first = false;
    bool has_alpha = false;
    std::vector<Input> inputs;
    std::vector<BuiltIn> built_ins;
    std::vector<Binding> parameters;
    std::vector<std::pair<std::string, std::vector<double>>> set;
    std::string onto;   // the pass that it may draw onto
    std::string where;  // expression: while above 0
    Count repeat = 1;
    std::optional<Count> converge;
    bool accumulates = false;
    int frame_modulo = 0;
};

struct Image {
    std::string name;
    std::vector<std::filesystem::path> files;  // one, or six faces; empty: chosen by a parameter
    std::string generated;
    std::string shape = "flat";
    std::string format = "rgba32f";
    std::optional<bool> is_display;  // what the look expects; absent: as of the source
    bool is_data = false;
    bool is_top_first = false;
    bool is_needed = true;
};

struct Parameter {
    std::string name;
    std::string type;
    std::vector<double> numbers;  // empty for a file
    std::string text;             // of a file
    bool is_display = false;      // a colour that shaders expect as display values
    bool is_round_fit = false;    // the item "Keep circles round" of a list is chosen
    double low = 0.0;
    double high = 1.0;
    std::optional<std::array<double, 2>> limit;
    std::string orbit;
    Json modulation;  // null: none
};

struct SourcePicture {
    std::string content;
    std::string format = "rgba32f";
    bool is_top_first = false;
};

struct Description {
    std::filesystem::path folder;
    std::string driven_by;
    Json signal;  // null: none
    Json tempo;   // null: the default
    std::optional<SourcePicture> source;
    std::vector<Pass> passes;
    std::vector<Image> images;
    std::vector<Parameter> parameters;
    bool shows_linear = false;   // what the last pass writes
    bool reads_display = false;  // what it expects of the source and of images

    /// The index of a pass. Fails if there is none with this name.
    std::size_t pass_named(const std::string& name) const;
};

/// Reads portable.json of a folder. Fails with its name.
Description load_description(const std::filesystem::path& folder);

/// The path of a file of the look. Fails if it leads outside the folder.
std::filesystem::path file_in(const std::filesystem::path& folder, const std::string& path);

std::string read_text(const std::filesystem::path& file);
