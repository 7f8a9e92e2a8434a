#pragma once

#include "lab/document/document.h"
#include "lab/playback/player.h"
#include "lab/playback/sound_position.h"

#include <optional>

/// Whether the part of the sound that plays is shorter than the sound.
bool has_region(const PlayedSignal& signal);

/// The shortest region, s.
inline constexpr double shortest_region = 0.01;

/// Plays a region of the sound in a loop, as one undo step. Its ends are exchanged if necessary and
/// limited to the sound. Playback continues at its position if the region has it, else at the start
/// of the region. Regions shorter than `shortest_region` are ignored.
void set_region(Document& document, Player& player, double start, double end);
/// Plays the whole sound again, as one undo step. Playback continues at its position.
void remove_region(Document& document, Player& player);
