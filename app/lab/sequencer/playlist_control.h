#pragma once

#include "lab/commands/preset_navigation.h"
#include "lab/frame/workspace.h"
#include "model/tuning/playlist.h"

#include <cstdint>

/// The playlist of the open look: advances through its presets, with a morph. Each look has one
/// list, playlists/LOOK.json in the user's folder.
class PlaylistControl {
public:
    PlaylistControl(Workspace& work, PresetNavigation& navigation)
        : m_work(work), m_navigation(navigation) {}

    const Playlist& list() const { return m_list; }
    /// Changes and saves the list. A file with errors is not overwritten.
    void set_list(Playlist list);
    void add_open_preset();
    /// Adds all presets of the look, in the order of lists.
    void add_all();
    /// A notice offers to undo it.
    void clear();

    /// Where the list is saved. It exists once the list has been changed.
    std::filesystem::path file() const;
    /// Reads the list again if this is its file.
    void file_changed(const std::filesystem::path& changed);

    bool is_playing() const { return m_is_playing; }
    /// Starts with the current preset of the list, or stops.
    void set_playing(bool is_playing);
    /// Goes `by` presets further, also while stopped. A preset that can't be read is skipped.
    void step(int by);
    /// Goes to a preset of the list.
    void go_to(std::size_t index);
    /// The current preset; meaningless for an empty list.
    std::size_t index() const;
    /// The part of its time that has passed, 0..1.
    double share(const Tempo& tempo) const;

    /// Advances if it is time. Bars are those of the tempo; seconds are counted during playback.
    void update(const Tempo& tempo, double wall_seconds);

private:
    void read();
    bool show();
    double slots(const Tempo& tempo) const;

    Workspace& m_work;
    PresetNavigation& m_navigation;
    std::string m_look;  // that the list is of
    Playlist m_list;
    bool m_is_playing = false;
    bool m_is_broken = false;  // the file; it is not overwritten
    std::int64_t m_step = 0;
    std::uint64_t m_seed = 0;  // of the shuffle
    double m_seconds = 0.0;    // of the current preset
    double m_slot = 0.0;       // whole part of slots() at the last update
};
