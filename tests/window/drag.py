"""Drags files onto a window and drops them there: the source side of XDND, version 5."""

import ctypes
import ctypes.util
import time
from ctypes import Structure, Union, byref, c_char_p, c_int, c_long, c_ulong, c_void_p
from pathlib import Path

CLIENT_MESSAGE, SELECTION_REQUEST, SELECTION_NOTIFY = 33, 30, 31  # X.h
CURRENT_TIME = 0


class ClientMessage(Structure):
    _fields_ = [("type", c_int), ("serial", c_ulong), ("send_event", c_int), ("display", c_void_p),
                ("window", c_ulong), ("message", c_ulong), ("format", c_int), ("data", c_long * 5)]


class SelectionRequest(Structure):
    _fields_ = [("type", c_int), ("serial", c_ulong), ("send_event", c_int), ("display", c_void_p),
                ("owner", c_ulong), ("requestor", c_ulong), ("selection", c_ulong),
                ("target", c_ulong), ("property", c_ulong), ("time", c_ulong)]


class Selection(Structure):
    _fields_ = [("type", c_int), ("serial", c_ulong), ("send_event", c_int), ("display", c_void_p),
                ("requestor", c_ulong), ("selection", c_ulong), ("target", c_ulong),
                ("property", c_ulong), ("time", c_ulong)]


class Event(Union):
    _fields_ = [("type", c_int), ("client", ClientMessage), ("request", SelectionRequest),
                ("selection", Selection), ("pad", c_long * 24)]


def load_xlib():
    xlib = ctypes.CDLL(ctypes.util.find_library("X11") or "libX11.so.6")
    xlib.XOpenDisplay.restype = c_void_p
    xlib.XDefaultRootWindow.restype = c_ulong
    xlib.XCreateSimpleWindow.restype = c_ulong
    xlib.XInternAtom.restype = c_ulong
    return xlib


class Drag:
    """The source of a drag with files."""

    def __init__(self, display, files):
        self.x = load_xlib()
        self.display = c_void_p(self.x.XOpenDisplay(display.encode()))
        root = c_ulong(self.x.XDefaultRootWindow(self.display))
        self.window = c_ulong(self.x.XCreateSimpleWindow(self.display, root, 0, 0, 1, 1, 0,
                                                         c_ulong(0), c_ulong(0)))
        self.list = "".join(Path(file).resolve().as_uri() + "\r\n" for file in files).encode()
        self.atoms = {}

    def atom(self, name):
        if name not in self.atoms:
            self.atoms[name] = self.x.XInternAtom(self.display, name.encode(), 0)
        return self.atoms[name]

    def send(self, target, message, *data):
        event = Event()
        event.client = ClientMessage(CLIENT_MESSAGE, 0, 1, self.display, target,
                                     self.atom(message), 32,
                                     (c_long * 5)(self.window.value, *data))
        self.x.XSendEvent(self.display, c_ulong(target), 0, c_long(0), byref(event))
        self.x.XFlush(self.display)

    def answer(self, request):
        """Sends the list of files to the window that requests the selection."""
        self.x.XChangeProperty(self.display, c_ulong(request.requestor), c_ulong(request.property),
                               c_ulong(request.target), 8, 0, c_char_p(self.list), len(self.list))
        event = Event()
        event.selection = Selection(SELECTION_NOTIFY, 0, 1, self.display, request.requestor,
                                    request.selection, request.target, request.property,
                                    request.time)
        self.x.XSendEvent(self.display, c_ulong(request.requestor), 0, c_long(0), byref(event))
        self.x.XFlush(self.display)

    def wait(self, message):
        """The data of the next message of this type. Answers selection requests while waiting."""
        end = time.monotonic() + 30
        event = Event()
        while time.monotonic() < end:
            if not self.x.XPending(self.display):
                time.sleep(0.01)
                continue
            self.x.XNextEvent(self.display, byref(event))
            if event.type == SELECTION_REQUEST:
                self.answer(event.request)
            elif event.type == CLIENT_MESSAGE and event.client.message == self.atom(message):
                return list(event.client.data)
        raise AssertionError("no %s received" % message)

    def drop(self, target, x, y):
        """Drops at a screen position in the window `target`. True if it accepts the files."""
        selection, copy = self.atom("XdndSelection"), self.atom("XdndActionCopy")
        self.x.XSetSelectionOwner(self.display, c_ulong(selection), self.window,
                                  c_ulong(CURRENT_TIME))
        self.send(target, "XdndEnter", 5 << 24, self.atom("text/uri-list"), 0, 0)
        self.send(target, "XdndPosition", 0, x << 16 | y, CURRENT_TIME, copy)
        is_welcome = self.wait("XdndStatus")[1] & 1
        self.send(target, "XdndDrop" if is_welcome else "XdndLeave", 0, CURRENT_TIME, 0, 0)
        return bool(is_welcome) and self.wait("XdndFinished")[1] != 0

    def close(self):
        self.x.XCloseDisplay(self.display)
