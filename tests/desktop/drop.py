#!/usr/bin/python3
"""drop.py WINDOW FILE...: drops files on a window, as a file manager does by XDND."""
import ctypes
import os
import sys
from urllib.parse import quote

x11 = ctypes.CDLL("libX11.so.6")
Long, ULong, Pointer = ctypes.c_long, ctypes.c_ulong, ctypes.c_void_p
x11.XOpenDisplay.restype = Pointer
for name in ("XInternAtom", "XDefaultRootWindow", "XCreateSimpleWindow"):
    getattr(x11, name).restype = ULong


class ClientMessage(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ULong), ("send_event", ctypes.c_int), ("display", Pointer),
                ("window", ULong), ("message_type", ULong), ("format", ctypes.c_int), ("data", Long * 5)]


class Selection(ctypes.Structure):  # of a request; a notice lacks the owner
    _fields_ = [("type", ctypes.c_int), ("serial", ULong), ("send_event", ctypes.c_int), ("display", Pointer),
                ("owner", ULong), ("requestor", ULong), ("selection", ULong), ("target", ULong), ("property", ULong),
                ("time", ULong)]


class Notice(ctypes.Structure):
    _fields_ = [field for field in Selection._fields_ if field[0] != "owner"]


class Event(ctypes.Union):
    _fields_ = [("type", ctypes.c_int), ("client", ClientMessage), ("request", Selection), ("notice", Notice),
                ("pad", Long * 24)]


target = int(sys.argv[1])
text = "".join(f"file://{quote(os.path.abspath(path))}\r\n" for path in sys.argv[2:]).encode()
display = Pointer(x11.XOpenDisplay(None))
atom = lambda name: x11.XInternAtom(display, name.encode(), 0)
source = x11.XCreateSimpleWindow(display, ULong(x11.XDefaultRootWindow(display)), 0, 0, 1, 1, 0, ULong(0), ULong(0))
selection, uri_list = atom("XdndSelection"), atom("text/uri-list")
x11.XSetSelectionOwner(display, ULong(selection), ULong(source), ULong(0))


def send(window, event):
    x11.XSendEvent(display, ULong(window), 0, Long(0), ctypes.byref(event))
    x11.XFlush(display)


def say(name, *data):
    event = Event()
    event.client = ClientMessage(33, 0, 1, display, target, atom(name), 32, (Long * 5)(source, *data))
    send(target, event)


version = 5
say("XdndEnter", version << 24, uri_list, 0, 0)
say("XdndPosition", 0, 300 << 16 | 300, 0, atom("XdndActionCopy"))
say("XdndDrop", 0, 0, 0, 0)
while True:
    event = Event()
    x11.XNextEvent(display, ctypes.byref(event))
    if event.type == 30:  # SelectionRequest
        asked = event.request
        x11.XChangeProperty(display, ULong(asked.requestor), ULong(asked.property), ULong(uri_list), 8, 0, text, len(text))
        reply = Event()
        reply.notice = Notice(31, 0, 1, display, asked.requestor, asked.selection, asked.target, asked.property, asked.time)
        send(asked.requestor, reply)
    if event.type == 33 and event.client.message_type == atom("XdndFinished"):
        break
