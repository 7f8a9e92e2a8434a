// Draws a portable look (docs/portable.md) without any code of Afterglow:
// portable_player FOLDER --frames N --size WxH -o PICTURE.png
// A picture such as f_%04d.png is a sequence of all frames, from 0000.
#include "portable_player/error.h"
#include "portable_player/frames.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <span>
#include <string_view>

namespace {
constexpr int usage_error = 2;
constexpr std::string_view mark_of_sequence = "%04d";

struct Arguments {
    std::string folder;
    std::string output;
    int frames = 0;
    Size size{};
};

// The number that is all of a text; 0 otherwise.
int number_in(const std::string& text) {
    const bool is_number =
        !text.empty() && text.size() < 8 && text.find_first_not_of("0123456789") == text.npos;
    return is_number ? std::stoi(text) : 0;
}

Size size_in(const std::string& text) {
    const std::size_t cross = std::min(text.find('x'), text.size());
    return {number_in(text.substr(0, cross)),
            number_in(text.substr(std::min(cross + 1, text.size())))};
}

std::optional<Arguments> parse(std::span<char* const> words) {
    Arguments arguments;
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::string word = words[i];
        const std::string next = i + 1 < words.size() ? words[i + 1] : "";
        if (!word.starts_with('-') && arguments.folder.empty()) {
            arguments.folder = word;
            continue;
        }
        if (word == "--frames")
            arguments.frames = number_in(next);
        else if (word == "--size")
            arguments.size = size_in(next);
        else if (word == "-o")
            arguments.output = next;
        else
            return std::nullopt;
        ++i;
    }
    const bool is_complete = !arguments.folder.empty() && !arguments.output.empty() &&
                             arguments.frames > 0 && arguments.size[0] > 0 && arguments.size[1] > 0;
    return is_complete ? std::optional(arguments) : std::nullopt;
}

// The name of one picture of a sequence.
std::string numbered(std::string name, int number) {
    const std::string digits = std::to_string(number);
    return name.replace(name.find(mark_of_sequence), mark_of_sequence.size(),
                        std::string(4 - std::min<std::size_t>(4, digits.size()), '0') + digits);
}

void play(const Arguments& arguments) {
    const Description description = load_description(arguments.folder);
    open_context();
    FramePlayer player(description, arguments.size);
    const bool is_sequence = arguments.output.find(mark_of_sequence) != std::string::npos;
    for (int i = 0; i < arguments.frames; ++i) {
        player.draw_next();
        if (is_sequence || i + 1 == arguments.frames)
            save_png(is_sequence ? numbered(arguments.output, i) : arguments.output,
                     player.picture_size()[0], player.picture_size()[1], player.picture());
    }
}
}  // namespace

int main(int count, char** words) {
    const auto arguments = parse({words, static_cast<std::size_t>(count)});
    if (!arguments) {
        std::cerr << "usage: portable_player FOLDER --frames N --size WxH -o PICTURE.png\n";
        return usage_error;
    }
    try {
        play(*arguments);
        return EXIT_SUCCESS;
    } catch (const std::exception& exception) {
        const std::string message = exception.what();
        const bool is_named =
            message.starts_with(arguments->folder) || message.starts_with(arguments->output);
        std::cerr << (is_named ? "" : arguments->folder + "/portable.json: ")
                  << "error: " << message << '\n';
        return EXIT_FAILURE;
    }
}
