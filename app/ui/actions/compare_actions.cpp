#include "ui/actions/compare_actions.h"

#include "gpu/input_event.h"
#include "ui/actions/file_actions.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"
#include "ui/picture/comparison_edits.h"

#include <algorithm>
#include <cmath>

namespace {
constexpr int f5 = gpu::key::first_function + 4;

const Comparison& chosen(const Scene& scene) {
    return scene.lab.frames.comparison().selection().chosen();
}

template <CompareMode mode>
bool is_seen(const Scene& scene) {
    return chosen(scene).mode == mode;
}

template <CompareMode mode>
void toggle(const Scene& scene, Edits& edits) {
    set_compare_mode(is_seen<mode>(scene) ? CompareMode::off : mode, edits);
}

bool is_reference_shown(const Scene& scene) {
    return scene.lab.frames.comparison().selection().is_reference_shown();
}

void show_reference(const Scene& scene, Edits& edits) {
    edits.change([next = !is_reference_shown(scene)](ComparisonView& comparison) {
        comparison.show_reference(next);
    });
}

void end_flash(const Scene&, Edits& edits) {
    edits.change([](ComparisonView& comparison) { comparison.show_reference(false); });
}

void next_measure(const Scene&, Edits& edits) {
    change_comparison(edits, [](Comparison& comparison) {
        const int next = (static_cast<int>(comparison.measure) + 1) % 3;
        comparison.measure = static_cast<DifferenceMeasure>(next);
        comparison.mode = CompareMode::difference;
    });
}

void toggle_brightness(const Scene&, Edits& edits) {
    change_comparison(edits, [](Comparison& comparison) {
        comparison.has_equal_brightness = !comparison.has_equal_brightness;
    });
}

bool has_equal_brightness(const Scene& scene) {
    return chosen(scene).has_equal_brightness;
}

template <std::size_t slot>
void keep(const Scene&, Edits& edits) {
    edits.change([](ComparisonView& comparison) { comparison.store(slot); });
}

template <std::size_t slot>
void recall(const Scene&, Edits& edits) {
    edits.change([](ComparisonView& comparison) { comparison.recall(slot); });
}

template <std::size_t slot>
bool is_present(const Scene& scene) {
    return scene.lab.frames.comparison().is_in_slot(slot);
}

template <std::size_t slot>
bool is_filled(const Scene& scene) {
    return scene.lab.frames.comparison().slots()[slot].has_value();
}

bool is_compared(const Scene& scene, const Other& other) {
    return chosen(scene).mode != CompareMode::off && chosen(scene).other == other;
}

template <std::size_t slot>
void compare_with(const Scene&, Edits& edits) {
    edits.change([](ComparisonView& comparison) {
        comparison.compare_with({Other::Kind::slot, slot});
    });
}

template <std::size_t slot>
bool is_other(const Scene& scene) {
    return is_compared(scene, {Other::Kind::slot, slot});
}

bool can_fit_gain(const Scene& scene) {
    return scene.lab.frames.comparison().mode() == CompareMode::difference &&
           chosen(scene).measure != DifferenceMeasure::relative;
}

void fit_gain(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) { window.views.pending.gain = true; });
}

void compare_with_article(const Scene&, Edits& edits) {
    edits.change([](ComparisonView& comparison) { comparison.compare_with({}); });
}

bool is_article_other(const Scene& scene) {
    return is_compared(scene, {});
}

bool is_file_other(const Scene& scene) {
    return is_compared(scene, {Other::Kind::file, 0, chosen(scene).other.file});
}

void choose_reference(const Scene&, Edits& edits) {
    edits.show({.kind = Dialog::Kind::choose_reference});
}

void match_photo(const Scene&, Edits& edits) {
    edits.show({.kind = Dialog::Kind::match_photo});
}

Action action(ActionId id, const char* label, Chord chord, void (*act)(const Scene&, Edits&),
              bool (*is_on)(const Scene&)) {
    return {id, Menu::compare, label, chord, false, act, file_actions::has_document, is_on};
}

template <std::size_t slot>
std::vector<Action> slot_actions(std::array<ActionId, 3> ids, std::array<const char*, 3> labels) {
    constexpr int key = f5 + static_cast<int>(slot);
    std::vector<Action> actions{
        action(ids[0], labels[0], {key, false, true}, keep<slot>, nullptr),
        action(ids[1], labels[1], {key}, recall<slot>, is_present<slot>),
        action(ids[2], labels[2], {key, true}, compare_with<slot>, is_other<slot>)};
    actions[0].is_first = true;
    actions[1].is_enabled = actions[2].is_enabled = is_filled<slot>;
    return actions;
}

std::vector<Action> seeing_actions() {
    using Mode = CompareMode;
    using Id = ActionId;
    std::vector<Action> actions{
        action(Id::show_reference, "Show reference (hold)", {'O'}, show_reference,
               is_reference_shown),
        action(Id::wipe, "Wipe", {'W'}, toggle<Mode::wipe>, is_seen<Mode::wipe>),
        action(Id::side_by_side, "Side by side", {'W', false, true}, toggle<Mode::side_by_side>,
               is_seen<Mode::side_by_side>),
        action(Id::difference, "Difference", {'M'}, toggle<Mode::difference>,
               is_seen<Mode::difference>),
        action(Id::next_measure, "Next difference metric", {'M', false, true}, next_measure,
               nullptr),
        action(Id::fit_gain, "Auto gain", {}, fit_gain, nullptr),
        action(Id::equal_brightness, "Equal brightness", {'B'}, toggle_brightness,
               has_equal_brightness),
        action(Id::with_article, "Compare with original article", {f5 + 3, true},
               compare_with_article, is_article_other),
        action(Id::with_file, "Compare with image file…", {f5 + 4, true}, choose_reference,
               is_file_other),
        action(Id::match_photo, "Match a photo…", {}, match_photo, nullptr)};
    actions[0].on_release = end_flash;
    actions[5].is_enabled = can_fit_gain;
    actions[6].is_first = actions[7].is_first = actions[9].is_first = true;
    return actions;
}
}  // namespace

std::vector<Action> compare_actions::list() {
    using Id = ActionId;
    std::vector<Action> actions = seeing_actions();
    for (const auto& slot :
         {slot_actions<0>({Id::store_a, Id::recall_a, Id::with_a},
                          {"Store in slot A", "Recall slot A", "Compare with slot A"}),
          slot_actions<1>({Id::store_b, Id::recall_b, Id::with_b},
                          {"Store in slot B", "Recall slot B", "Compare with slot B"}),
          slot_actions<2>({Id::store_c, Id::recall_c, Id::with_c},
                          {"Store in slot C", "Recall slot C", "Compare with slot C"})})
        actions.insert(actions.end(), slot.begin(), slot.end());
    return actions;
}
