#include "lab/menus/inspector_menu.h"

#include "lab/document/stack_edits.h"
#include "lab/menus/window_menu.h"
#include "lab/window/window_state.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
Edit inspect(const TextureChoice& choice) {
    return [choice](WindowState& window) {
        window.views.inspected.inspect(choice);
        window.layout.reveal(panel_id::inspector);
    };
}

// Current pictures of passes are separate palette entries.
MenuSection texture_section(const InspectedParts& parts) {
    MenuSection section{"Inspect", MenuSection::Menu::pass};
    const auto offer = [&](const TextureChoice& choice) {
        section.entries.push_back({.name = choice.label(),
                                   .commands = {inspect(choice)},
                                   .is_present = choice == parts.current});
    };
    std::ranges::for_each(parts.textures, offer);
    for (int ago = 1; ago < parts.frames; ++ago) {
        TextureChoice choice = parts.current;
        choice.frames_ago = ago;
        const std::string label = choice.current().label();
        section.entries.push_back({.name = ago == 1 ? fmt::format("{}, 1 frame ago", label)
                                                    : fmt::format("{}, {} frames ago", label, ago),
                                   .commands = {inspect(choice)},
                                   .is_present = choice == parts.current});
    }
    for (int level = 1; level < parts.levels; ++level) {
        TextureChoice choice = parts.current;
        choice.level = level;
        offer(choice);
    }
    return section;
}

MenuSection channel_section(Channels current) {
    MenuSection section{"Channels", MenuSection::Menu::pass};
    for (const auto& [channels, name] :
         {std::pair{Channels::color, "Red, green and blue"},
          std::pair{Channels::red, "Red as grey"}, std::pair{Channels::green, "Green as grey"},
          std::pair{Channels::blue, "Blue as grey"}, std::pair{Channels::alpha, "Alpha as grey"},
          std::pair{Channels::luminance, "Luminance as grey"}})
        section.entries.push_back({.name = name,
                                   .commands = {[chosen = channels](WindowState& window) {
                                       window.views.inspected.channels = chosen;
                                       window.layout.panels.show(panel_id::inspector);
                                   }},
                                   .is_present = channels == current});
    return section;
}

MenuEntry view_number(const char* name, double current, Limit limit, std::string unit,
                      void (*set)(PassView& view, double number)) {
    return {.name = name,
            .number = NumberPrompt{.current = current,
                                   .unit = std::move(unit),
                                   .limit = limit,
                                   .answer = [set](double number) -> std::vector<Edit> {
                                       return {[set, number](WindowState& window) {
                                           set(window.views.inspected, number);
                                           window.layout.panels.show(panel_id::inspector);
                                       }};
                                   }}};
}

MenuSection level_section(const PassView& view) {
    constexpr Limit any{-1e9, 1e9};
    MenuSection section{"Inspect"};
    section.entries = {
        view_number("Black point…", view.levels.black, any, {},
                    [](PassView& changed, double number) {
                        changed.levels = with_black(changed.levels, number);
                    }),
        view_number("White point…", view.levels.white, any, {},
                    [](PassView& changed, double number) {
                        changed.levels = with_white(changed.levels, number);
                    }),
        view_number("Exposure…", view.exposure, {-60.0, 60.0}, "EV",
                    [](PassView& changed, double number) { changed.exposure = number; })};
    return section;
}

Edit override_pass(const std::string& pass, const PassOverride& changed) {
    return [=](Document& document) { set_override(document, pass, changed); };
}
}  // namespace

InspectedParts inspected_parts(const Executor& executor, const PassView& view) {
    const auto inspected = inspected_texture(executor, view);
    if (!inspected)
        return {executor.textures().list(), {}};
    return {executor.textures().list(), inspected->choice, frame_count(executor, inspected->choice),
            inspected->levels()};
}

std::vector<MenuSection> inspector_sections(const InspectedParts& parts, const PassView& view) {
    return {texture_section(parts), channel_section(view.channels), level_section(view)};
}

namespace {
Filter filter_of_pass(const Look& look, const std::string& pass) {
    for (const Pass& reader : look.passes)
        for (const Input& input : reader.inputs)
            if (input.from == Input::From::pass && input.name == pass)
                return input.sampler.filter;
    return Filter::linear;
}
}  // namespace

// Does not copy the look, because it can have a megabyte of texts.
std::optional<PassSetting> pass_setting(const Document& document, const std::string& pass) {
    const Look& look = document.look();
    const auto index = find_pass(look, pass);
    if (!index)
        return std::nullopt;
    const Pass& written = look.passes[static_cast<std::size_t>(*index)];
    const auto found = document.state().overrides.find(pass);
    const PassOverride tried =
        found == document.state().overrides.end() ? PassOverride{} : found->second;
    const Side& side = written.size[0];
    const std::optional<double> own =
        side.by == Side::By::viewport ? std::optional(side.factor) : std::nullopt;
    return PassSetting{tried.scale ? tried.scale : own, tried.format.value_or(written.format),
                       tried.filter.value_or(filter_of_pass(look, pass)), tried};
}

MenuSection pass_setting_section(const Document& document, const std::string& pass) {
    MenuSection section{"This pass"};
    const auto now = pass_setting(document, pass);
    if (!now)
        return section;
    const auto offer = [&](std::string name, const PassOverride& changed, bool is_present) {
        section.entries.push_back({.name = std::move(name),
                                   .commands = {override_pass(pass, changed)},
                                   .is_present = is_present});
    };
    for (const double scale : pass_scales) {
        PassOverride changed = now->tried;
        changed.scale = scale;
        offer(fmt::format("Size {}", times_text(scale)), changed, now->scale == scale);
    }
    for (const FormatInfo& info : all_formats()) {
        PassOverride changed = now->tried;
        changed.format = info.format;
        offer(fmt::format("Format {}", info.name), changed, info.format == now->format);
    }
    for (const Filter filter : {Filter::nearest, Filter::linear}) {
        PassOverride changed = now->tried;
        changed.filter = filter;
        offer(filter == Filter::nearest ? "Filter nearest" : "Filter linear", changed,
              now->filter == filter);
    }
    return section;
}
