#pragma once

#include <functional>
#include <tuple>
#include <type_traits>
#include <utility>

class AudioControl;
class Automation;
class BackgroundJobs;
class ComparisonView;
class ContentCommands;
class Document;
class DrawingTool;
class ExternalPrograms;
class FrameLoop;
class Lab;
class LiveChoices;
class LookCommands;
class LookSender;
class MediaInput;
class Messages;
class ParameterSettingsStore;
class PassControl;
class Player;
class PresetCommands;
class Previews;
class RemoteControl;
class RenderSize;
class Renderer;
class Sequencer;
struct WindowState;

/// Pointers to the parts that an edit may change. Null: there is none, such as the document while
/// no look is open. `Lab` is for edits that open a session.
using MutableParts =
    std::tuple<AudioControl*, Automation*, BackgroundJobs*, ComparisonView*, ContentCommands*,
               Document*, DrawingTool*, ExternalPrograms*, FrameLoop*, Lab*, LiveChoices*,
               LookCommands*, LookSender*, MediaInput*, Messages*, ParameterSettingsStore*,
               PassControl*, Player*, PresetCommands*, Previews*, RemoteControl*, RenderSize*,
               Renderer*, Sequencer*, WindowState*>;

/// A change of some parts: a function that takes references to them, such as
/// [](Player& player) { player.pause(); }.
class Edit {
public:
    template <class Change>
    requires(!std::is_same_v<std::remove_cvref_t<Change>, Edit>) Edit(Change change)
        : Edit(FromParts(), std::function(std::move(change))) {}

    /// Does nothing if one of the parts is not there.
    void operator()(const MutableParts& parts) const { m_change(parts); }
    bool changes_only_window() const { return m_changes_only_window; }

private:
    struct FromParts {};
    template <class... Parts>
    Edit(FromParts, std::function<void(Parts&...)> change)
        : m_change([change = std::move(change)](const MutableParts& all) {
              if ((std::get<std::remove_const_t<Parts>*>(all) && ...))
                  change(*std::get<std::remove_const_t<Parts>*>(all)...);
          }),
          m_changes_only_window(sizeof...(Parts) == 1 &&
                                (std::is_same_v<Parts, WindowState> && ...)) {}

    std::function<void(const MutableParts&)> m_change;
    bool m_changes_only_window = false;
};
