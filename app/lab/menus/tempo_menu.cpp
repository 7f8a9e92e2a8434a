#include "lab/menus/tempo_menu.h"

#include "lab/sequencer/sequencer.h"

MenuSection tempo_section(const Tempo& tempo) {
    MenuSection section{"Tempo"};
    section.entries.push_back(
        {.name = "Beats per minute…",
         .number = NumberPrompt{.current = tempo.bpm,
                                .unit = "BPM",
                                .limit = {min_bpm, max_bpm},
                                .help = "Sets modulations in beats and playlists in bars.",
                                .answer = [](double typed) -> std::vector<Edit> {
                                    return {[typed](Sequencer& sequencer) {
                                        sequencer.tempo().set_bpm(typed);
                                    }};
                                }}});
    section.entries.push_back(
        {.name = "Beats per bar…",
         .number = NumberPrompt{.current = tempo.beats_per_bar,
                                .limit = {1.0, max_beats_per_bar},
                                .is_whole = true,
                                .help = "Quarter notes per bar.",
                                .answer = [](double typed) -> std::vector<Edit> {
                                    return {[typed](Sequencer& sequencer) {
                                        sequencer.tempo().set_beats_per_bar(typed);
                                    }};
                                }}});
    return section;
}
