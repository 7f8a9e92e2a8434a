"""render with cues, a tempo, a part of a sound, and several sounds."""

import json
import math
import struct
import wave

from program import ProgramTest, main, run

RATE = 48000


def tone(seconds, hertz, first=0):
    """Stereo samples of a circle, from sample number `first` on."""
    frames = []
    for i in range(first, first + round(seconds * RATE)):
        angle = 2.0 * math.pi * hertz * i / RATE
        frames.append(struct.pack("<hh", round(20000 * math.cos(angle)), round(20000 * math.sin(angle))))
    return b"".join(frames)


class Timeline(ProgramTest):
    def sound(self, name, *parts):
        file = self.folder / name
        with wave.open(str(file), "wb") as sound:
            sound.setnchannels(2)
            sound.setsampwidth(2)
            sound.setframerate(RATE)
            sound.writeframes(b"".join(parts))
        return file

    def frames(self, folder, *arguments):
        """The pictures of a render of 12 frames."""
        (self.folder / folder).mkdir()
        self.assert_done(run("render", "phosphor", "--size", "64x48", "--frames", 12, *arguments, "-o",
                             self.folder / folder / "f_%04d.png"))
        return [file.read_bytes() for file in sorted((self.folder / folder).iterdir())]

    def test_joined_sounds_give_the_frames_of_the_concatenated_sound(self):
        a, b = tone(0.07, 200), tone(0.2, 700)
        self.sound("a.wav", a)
        self.sound("b.wav", b)
        self.sound("ab.wav", a, b)
        joined = self.frames("joined", "--signal", f"audio:{self.folder}/a.wav,mode=xy", "--signal",
                             f"audio:{self.folder}/b.wav", "--join")
        self.assertEqual(len(joined), 12)
        self.assertEqual(joined, self.frames("whole", "--signal", f"audio:{self.folder}/ab.wav,mode=xy"))

    def test_several_sounds_give_one_sequence_each_named_after_the_sound(self):
        for name, hertz in (("low", 200), ("high", 700)):
            self.sound(f"{name}.wav", tone(0.2, hertz))
        (self.folder / "out").mkdir()
        self.assert_done(run("render", "phosphor", "--size", "64x48", "--frames", 2, "--signal",
                             f"audio:{self.folder}/low.wav", "--signal", f"audio:{self.folder}/high.wav", "-o",
                             self.folder / "out" / "{name}_%04d.png"))
        self.assertEqual(sorted(file.name for file in (self.folder / "out").iterdir()),
                         ["high_0000.png", "high_0001.png", "low_0000.png", "low_0001.png"])

    def test_wrong_use_of_several_sounds_is_explained(self):
        two = ("--signal", "audio:a.wav", "--signal", "audio:b.wav")
        for arguments, words in (((*two, "-o", "one.mp4"), ("{name}", "--join")),
                                 (("--signal", "audio:a.wav", "--join", "-o", "one.mp4"), ("--join",)),
                                 ((*two[:2], "--signal", "lissajous:x=3", "-o", "out/{name}.mp4"), ("lissajous",)),
                                 ((*two[:2], "--signal", "audio:x/a.wav", "-o", "out/{name}.mp4"), ("a.mp4",))):
            self.assert_refused(run("render", "phosphor", *arguments), *words, code=2)
        self.assert_refused(run("bench", "phosphor", *two), "--signal", code=2)

    def test_cues_and_joined_sounds_do_not_loop(self):
        self.assert_refused(run("render", "phosphor", "--cues", "show.txt", "--loop", "-o", "a.mp4"), "--cues", code=2)
        self.assert_refused(run("render", "phosphor", "--signal", "audio:a.wav", "--signal", "audio:b.wav", "--join",
                                "--loop", "-o", "a.mp4"), "--join", code=2)

    def test_sounds_with_other_rates_are_not_joined(self):
        self.sound("a.wav", tone(0.1, 200))
        with wave.open(str(self.folder / "b.wav"), "wb") as sound:
            sound.setnchannels(2)
            sound.setsampwidth(2)
            sound.setframerate(44100)
            sound.writeframes(tone(0.1, 200))
        self.assert_refused(run("render", "phosphor", "--signal", f"audio:{self.folder}/a.wav", "--signal",
                                f"audio:{self.folder}/b.wav", "--join", "-o", self.folder / "x_%04d.png"),
                            "b.wav", "44100", "48000")

    def test_a_part_of_a_sound_gives_the_frames_of_that_part(self):
        before, part = tone(0.1, 300), tone(0.1, 900)
        self.sound("long.wav", before, part, before)
        self.sound("part.wav", part)
        cut = self.frames("cut", "--signal", f"audio:{self.folder}/long.wav,mode=xy,start=0.1,end=0.2")
        self.assertEqual(cut, self.frames("part", "--signal", f"audio:{self.folder}/part.wav,mode=xy"))

    def test_a_cue_gives_the_frames_of_its_value_and_errors_name_file_and_line(self):
        cues = self.write("show.txt", "0:00 parameter exposure 2  # from the start\n")
        self.assertEqual(self.frames("cued", "--cues", cues), self.frames("set", "--set", "exposure=2"))
        self.write("show.txt", "# fine\n0:01 parameter expsure 2\n0:02 preset none\n0:03 nothing\n")
        self.assert_refused(run("render", "phosphor", "--cues", cues, "-o", self.folder / "x.png"),
                            "show.txt:4: error: unknown command 'nothing'")
        self.write("show.txt", "# fine\n0:01 parameter expsure 2\n0:02 preset none\n")
        self.assert_refused(run("render", "phosphor", "--cues", cues, "-o", self.folder / "x.png"),
                            "show.txt:2: error: ", "show.txt:3: error: ")

    def test_a_preset_cue_gives_the_frames_of_the_preset(self):
        """Also those of its tube, which sets the number of channels of a pass."""
        cues = self.write("show.txt", '0:00 preset "Amber P3"\n')
        signal = ("--signal", "lissajous:x=3,y=2")
        self.assertEqual(self.frames("cued", "--cues", cues, *signal),
                         self.frames("preset", "--preset", "amber-p3", *signal))

    def test_a_blackout_is_black(self):
        cues = self.write("show.txt", "0:00.1 blackout on\n0:00.15 blackout off\n")
        black = self.frames("black", "--cues", cues)
        plain = self.frames("plain")
        # Frame n (from 1) ends at n / 60 s: 6 to 8 are black.
        self.assertEqual([i + 1 for i in range(12) if black[i] != plain[i]], [6, 7, 8])
        self.assertEqual(black[5], black[7])

    def test_the_tempo_of_the_command_line_and_of_the_preset_are_the_same(self):
        modulation = {"exposure": {"kind": "lfo", "unit": "beats", "period": 1, "depth": 0.2}}
        preset = {"format": "afterglow-preset", "version": 1, "look": "phosphor", "name": "Moving",
                  "values": {}, "modulation": modulation}
        plain = self.write("plain.json", json.dumps(preset))
        fast = self.write("fast.json", json.dumps({**preset, "tempo": {"bpm": 240}}))
        at_240 = self.frames("a", "--preset", plain, "--tempo", 240)
        self.assertEqual(at_240, self.frames("b", "--preset", fast))
        self.assertNotEqual(at_240, self.frames("c", "--preset", plain))
        self.assert_refused(run("render", "phosphor", "--tempo", 5, "-o", self.folder / "x.png"), "--tempo", code=2)


if __name__ == "__main__":
    main()
