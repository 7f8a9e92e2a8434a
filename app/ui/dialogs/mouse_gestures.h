#pragma once

#include <array>

/// What a movement of the mouse does.
struct MouseGesture {
    const char* gesture;
    const char* effect;
};

constexpr std::array mouse_gestures{
    MouseGesture{"Drag a slider", "Change the value"},
    MouseGesture{"Shift+drag a slider", "Change it 10 times more finely"},
    MouseGesture{"Alt+drag a slider", "Change it 10 times more coarsely"},
    MouseGesture{"Ctrl+Shift+drag a slider", "As Alt+drag, where the desktop takes Alt"},
    MouseGesture{"Click a number", "Type a value, even beyond the slider's range"},
    MouseGesture{"Ctrl+click or double-click a slider", "Type a value"},
    MouseGesture{"Click a parameter name", "Show its help, declaration and slider range"},
    MouseGesture{"Right-click a parameter", "Modulation, MIDI learn, favourite, lock"},
    MouseGesture{"Right-click the die", "Choose how far to randomise"},
    MouseGesture{"Scroll over a picture", "Zoom at the pointer"},
    MouseGesture{"Drag a picture", "Pan, or rotate the object in 3D looks"},
    MouseGesture{"Middle-drag a picture", "Pan"},
    MouseGesture{"Right-drag a picture", "Orbit the camera in 3D looks"},
    MouseGesture{"Ctrl+scroll over a picture", "Move the camera nearer or farther in 3D looks"},
    MouseGesture{"Shift+drag on the picture", "Draw a new line for the waveform"},
    MouseGesture{"Click a preset", "Load it"},
    MouseGesture{"Shift+click a preset", "Morph to it"},
    MouseGesture{"Right-click a preset", "Compare, morph, rename, delete"},
    MouseGesture{"Right-click a slot", "Store, recall, clear"},
    MouseGesture{"Click a pass in the strip", "Inspect it"},
    MouseGesture{"Double-click a pass in the strip", "Show it large"},
    MouseGesture{"Right-click a pass", "Bypass, solo, freeze, save"},
    MouseGesture{"Double-click the histogram", "Fit black and white"},
    MouseGesture{"Drop a file on the window", "Open a look, preset, sound or picture"},
};
