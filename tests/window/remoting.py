"""Remote control by OSC and MIDI: commands, replies, rejected messages, learning."""

import socket
import struct

from person import Person


def padded(text):
    data = text.encode() + b"\0"
    return data + b"\0" * (-len(data) % 4)


def osc(address, *arguments):
    """A message with floats and texts (OSC specification 1.0)."""
    tags = "," + "".join("s" if isinstance(a, str) else "f" for a in arguments)
    values = b"".join(padded(a) if isinstance(a, str) else struct.pack(">f", a) for a in arguments)
    return padded(address) + padded(tags) + values


def parse(packet):
    """The address of a message, and its arguments."""
    def text(at):
        end = packet.index(b"\0", at)
        return packet[at:end].decode(), at + (end - at) // 4 * 4 + 4
    address, at = text(0)
    tags, at = text(at)
    arguments = []
    for tag in tags[1:]:
        if tag == "s":
            word, at = text(at)
            arguments.append(word)
        else:
            arguments.append(struct.unpack(">f", packet[at:at + 4])[0])
            at += 4
    return address, arguments


class Remoting(Person):
    def listen(self):
        """Turns on OSC on a free port, with a socket that sends to it."""
        program = self.program
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(("127.0.0.1", 0))
        self.socket.settimeout(10)
        self.addCleanup(self.socket.close)
        program.choose("Edit", "Remote control…")
        program.click("osc_port")
        program.type(str(self.port))
        program.key("Return")
        if program.state()["osc"] == 0:
            program.click("osc_listen")
        program.wait("OSC is on", lambda s: s["osc"] == self.port)

    def send(self, address, *arguments):
        self.socket.sendto(osc("/afterglow/" + address, *arguments), ("127.0.0.1", self.port))

    def query(self, name):
        """The arguments of the reply to a query."""
        self.send("query/" + name)
        address, arguments = parse(self.socket.recv(4096))
        self.assertEqual(address, "/afterglow/query/" + name)
        return arguments

    def test_a_tablet_opens_presets_and_runs_actions(self):
        program = self.program
        self.listen()
        program.click("dialog_cancel")
        self.send("command/preset", "Amber P3")
        program.wait("the preset is open", lambda s: s["preset"] == "Amber P3")
        self.assertEqual(self.query("preset"), ["Amber P3"])
        self.send("command/action/wipe", 1.0)
        self.send("command/action/wipe", 0.0)
        program.wait("a wipe compares", lambda s: s["compare"]["mode"] == "wipe")
        self.send("command/action/wipe", 1.0)
        program.wait("the second press ends it", lambda s: s["compare"]["mode"] == "off")
        self.send("command/action/show_reference", 1.0)
        program.wait("the reference is shown while held", lambda s: s["compare"]["is_flashing"])
        self.send("command/action/show_reference", 0.0)
        program.wait("the picture is back", lambda s: not s["compare"]["is_flashing"])
        self.send("command/pause", 1.0)
        program.wait("playback is paused", lambda s: not s["is_playing"])
        self.assertEqual(self.query("playing"), [0.0])
        self.send("command/seek", 4.0)
        program.wait("the time is 4 s", lambda s: s["time"] == 4)
        self.send("command/play", 1.0)
        program.wait("it plays", lambda s: s["is_playing"])

    def test_blackout_comes_from_a_tablet(self):
        program = self.program
        self.listen()
        program.click("dialog_cancel")
        self.send("command/blackout", 1.0)
        program.wait("there is no output window", lambda s: "output window" in s["remote"]["reason"])
        self.send("command/action/output_window", 1.0)
        program.wait("the output window is open", lambda s: s["output"] == "on")
        self.send("command/blackout", 1.0)
        program.wait("the output is black", lambda s: s["output"] == "black")
        self.assertEqual(self.query("blackout"), [1.0])
        self.assertEqual(self.screen.brightness((20, 20, 400, 300)), 0)
        self.send("command/blackout", 0.0)
        program.wait("the picture is back", lambda s: s["output"] == "on")
        self.send("command/action/output_window", 1.0)
        program.wait("the output window is closed", lambda s: s["output"] == "off")

    def test_rejected_messages_are_listed_beside_the_bright_picture(self):
        program = self.program
        self.listen()
        before = program.state()["remote"]["rejected"]
        self.send("command/preset", "Ambre P3")
        self.send("preset", "Amber P3")
        self.send("exposur", 1.0)
        program.wait("three are rejected", lambda s: s["remote"]["rejected"] == before + 3)
        program.click("remote_show_rejected")
        program.wait("the dialog is closed and the list is shown", lambda s:
                     s["dialog"] == 0 and "remote_clear" in s["widgets"])
        self.assertIn("did you mean 'exposure'", program.state()["remote"]["reason"])
        self.snapshot("rejected")
        program.click("remote_clear")
        program.wait("the list is empty", lambda s: s["remote"]["listed"] == 0)
        program.choose("View", "Rejected remote messages")
        program.wait("the panel is closed", lambda s: "remote_clear" not in s["widgets"])

    def test_the_network_is_open_only_by_choice(self):
        program = self.program
        self.listen()
        self.assertFalse(program.state()["remote"]["from_network"])
        program.click("osc_from:Local network")
        program.wait("the network is open", lambda s: s["remote"]["from_network"])
        self.snapshot("remote_network")
        self.send("exposure", 3.0)
        program.wait("this machine can still send", lambda s: s["values"]["exposure"] == [3])
        program.click("osc_from:This machine")
        program.wait("the network is closed", lambda s: not s["remote"]["from_network"])
        program.click("dialog_cancel")
        program.key("ctrl+z")
        program.wait("the change is undone", lambda s: not s["is_modified"])

    def test_an_action_is_mapped_from_the_palette_and_from_its_menu(self):
        program = self.program
        program.key("ctrl+p")
        program.place("palette_query")
        program.type("blackout")
        self.screen.do("mousemove", *program.middle("palette:Blackout"), "click", 3)
        program.place("command_midi_learn")
        self.snapshot("palette_midi")
        program.click("command_midi_learn")
        state = program.wait("the program waits for a pad, or reports that no device is there", lambda s:
                             s["dialog"] == 0 and (s["remote"]["learning"] == "Blackout" or
                                                   "MIDI: no device" in s["notice"]))
        program.key("Escape")
        program.wait("learning is off", lambda s: s["remote"]["learning"] == "")
        program.click("menu:Playback")
        self.screen.do("mousemove", *program.middle("menu:Restart"), "click", 3)
        program.place("command_copy_address")
        self.snapshot("menu_midi")
        program.click("command_copy_address")
        program.wait("the menu is closed", lambda s: "menu:Restart" not in s["widgets"])
        self.assertEqual(state["remote"]["commands"], [])
