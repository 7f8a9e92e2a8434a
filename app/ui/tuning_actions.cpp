#include "ui/tuning_actions.h"

#include "ui/file_actions.h"

#include <random>

namespace {
void randomise(const Scene&, Edits& edits) {
    std::random_device chance;
    const std::uint64_t seed = (static_cast<std::uint64_t>(chance()) << 32) | chance();
    edits.document([seed](Document& document) { document.randomise(seed); });
}

template <ParameterFilter filter>
bool is_filtered(const Scene& scene) {
    return scene.window.filter == filter;
}

template <ParameterFilter filter>
void toggle_filter(const Scene& scene, Edits& edits) {
    const ParameterFilter next = is_filtered<filter>(scene) ? ParameterFilter::all : filter;
    edits.arrange([next](WindowState& window) {
        window.filter = next;
        window.shows_parameters = true;
    });
}
}  // namespace

std::vector<Action> tuning_actions::list() {
    constexpr auto favourites = ParameterFilter::favourites;
    constexpr auto of_pass = ParameterFilter::of_pass;
    return {{ActionId::show_favourites,
             Menu::edit,
             "Show only favourites",
             {},
             false,
             toggle_filter<favourites>,
             file_actions::has_document,
             is_filtered<favourites>},
            {ActionId::show_of_pass,
             Menu::edit,
             "Show only what this pass uses",
             {},
             false,
             toggle_filter<of_pass>,
             file_actions::has_document,
             is_filtered<of_pass>},
            {ActionId::randomise,
             Menu::edit,
             "Randomise",
             {'R', true},
             true,
             randomise,
             file_actions::has_document}};
}
