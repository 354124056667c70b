#!/usr/bin/python3
"""fake_portal.py FOLDER: a desktop's portal whose file dialogs are answered by a test. Each dialog appends a line of JSON
to FOLDER/asked; it is open until there is a FOLDER/answer: a path that is chosen, "cancel", or "fail"."""
import json
import os
import sys
from urllib.parse import quote

import dbus
import dbus.service
from dbus.mainloop.glib import DBusGMainLoop
from gi.repository import GLib

DBusGMainLoop(set_as_default=True)
bus = dbus.SessionBus()
folder = sys.argv[1]
requests = {}


def note(**what):
    with open(f"{folder}/asked", "a", encoding="utf8") as file:
        print(json.dumps(what), file=file, flush=True)


class Request(dbus.service.Object):
    @dbus.service.signal("org.freedesktop.portal.Request", signature="ua{sv}")
    def Response(self, response, results):
        pass

    @dbus.service.method("org.freedesktop.portal.Request")
    def Close(self):
        note(method="Close")
        self.remove_from_connection()

    def look(self):
        file = f"{folder}/answer"
        if not self._locations:  # it was closed
            return False
        if not os.path.exists(file):
            return True
        with open(file, encoding="utf8") as answer:
            text = answer.read().strip()
        os.remove(file)
        chosen = text not in ("cancel", "fail")
        results = {"uris": dbus.Array(["file://" + quote(text)], signature="s")} if chosen else {}
        self.Response(dbus.UInt32(0 if chosen else ["", "cancel", "fail"].index(text)), results)
        self.remove_from_connection()
        return False


class Portal(dbus.service.Object):
    def ask(self, method, title, options, sender):
        filters = [[str(pattern) for _, pattern in patterns] for _, patterns in options["filters"]]
        note(method=method, title=str(title), filters=filters, name=str(options.get("current_name", "")),
             folder=bytes(options.get("current_folder", [])).decode())
        own = sender[1:].replace(".", "_")
        path = f"/org/freedesktop/portal/desktop/request/{own}/{options['handle_token']}"
        request = requests[path] = Request(bus, path)
        GLib.timeout_add(50, request.look)
        return dbus.ObjectPath(path)

    @dbus.service.method("org.freedesktop.portal.FileChooser", "ssa{sv}", "o", sender_keyword="sender")
    def OpenFile(self, _parent, title, options, sender=None):
        return self.ask("OpenFile", title, options, sender)

    @dbus.service.method("org.freedesktop.portal.FileChooser", "ssa{sv}", "o", sender_keyword="sender")
    def SaveFile(self, _parent, title, options, sender=None):
        return self.ask("SaveFile", title, options, sender)


name = dbus.service.BusName("org.freedesktop.portal.Desktop", bus)
portal = Portal(bus, "/org/freedesktop/portal/desktop")
note(method="ready")
GLib.MainLoop().run()
