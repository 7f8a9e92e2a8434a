"""Small servers in place of programs that load shaders while they run."""
import json
import socket
import threading


class RetroArchServer:
    """Answers VERSION, and keeps the presets of SET_SHADER with their text."""

    def __init__(self):
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.bind(("127.0.0.1", 0))
        self.port = self._socket.getsockname()[1]
        self.loaded = []
        threading.Thread(target=self._serve, daemon=True).start()

    def _serve(self):
        while True:
            try:
                packet, sender = self._socket.recvfrom(65536)
            except OSError:
                return  # closed
            command, _, argument = packet.decode().strip().partition(" ")
            if command == "VERSION":
                self._socket.sendto(b"1.19.1\n", sender)
            elif command == "SET_SHADER":
                with open(argument, encoding="utf-8") as file:
                    self.loaded.append((argument, file.read()))

    def close(self):
        self._socket.close()


class MpvServer:
    """The list of user shaders behind the JSON socket of mpv. Sends other lines before each answer."""

    OTHER_LINES = '{"event": "tick"}\n{"request_id": "odd", "error": 1}\n[1]\nno JSON\n'

    def __init__(self, path, shaders):
        self.shaders = shaders
        self._socket = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        self._socket.bind(str(path))
        self._socket.listen()
        threading.Thread(target=self._serve, daemon=True).start()

    def _serve(self):
        while True:
            try:
                connection, _ = self._socket.accept()
            except OSError:
                return  # closed
            with connection, connection.makefile("rw", encoding="utf-8") as lines:
                for line in lines:
                    lines.write(self.OTHER_LINES + json.dumps(self._answer(json.loads(line))) + "\n")
                    lines.flush()

    def _answer(self, request):
        command = request["command"]
        answer = {"request_id": request["request_id"], "error": "success"}
        if command == ["get_property", "glsl-shaders"]:
            return {**answer, "data": self.shaders}
        if command[:2] == ["set_property", "glsl-shaders"]:
            self.shaders = command[2]
            return answer
        return {**answer, "error": "invalid parameter"}

    def close(self):
        self._socket.close()
