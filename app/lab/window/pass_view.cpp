#include "lab/window/pass_view.h"

void PassView::inspect(const std::string& name) {
    pass = name;
    other.reset();
}

void PassView::inspect(const TextureChoice& choice) {
    if (choice.from == Input::From::pass)
        pass = choice.name;
    other = choice.is_present_pass() ? std::nullopt : std::optional(choice);
}

void PassView::fit(const Statistics& statistics) {
    levels = fitted_levels(statistics);
    exposure = 0.0;
}

void PassView::reset_levels() {
    levels = {};
    exposure = 0.0;
}
