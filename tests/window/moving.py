"""Modulation and automation of parameters, MIDI and OSC."""

import socket
import struct

from person import Person


def osc(address, number):
    """A message with one float (OSC specification 1.0)."""
    name = address.encode() + b"\0"
    return name + b"\0" * (-len(name) % 4) + b",f\0\0" + struct.pack(">f", number)


class Moving(Person):
    def test_a_parameter_moves_by_itself(self):
        program = self.program
        state = program.state()
        default = state["values"]["exposure"]
        program.reveal("exposure")
        self.hover("label:exposure")
        self.screen.do("click", 3)
        program.click("modulation")
        program.click("modulation:lfo")
        program.wait("the parameter is modulated in one step", lambda s: "exposure" in s["moving"] and
                     s["undo"] == "Modulation of Exposure" and s["is_modified"])
        seen = set()
        program.wait("the modulated value goes up and down", lambda s:
                     seen.add(s["moving"]["exposure"]) or max(seen) - min(seen) > 1)
        self.snapshot("modulation")
        state = program.state()
        self.assertEqual(state["values"]["exposure"], default)
        program.click("modulation")
        program.click("modulation:rests")
        program.wait("the modulation is off", lambda s: s["moving"] == {} and not s["is_modified"])

    def test_moves_are_recorded_to_a_file(self):
        program = self.program
        program.choose("Playback", "Record automation")
        program.set("exposure", "0.75")
        program.set("decay", "0.5")
        self.snapshot("recording")
        program.choose("Playback", "Record automation")
        program.place("dialog_file")
        file = program.folder / "automation.txt"
        program.key("ctrl+a")
        program.type(str(file))
        program.key("Return")
        program.wait("the automation is saved", lambda s: "Saved 2 parameter changes" in s["notice"])
        lines = [line.split() for line in file.read_text().splitlines()[1:]]
        self.assertEqual([line[1:] for line in lines], [["exposure", "0.75"], ["decay", "0.5"]])
        self.assertLess(float(lines[0][0]), float(lines[1][0]))

    def test_a_knob_is_asked_for_and_where_there_is_none_that_is_said(self):
        program = self.program
        program.click("play")
        program.reveal("exposure")
        self.screen.do("mousemove", *program.middle("parameter:exposure"), "click", 3)
        program.click("midi_learn:0")
        state = program.wait("the program waits for a knob, or a missing device is reported", lambda s:
                             s["midi"][1] == "exposure" or "MIDI: no device" in s["notice"])
        if state["midi"][0]:
            program.key("Escape")
            program.wait("MIDI learning is off", lambda s: s["midi"][1] == "")
        self.assertEqual(program.state()["midi"][2], 0)

    def test_another_program_turns_a_parameter(self):
        program = self.program
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        program.choose("Edit", "Remote control…")
        program.click("osc_port")
        program.type(str(port))
        program.key("Return")
        program.click("osc_listen")
        program.wait("OSC is on", lambda s: s["osc"] == port)
        sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.addCleanup(sender.close)
        for number in (2.0, 3.0, 4.0):
            sender.sendto(osc("/afterglow/exposure", number), ("127.0.0.1", port))
        program.wait("the parameter changes in one step", lambda s: s["values"]["exposure"] == [4] and
                     s["undo"] == "Remote control")
        sender.sendto(b"/no", ("127.0.0.1", port))
        program.wait("an invalid message is reported", lambda s: "OSC" in s["notice"])
        self.snapshot("remote")
        program.click("osc_listen")
        program.wait("OSC is off", lambda s: s["osc"] == 0)
        program.click("dialog_cancel")
        program.key("ctrl+z")
        program.wait("one undo restores the defaults", lambda s: not s["is_modified"])
