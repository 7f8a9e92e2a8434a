// A stand-in for the desktop's file dialog, for tests of the window:
// fake_portal FOLDER
// It reads its reaction to each question from FOLDER/reaction: "choose URI", "cancel", "hang" or
// "leave". It appends each question to FOLDER/calls. It ends with its standard input.
#include "io/desktop/fake_portal.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

int main(int count, char** arguments) {
    if (count != 2)
        return EXIT_FAILURE;
    const std::filesystem::path folder = arguments[1];
    using Kind = FakePortal::Reaction::Kind;
    const FakePortal portal([folder](const std::string& call) {
        std::ofstream(folder / "calls", std::ios::app) << call << '\n';
        std::ifstream file(folder / "reaction");
        std::string word;
        std::string uri;
        file >> word >> uri;
        FakePortal::Reaction reaction{.code = word == "choose" ? 0U : 1U};
        if (word == "choose")
            reaction.uris = {uri};
        if (word == "hang")
            reaction.kind = Kind::hang;
        if (word == "leave")
            reaction.kind = Kind::leave;
        return reaction;
    });
    if (!portal.is_running())
        return EXIT_FAILURE;
    std::cout << "running" << std::endl;
    while (std::cin.get() != std::char_traits<char>::eof()) {
    }
    return EXIT_SUCCESS;
}
