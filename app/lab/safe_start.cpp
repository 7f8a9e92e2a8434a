#include "lab/safe_start.h"

#include <fmt/format.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace {
constexpr const char* first_look = "phosphor";

// The files or folders of the looks in the session.
std::vector<fs::path> looks_in(const Session& session) {
    std::vector<fs::path> paths{session.look};
    for (const std::string& id : look_ids(session.current.preset.look))
        if (const auto path = session.looks.find(id); path != session.looks.end())
            paths.emplace_back(path->second);
    return paths;
}

bool is_of_session(const UnfinishedOpening& left, const Session& session) {
    return std::ranges::any_of(
        looks_in(session), [&left](const fs::path& path) { return left.has(manifest_of(path)); });
}

// A look that was moved or deleted since; "": none.
fs::path missing_look(const Session& session) {
    std::error_code error;
    for (const fs::path& path : looks_in(session))
        if (!path.empty() && !fs::exists(path, error))
            return path;
    return {};
}

// Only the arrangement of the window.
Session without_look(Session session) {
    session.look.clear();
    return session;
}

std::string message_about(const UnfinishedOpening& left) {
    return left.is_reset
               ? fmt::format(
                     "The graphics driver was reset while drawing \"{}\". The look was not "
                     "reopened.",
                     left.look)
               : fmt::format("Afterglow quit while compiling \"{}\". The look was not reopened.",
                             left.look);
}

OpenRequest request_of(const UnfinishedOpening& left) {
    OpenRequest request{left.paths.front(), {}, {}};
    if (left.paths.size() > 1)
        for (const fs::path& path : left.paths)
            request.stack.push_back({{}, path, {}});
    return request;
}
}  // namespace

void offer_unopened(Lab& lab, const Session& session, const UnfinishedOpening& left) {
    const bool is_session = !session.look.empty() && is_of_session(left, session);
    const auto open_again = [session, left, is_session](Lab& opening) {
        opening.messages().dismiss();
        if (is_session)
            restore(opening, session);
        else
            opening.loader().open(request_of(left));
    };
    const fs::path file = left.file();
    lab.messages().ask(
        message_about(left),
        {MenuEntry{.name = "Try again", .commands = {open_again}},
         MenuEntry{.name = "Open in editor", .commands = {[file](Lab& opening) {
                                                 opening.looks().open_in_editor({file, 1});
                                             }}}});
}

void restore_safely(Lab& lab, const Session& session,
                    const std::optional<UnfinishedOpening>& left) {
    const fs::path missing = missing_look(session);
    const bool is_first = session.look.empty() || !missing.empty();
    const fs::path first = lab.work().library.roots().program / "shaders" / first_look;
    const bool is_safe =
        !left || !(is_first ? left->has(manifest_of(first)) : is_of_session(*left, session));
    if (!is_safe || !missing.empty())
        lab.looks().stash_unsaved(session);
    restore(lab, is_safe && !is_first ? session : without_look(session));
    if (is_safe && is_first)
        lab.looks().open(first_look);
    if (!missing.empty())
        lab.messages().say(
            fmt::format("The look of the last session was not found: {}. Open it from its new "
                        "location. Its unsaved changes are kept in File > Unsaved changes.",
                        missing.string()),
            true);
    if (left)
        offer_unopened(lab, session, *left);
}
